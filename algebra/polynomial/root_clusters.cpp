#include "algebra/polynomial/root_clusters.hpp"

#include "algebra/error.hpp"
#include "algebra/number/arb_conversion.hpp"
#include "algebra/number/flint_conversion.hpp"

#include <acb_poly.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace limes {
namespace {

void set_interval(arb_t out, const Interval& x, slong bits) {
  const FlintRational lower(x.lower), upper(x.upper);
  arb_set_fmpq(out, lower.data, bits);
  if (x.is_point()) return;
  RealBall end;
  arb_set_fmpq(end.data, upper.data, bits);
  arb_union(out, out, end.data, bits);
}

/// The coefficients as balls.
void evaluate(const Balls& out, const std::vector<MultivariatePolynomial>& coefficients, const Box& box, slong bits) {
  const std::size_t n = box.size();
  std::vector<int> degrees(n, 0);
  for (const MultivariatePolynomial& c : coefficients) {
    const std::vector<int> d = c.degrees();
    for (std::size_t i = 0; i < n; ++i) degrees[i] = std::max(degrees[i], d[i]);
  }
  std::vector<std::vector<RealBall>> powers;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<RealBall>& p = powers.emplace_back(std::size_t(degrees[i]) + 1);
    arb_one(p[0].data);
    if (degrees[i] > 0) set_interval(p[1].data, box[i], bits);
    for (int e = 2; e <= degrees[i]; ++e) arb_pow_ui(p[std::size_t(e)].data, p[1].data, ulong(e), bits);
  }
  RealBall product;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    for (const MultivariatePolynomial::Term& term : coefficients[k].terms()) {
      const FlintRational c(term.coefficient);
      arb_set_fmpq(product.data, c.data, bits);
      for (std::size_t i = 0; i < n; ++i) {
        if (term.exponents[i] > 0) arb_mul(product.data, product.data, powers[i][std::size_t(term.exponents[i])].data, bits);
      }
      arb_add(acb_realref(out[k]), acb_realref(out[k]), product.data, bits);
    }
  }
}

/// Approximate roots, pairwise different, without error bounds.
void approx_roots(const Balls& roots, const Balls& monic, slong degree, slong bits) {
  acb_poly_t p;
  acb_poly_init2(p, degree + 1);
  const Balls middle(1);
  for (slong k = 0; k <= degree; ++k) {
    acb_get_mid(middle[0], monic[std::size_t(k)]);
    acb_poly_set_coeff_acb(p, k, middle[0]);
  }
  acb_poly_find_roots(roots.data(), p, nullptr, 0, bits);
  acb_poly_clear(p);
  for (slong i = 0; i < degree; ++i) {
    acb_get_mid(roots[std::size_t(i)], roots[std::size_t(i)]);
    for (slong k = 0; k < i; ++k) {
      // Any other point will do.
      if (acb_eq(roots[std::size_t(i)], roots[std::size_t(k)])) {
        acb_t shift;
        acb_init(shift);
        acb_set_si(shift, i + 1);
        acb_mul_2exp_si(shift, shift, -bits / 2);
        acb_add(roots[std::size_t(i)], roots[std::size_t(i)], shift, 2 * bits);
        acb_clear(shift);
      }
    }
  }
}

/// Squares around the discs, around a real centre when the imaginary part is not certain. The results are about their sizes.
std::vector<double> discs_around(const Balls& discs, const Balls& monic, const Balls& roots, slong bits) {
  const std::size_t degree = discs.count();
  std::vector<double> sizes;
  acb_t value, factor;
  acb_init(value);
  acb_init(factor);
  mag_t bound;
  mag_init(bound);
  RealBall radius;
  for (std::size_t i = 0; i < degree; ++i) {
    _acb_poly_evaluate(value, monic.data(), slong(degree + 1), roots[i], bits);
    for (std::size_t k = 0; k < degree; ++k) {
      if (k == i) continue;
      acb_sub(factor, roots[i], roots[k], 2 * bits);
      acb_div(value, value, factor, bits);
    }
    acb_abs(radius.data, value, bits);
    arb_mul_ui(radius.data, radius.data, degree, bits);
    arb_get_mag(bound, radius.data);
    sizes.push_back(mag_get_d(bound));
    acb_set(discs[i], roots[i]);
    acb_add_error_mag(discs[i], bound);
    if (!arb_contains_zero(acb_imagref(discs[i]))) continue;
    // The disc around the real part that contains this one and its mirror image.
    arb_get_mag(bound, acb_imagref(discs[i]));
    arb_add_error_mag(acb_realref(discs[i]), bound);
    arb_zero(acb_imagref(discs[i]));
    arb_add_error_mag(acb_imagref(discs[i]), bound);
  }
  mag_clear(bound);
  acb_clear(value);
  acb_clear(factor);
  return sizes;
}

