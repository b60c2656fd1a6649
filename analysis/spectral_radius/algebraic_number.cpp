#include "analysis/spectral_radius/algebraic_number.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/factorisation.hpp"
#include "algebra/polynomial/real_roots.hpp"
#include "analysis/spectral_radius/exact_vectors_impl.hpp"

#include <cmath>

namespace limes {
namespace {

/// The factor of `a` with exactly one root in (lower, upper], if it is the only such factor.
std::optional<Polynomial> factor_with_root(const Polynomial& a, const Rational& lower, const Rational& upper) {
  std::optional<Polynomial> result;
  for (const auto& [factor, multiplicity] : irreducible_factors(a)) {
    const int count = count_real_roots(factor, lower, upper);
    if (count > 1 || (count == 1 && result)) return std::nullopt;
    if (count == 1) result = factor;
  }
  return result;
}

}  // namespace

AlgebraicNumber refined(AlgebraicNumber x, int bits) {
  if (x.is_rational()) {
    x.lower = x.upper = -x.polynomial.coefficient(0);
    return x;
  }
  const Rational width = Rational(1, Integer(1) << unsigned(bits));
  // Irreducible of degree > 1: no rational is a root.
  const bool rising = x.polynomial(x.upper) > 0;
  while (x.upper - x.lower > width) {
    const Rational middle = (x.lower + x.upper) / 2;
    ((x.polynomial(middle) > 0) == rising ? x.upper : x.lower) = middle;
  }
  return x;
}

std::optional<AlgebraicNumber> algebraic_root(const Polynomial& chi, double value, int root) {
  const double tolerance = 1e-6 * std::abs(value);
  if (!std::isfinite(value) || tolerance == 0) return std::nullopt;
  const std::optional<Polynomial> f = factor_with_root(chi, Rational(value - tolerance), Rational(value + tolerance));
  if (!f || f->degree() * root > 64) return std::nullopt;
  const double alpha = std::pow(std::abs(value), 1.0 / root);
  const Rational lower = Rational(alpha * (1 - 2e-6)), upper = Rational(alpha * (1 + 2e-6));
  const Polynomial powers = compose(*f, Polynomial::monomial(value > 0 ? 1 : -1, root));
  const std::optional<Polynomial> minimal = factor_with_root(powers, lower, upper);
  if (!minimal) return std::nullopt;
  return refined({*minimal, lower, upper}, 64);
}

NumberField::NumberField(AlgebraicNumber alpha) : alpha_(std::move(alpha)) {
  const Polynomial& m = alpha_.polynomial;
  if (m.degree() < 1 || m.coefficient(0) == 0) throw DomainError("NumberField: alpha is zero, or no number");
  // m = m_0 + x q gives 1/alpha = -q(alpha) / m_0.
  inverse_ = Rational(-1 / m.coefficient(0)) * divide(m, Polynomial::monomial(1, 1)).first;
}

Polynomial NumberField::times_power(const Polynomial& p, int k) const {
  Polynomial result = p;
  const Polynomial factor = k < 0 ? inverse_ : Polynomial::monomial(1, 1);
  for (int i = 0; i < std::abs(k); ++i) result = reduced(result * factor);
  return result;
}

NumberField::Enclosure NumberField::enclose(const Polynomial& p, int bits) const {
  const Rational unit = Rational(1, Integer(1) << unsigned(bits));
  const Rational greatest = std::max(abs(alpha_.lower), abs(alpha_.upper));
  // |p(x) - p(y)| <= |x - y| sum_i i |p_i| greatest^{i-1}.
  Rational slope = 0, power = 1;
  for (int i = 1; i <= p.degree(); ++i, power *= greatest) slope += i * abs(p.coefficient(i)) * power;
  constexpr int most_bits = 1024;
  for (int own = 2 * bits; (alpha_.upper - alpha_.lower) * slope > unit && own <= most_bits; own *= 2) alpha_ = refined(std::move(alpha_), own);
  const Rational middle = (alpha_.lower + alpha_.upper) / 2;
  return {round_to_bits(p(middle), bits), (alpha_.upper - alpha_.lower) / 2 * slope + unit};
}

}  // namespace limes
