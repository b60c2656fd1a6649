#include "analysis/surface/cosine_field.hpp"

#include "algebra/error.hpp"

#include <algorithm>
#include <numeric>

namespace limes {
namespace {

Polynomial reduced(const Polynomial& a, const Polynomial& minimal) { return a.degree() < minimal.degree() ? a : divide(a, minimal).second; }

Polynomial inverse(const Polynomial& a, const Polynomial& minimal) {
  Polynomial r0 = minimal, r1 = a, t0, t1 = Polynomial::constant(1);
  while (r1.degree() > 0) {
    auto [quotient, remainder] = divide(r0, r1);
    r0 = std::exchange(r1, std::move(remainder));
    Polynomial t = t0 - quotient * t1;
    t0 = std::exchange(t1, std::move(t));
  }
  if (r1.is_zero()) throw DomainError("division by zero in a field of cosines");
  return reduced(Rational(1) / r1.coefficient(0) * t1, minimal);
}

void normalise(CosinePolynomial& a, const Polynomial& minimal) {
  for (Polynomial& c : a) c = reduced(c, minimal);
  while (!a.empty() && a.back().is_zero()) a.pop_back();
}

CosinePolynomial monic(CosinePolynomial a, const Polynomial& minimal) {
  normalise(a, minimal);
  if (a.empty()) return a;
  const Polynomial factor = inverse(a.back(), minimal);
  for (Polynomial& c : a) c = reduced(c * factor, minimal);
  return a;
}

/// {quotient, remainder}. \pre b monic
std::pair<CosinePolynomial, CosinePolynomial> divided(CosinePolynomial a, const CosinePolynomial& b, const Polynomial& minimal) {
  CosinePolynomial quotient(a.size() >= b.size() ? a.size() - b.size() + 1 : 0);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = reduced(a[k + b.size() - 1], minimal);
    for (std::size_t i = 0; i < b.size(); ++i) a[k + i] -= reduced(quotient[k] * b[i], minimal);
  }
  normalise(a, minimal);
  return {std::move(quotient), std::move(a)};
}

CosinePolynomial greatest_common_divisor(CosinePolynomial a, CosinePolynomial b, const Polynomial& minimal) {
  a = monic(std::move(a), minimal);
  b = monic(std::move(b), minimal);
  while (!b.empty()) {
    CosinePolynomial remainder = divided(std::move(a), b, minimal).second;
    a = std::exchange(b, monic(std::move(remainder), minimal));
  }
  return a;
}

CosinePolynomial derivative(const CosinePolynomial& a) {
  CosinePolynomial result;
  for (std::size_t k = 1; k < a.size(); ++k) result.push_back(Rational(int(k)) * a[k]);
  return result;
}

}  // namespace

Polynomial minimal_polynomial_of_cosine(int n, int j) {
  const int order = n / std::gcd(n, std::abs(j));
  if (order <= 2) return Polynomial({order == 1 ? -1 : 1, 1});
  // z^{-d} Phi(z) = phi_d + sum_{i >= 1} phi_{d+i} (z^i + z^{-i}) with z = e^{2 pi i/order}, degree 2 d: 2 T_i(c) for each i.
  const Polynomial phi = cyclotomic(order), c = Polynomial::monomial(1, 1);
  const int d = phi.degree() / 2;
  Polynomial sum = Polynomial::constant(phi.coefficient(d)), before = Polynomial::constant(1), chebyshev = c;
  for (int i = 1; i <= d; ++i) {
    sum += Rational(2) * phi.coefficient(d + i) * chebyshev;
    Polynomial after = Rational(2) * c * chebyshev - before;
    before = std::exchange(chebyshev, std::move(after));
  }
  return Rational(1) / sum.leading_coefficient() * sum;
}

CosinePolynomial multiply(const CosinePolynomial& a, const CosinePolynomial& b, const Polynomial& minimal) {
  if (a.empty() || b.empty()) return {};
  CosinePolynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] += a[i] * b[k];
  }
  normalise(product, minimal);
  return product;
}

std::vector<std::pair<CosinePolynomial, int>> square_free_factorisation(const CosinePolynomial& a, const Polynomial& minimal) {
  std::vector<std::pair<CosinePolynomial, int>> parts;
  CosinePolynomial repeated = greatest_common_divisor(a, derivative(a), minimal);
  CosinePolynomial rest = divided(monic(a, minimal), repeated, minimal).first;
  for (int multiplicity = 1; rest.size() > 1; ++multiplicity) {
    CosinePolynomial more = greatest_common_divisor(rest, repeated, minimal);
    CosinePolynomial part = divided(rest, more, minimal).first;
    if (part.size() > 1) parts.emplace_back(std::move(part), multiplicity);
    repeated = divided(repeated, more, minimal).first;
    rest = std::move(more);
  }
  return parts;
}

}  // namespace limes
