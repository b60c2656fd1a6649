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
  budget.hold((fresh ? 150 : 0) + 8 * added);
  term->second += x * y;
  if (term->second == 0) p.erase(term);
}

}  // namespace

Polynomial constant(const mpq_class& value) { return value == 0 ? Polynomial{} : Polynomial{{Exponents{}, value}}; }

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
      for (std::size_t k = 0; k < max_parameters; ++k) {
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

}  // namespace limes::checker
