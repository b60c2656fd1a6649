// SPDX-License-Identifier: MIT
#include "proofs/checker/polynomial.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

/// p += x y z^exponents, paid for before it is done.
void accumulate(Polynomial& p, const Exponents& exponents, const mpq_class& x, const mpq_class& y, Budget& budget) {
  const auto [term, fresh] = p.try_emplace(exponents);
  const double added = limbs(x) + limbs(y), size = limbs(term->second) + added;
  budget.work(300 + 4 * size * size);
  budget.hold((fresh ? 180 : 0) + 8 * added);
  term->second += x * y;
  if (term->second == 0) p.erase(term);
}

}  // namespace

Polynomial constant(const mpq_class& value) { return value == 0 ? Polynomial{} : Polynomial{{Exponents{}, value}}; }

Polynomial variable(std::size_t index) {
  Exponents exponents{};
  exponents.at(index) = 1;
  return {{exponents, 1}};
}

int degree(const Polynomial& p, std::size_t parameter) {
  int result = 0;
  for (const auto& [exponents, c] : p) result = std::max<int>(result, exponents[parameter]);
  return result;
}

Polynomial add(Polynomial p, const Polynomial& q, Budget& budget) {
  for (const auto& [exponents, c] : q) accumulate(p, exponents, c, 1, budget);
  return p;
}

Polynomial multiply(const Polynomial& p, const Polynomial& q, Budget& budget) {
  Polynomial result;
  for (const auto& [e, x] : p) {
    for (const auto& [f, y] : q) {
      Exponents sum{};
      for (std::size_t k = 0; k < max_variables; ++k) {
        if (e[k] + f[k] > 1000) throw Rejected{"limits", "a polynomial has a degree above 1000"};
        sum[k] = static_cast<std::uint16_t>(e[k] + f[k]);
      }
      accumulate(result, sum, x, y, budget);
    }
  }
  return result;
}

Polynomial substitute(const Polynomial& p, std::size_t parameter, const mpq_class& value, Budget& budget) {
  std::vector<mpq_class> powers{1};
  for (int k = degree(p, parameter); k > 0; --k) {
    const double size = limbs(powers.back()) + limbs(value);
    budget.work(100 + 4 * size * size);
    powers.push_back(powers.back() * value);
  }
  Polynomial result;
  for (const auto& [exponents, c] : p) {
    Exponents others = exponents;
    others[parameter] = 0;
    accumulate(result, others, c, powers[exponents[parameter]], budget);
  }
  return result;
}

Fraction sum(Fraction x, Fraction y, Budget& budget) {
  if (x.denominator != y.denominator) {
    x.numerator = multiply(x.numerator, y.denominator, budget);
    y.numerator = multiply(y.numerator, x.denominator, budget);
    x.denominator = multiply(x.denominator, y.denominator, budget);
  }
  x.numerator = add(std::move(x.numerator), y.numerator, budget);
  return x;
}

Fraction product(const Fraction& x, const Fraction& y, Budget& budget) {
  return {multiply(x.numerator, y.numerator, budget), multiply(x.denominator, y.denominator, budget)};
}

Fraction quotient(const Fraction& x, const Fraction& y, Budget& budget) {
  // 1 / (P / Q) = Q^2 / (P Q): what Q excludes stays excluded. The leading coefficient moves to the numerator.
  const Polynomial scale = constant(1 / mpq_class(y.numerator.rbegin()->second));
  const auto times = [&](const Polynomial& p, const Polynomial& q) { return multiply(p, q, budget); };
  return product(
      x, {times(times(y.denominator, y.denominator), scale), times(times(y.numerator, y.denominator), scale)}, budget);
}

Fraction power(const Fraction& x, int exponent, Budget& budget) {
  if (exponent == 0) return {x.denominator, x.denominator};  // 1 where the base has a value
  Fraction result = x;
  for (int n = 1; n < exponent; ++n) result = product(result, x, budget);
  return result;
}

}  // namespace limes::checker