/// Points that have others within 2^-exponent are moved apart, onto circles of that radius; all others stay.
void spread(const Balls& out, const Balls& roots, std::size_t degree, slong exponent) {
  const double reach = std::ldexp(1., int(-exponent));
  const auto part = [](const arb_t x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); };
  for (std::size_t i = 0; i < degree; ++i) {
    bool crowded = false;
    for (std::size_t k = 0; k < degree; ++k) {
      const double x = part(acb_realref(roots[i])) - part(acb_realref(roots[k])), y = part(acb_imagref(roots[i])) - part(acb_imagref(roots[k]));
      crowded = crowded || (k != i && std::hypot(x, y) < 2 * reach);
    }
    acb_set(out[i], roots[i]);
    if (!crowded) continue;
    const double angle = 2 * std::numbers::pi * (double(i) + 0.25) / double(degree);
    acb_set_d_d(out[i], part(acb_realref(roots[i])) + reach * std::cos(angle), part(acb_imagref(roots[i])) + reach * std::sin(angle));
  }
}

}  // namespace

std::vector<RootCluster> enclose_root_clusters(const std::vector<MultivariatePolynomial>& coefficients, const Box& box, int bits) {
  clean_up_flint_at_thread_exit();
  const std::size_t degree = coefficients.size() - 1;
  std::vector<RootCluster> clusters;
  if (degree == 0) return clusters;
  Balls monic(degree + 1);
  evaluate(monic, coefficients, box, bits);
  if (acb_contains_zero(monic[degree])) throw DomainError("root clusters: the leading coefficient may vanish");
  for (std::size_t k = 0; k < degree; ++k) acb_div(monic[k], monic[k], monic[degree], bits);
  acb_one(monic[degree]);
  Balls roots(degree), discs(degree);
  approx_roots(roots, monic, slong(degree), bits);

  std::vector<double> sizes = discs_around(discs, monic, roots, bits);
  // Where roots are closer than the coefficients tell, approximations that lie further apart give smaller discs.
  if (!std::all_of(box.begin(), box.end(), [](const Interval& x) { return x.is_point(); })) {
    Balls other_roots(degree), other_discs(degree);
    for (int exponent = 30; exponent > 1; --exponent) {
      spread(other_roots, roots, degree, exponent);
      std::vector<double> other = discs_around(other_discs, monic, other_roots, bits);
      if (std::accumulate(other.begin(), other.end(), 0.) >= std::accumulate(sizes.begin(), sizes.end(), 0.)) continue;
      sizes = std::move(other);
      for (std::size_t i = 0; i < degree; ++i) acb_set(discs[i], other_discs[i]);
    }
  }

  RealBall size;
  // Join what overlaps, until all are disjoint.
  std::vector<int> counts(degree, 1);
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t i = 0; i < degree; ++i) {
      for (std::size_t k = 0; counts[i] > 0 && k < i; ++k) {
        if (counts[k] == 0 || !acb_overlaps(discs[i], discs[k])) continue;
        acb_union(discs[k], discs[k], discs[i], bits);
        counts[k] += std::exchange(counts[i], 0);
        joined = true;
      }
    }
  }
  for (std::size_t i = 0; i < degree; ++i) {
    if (counts[i] == 0) continue;
    const bool is_real = counts[i] == 1 && arb_contains_zero(acb_imagref(discs[i]));
    if (is_real) arb_zero(acb_imagref(discs[i]));
    acb_abs(size.data, discs[i], bits);
    RootCluster cluster{enclosure(acb_realref(discs[i])), enclosure(acb_imagref(discs[i])), enclosure(size.data), counts[i]};
    cluster.modulus.lower = std::max(cluster.modulus.lower, Rational(0));
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

}  // namespace limes
