// SPDX-License-Identifier: MIT
//
// The separation test of theorem N1 (f) (Karciauskas & Peters 2013, Props. 2 and 5). At every point of the leaf let
// -1 <= z_0 < z_1 < .. < z_q <= 1 be the values of the curves. Where r(z_{k-1}) and r(z_k) have opposite signs there is
// a root between them. If there are p such pairs, all roots are real and inside. Otherwise let r_p > 0, and let
// (i) r(1+u) and (-1)^p r(-1-u) be positive for u >= 0: no real root is outside. For p-1 pairs that is all; for p-2 the
// remaining two roots are either real, or conjugate with the product |r_0 / r_p| / (product of the other moduli).
#include "proofs/checker/certificate.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

[[noreturn]] void fail(const std::string& why) { throw Rejected{"dominance", why + " (separation test)"}; }

using Coefficients = std::vector<mpz_class>;

bool is_nonnegative(const Coefficients& p) {
  return std::all_of(p.begin(), p.end(), [](const mpz_class& c) { return c >= 0; });
}
Coefficients difference(Coefficients p, const Coefficients& q) {
  for (std::size_t i = 0; i < p.size(); ++i) p[i] -= q[i];
  return p;
}

/// sum_s r_s z^s one^{p-s}, whose sign is that of r(z / one).
Coefficients value_on_curve(const Bernstein& r, const Bernstein& z, const Bernstein& one, std::vector<int>& degrees) {
  const std::size_t p = r.count() - 1;
  Bernstein sum = r.polynomial(p), power_of_one{std::vector<int>(z.degrees.size(), 0), {1}};
  for (std::size_t s = p; s-- > 0;) {
    power_of_one = convolve(power_of_one, one);
    sum = convolve(sum, z);
    const Bernstein term = convolve(r.polynomial(s), power_of_one);
    for (std::size_t i = 0; i < term.coefficients.size(); ++i) sum.coefficients[i] += term.coefficients[i];
  }
  degrees = sum.degrees;
  return sum.coefficients;
}

/// (i) for real roots >= 1 (side 1) or <= -1 (side -1).
void prove_no_real_root_outside(const Bernstein& r, const Region& box, int side) {
  const std::size_t size = r.size(), p = r.count() - 1;
  for (std::size_t j = 0; j <= p; ++j) {  // the coefficient of u^j
    Coefficients sum(size);
    for (std::size_t s = j; s <= p; ++s) {
      mpz_class binomial;
      mpz_bin_uiui(binomial.get_mpz_t(), s, j);
      if (side < 0 && (p - s) % 2 != 0) binomial = -binomial;
      for (std::size_t i = 0; i < size; ++i) sum[i] += binomial * r.coefficients[s * size + i];
    }
    if (!(j == 0 ? is_positive(sum, r.degrees, box) : is_nonnegative(sum)))
      fail(std::string("that no real root is ") + (side > 0 ? ">= 2^-m" : "<= -2^-m") + " is not proved");
  }
}

}  // namespace

void prove_separation(const Bernstein& r, int order, const Dominance& leaf, Budget& budget) {
  const std::size_t size = r.size(), p = r.count() - 1, curves = leaf.curves.size();
  const mpz_class scale = mpz_class(1) << static_cast<unsigned long>(order);  // z = 2^m lambda
  std::vector<Polynomial> family;
  for (const auto& curve : leaf.curves) family.push_back(multiply(curve, constant(scale), budget));
  family.push_back(constant(1));
  Region box;
  const Bernstein z = on_region(std::move(family), leaf.region, box, budget);
  const Bernstein one = z.polynomial(curves);
  const double z_size = tensor_size(z.degrees, 1), limbs_z = limbs(z), limbs_r = limbs(r);
  std::vector<int> greatest = r.degrees;
  for (std::size_t k = 0; k < greatest.size(); ++k) greatest[k] += static_cast<int>(p) * z.degrees[k];
  const double entries = tensor_size(greatest, 1), length = limbs_r + static_cast<double>(p) * (limbs_z + 1);
  budget.work(static_cast<double>(curves + 1) * static_cast<double>(p) * 3 * entries * z_size * cost(length, limbs_z));
  budget.work(static_cast<double>(p * p * size) * 2 * cost(limbs_r, 2));
  budget.hold(4 * entries * (32 + 8 * length));

  std::vector<std::size_t> pairs;  // k: a root between the curves k-1 and k
  int before = 0;
  for (std::size_t k = 0; k < curves; ++k) {
    const Bernstein own = z.polynomial(k);
    if (k > 0 && !is_positive(difference(own.coefficients, z.polynomial(k - 1).coefficients), z.degrees, box))
      fail("the curves are not proved to be in order");
    std::vector<int> degrees;
    Coefficients value = value_on_curve(r, own, one, degrees);
    int sign = is_positive(value, degrees, box) ? 1 : -1;
    for (auto& c : value) c = -c;
    if (sign < 0 && !is_positive(value, degrees, box))
      fail("the factor has no proved strict sign on curve " + std::to_string(k + 1));
    if (k > 0 && sign != before) pairs.push_back(k);
    before = sign;
  }
  if (curves > 0) {
    Coefficients above_minus_one = z.polynomial(0).coefficients;
    for (std::size_t i = 0; i < above_minus_one.size(); ++i) above_minus_one[i] += one.coefficients[i];
    if (!is_nonnegative(above_minus_one) ||
        !is_nonnegative(difference(one.coefficients, z.polynomial(curves - 1).coefficients)))
      fail("the curves are not proved to be within 2^-m");
  }
  const bool conjugate = pairs.size() + 2 == p;
  if (leaf.distances.size() != (conjugate ? pairs.size() : 0)) fail("the proof has a wrong number of distances");
  if (pairs.size() == p) return;
  if (pairs.size() + 1 != p && !conjugate) fail("the curves separate too few roots");
  const Coefficients leading = r.polynomial(p).coefficients;
  if (!is_positive(leading, r.degrees, box)) fail("the leading coefficient is not proved positive");
  prove_no_real_root_outside(r, box, 1);
  prove_no_real_root_outside(r, box, -1);
  if (!conjugate) return;

  // |r_0| < r_p prod kappa on the closed leaf, kappa lower bounds for the moduli of the separated roots.
  mpq_class bound = 1;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const mpq_class kappa = leaf.distances[k] * scale;
    budget.work(500 + 4 * limbs(bound) * limbs(kappa) + z_size * cost(limbs_z, limbs(kappa)));
    if (kappa <= 0) fail("a distance is not positive");
    const auto beyond = [&](std::size_t curve, int side) {  // side z >= kappa
      const Bernstein own = z.polynomial(curve);
      for (std::size_t i = 0; i < own.coefficients.size(); ++i)
        if (side * own.coefficients[i] * kappa.get_den() < kappa.get_num() * one.coefficients[i]) return false;
      return true;
    };
    if (!beyond(pairs[k] - 1, 1) && !beyond(pairs[k], -1)) fail("a root is not proved to keep its distance from 0");
    bound *= kappa;
  }
  budget.work(static_cast<double>(size) * 2 * cost(limbs_r, limbs(bound)));
  for (std::size_t i = 0; i < size; ++i)
    if (abs(r.coefficients[i]) * bound.get_den() >= leading[i] * bound.get_num())
      fail("that a pair of conjugate roots is inside is not proved");
}

}  // namespace limes::checker
