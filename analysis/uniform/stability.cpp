#include "analysis/uniform/stability.hpp"

#include "algebra/polynomial/polynomial.hpp"

namespace limes {
namespace {

int euler_phi(int n) {
  int result = n;
  for (int q = 2; q * q <= n; ++q) {
    if (n % q != 0) continue;
    result -= result / q;
    while (n % q == 0) n /= q;
  }
  return n > 1 ? result - result / n : result;
}

bool shifts_are_linearly_independent(const LaurentPolynomial& a) {
  constexpr int max_length = 128;
  if (a.length() > max_length) return false;
  const Polynomial p(a.rational_coefficients());
  if (p(1) != 2) return false;
  const Polynomial alternated = compose(p, Polynomial::monomial(-1, 1));
  if (gcd(p, alternated).degree() > 0) return false;
  // a vanishes at one primitive 2k-th root of unity exactly when the 2k-th cyclotomic polynomial divides a; for odd k that is
  // Phi_k(-z), of degree phi(k) >= sqrt(k / 2).
  for (int k = 3; k <= 2 * p.degree() * p.degree(); k += 2) {
    if (euler_phi(k) > p.degree()) continue;
    if (divide(alternated, cyclotomic(k)).second.is_zero()) return false;
  }
  return true;
}

}  // namespace

std::optional<Stability> prove_stability(const Mask& mask) {
  if (interpolatory_index(mask)) return Stability::interpolatory;
  if (mask.arity == 2 && mask.symbol.variables() == 0 && shifts_are_linearly_independent(mask.symbol)) {
    return Stability::linear_independence;
  }
  return std::nullopt;
}

}  // namespace limes
