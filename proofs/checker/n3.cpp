// SPDX-License-Identifier: MIT
//
// Theorem N3: let chi be the characteristic polynomial of L(gamma) at one gamma > 0; divide out (lambda - 2^{-k}) once
// for those k = 0..m for which it divides. A root of the rest that is not less than 2^{-m} belongs to an eigenvector,
// to a second one of an eigenvalue 2^{-k}, or to a Jordan chain; so does 2^{-k} when t^k is no eigenvector to it. Since the scheme is interpolatory, this is the values
// at the knots of a limit f with f(t/2) = lambda f(t) (+ c t^k), which no Taylor polynomial of degree m with a rest
// o(t^m) allows. On a leaf each (lambda - 2^{-k}) divides everywhere or nowhere, so that there is one rest.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/modular.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

/// A positive multiple of chi as a polynomial in lambda, on the closure of a leaf.
struct Characteristic {
  Region box;
  Bernstein coefficients;
};

/// Whether a polynomial has a strict sign on the leaf, and which.
int strict_sign(std::vector<mpz_class> p, const std::vector<int>& degrees, const Region& box) {
  if (is_positive(p, degrees, box)) return 1;
  for (auto& c : p) c = -c;
  return is_positive(p, degrees, box) ? -1 : 0;
}

/// det(lambda D - D L) with the product D of the rows' denominators has integer coefficients. With x for t / (1-t), it
/// is that of a matrix of polynomials in x whose coefficients are the scaled Bernstein coefficients: from its values
/// modulo enough numbers at x = 1, 2, .., inside of the leaf.
Characteristic characteristic(const std::vector<Stencil>& rows, const Region& region, Budget& budget) {
  const std::size_t points = rows.size(), n = 2 * points - 1;
  Characteristic result;
  std::vector<Dense> polynomials;  // of every row D, D e_1, .., D e_2n
  mpz_class bound = 1;
  Bernstein leading;
  for (const auto& row : rows) {
    std::vector<Polynomial> family{row.denominator};
    family.insert(family.end(), row.numerators.begin(), row.numerators.end());
    Region box;
    const Bernstein local = on_region(std::move(family), region, box, budget);
    budget.work(static_cast<double>(local.coefficients.size()) * (500 + 10 * limbs(local)));
    mpz_class sum = 0;
    for (std::size_t k = 0; k <= points; ++k) {
      polynomials.push_back({local.degrees, local.polynomial(k).coefficients});
      sum += norm(polynomials.back());
    }
    budget.work(8 * limbs(bound) * limbs(sum));
    bound *= 2 * sum;
    if (leading.coefficients.empty()) leading = {std::vector<int>(box.size(), 0), {1}};
    budget.work(static_cast<double>(leading.size() * local.size()) * cost(limbs(leading), limbs(local)));
    leading = convolve(leading, local.polynomial(0));
    result.box = std::move(box);
  }
  const int sign = strict_sign(leading.coefficients, leading.degrees, result.box);
  if (sign == 0) throw Rejected{"denominator", "the denominators of the rule have no proven strict sign"};

  std::vector<int> counts;
  for (const int d : leading.degrees) counts.push_back(d + 1);
  const double bits = static_cast<double>(mpz_sizeinbase(bound.get_mpz_t(), 2)) + 2, size = static_cast<double>(n),
               places = tensor_size(leading.degrees, 1);
  double sweep = 0;
  for (const int count : counts) sweep += 8. * count;
  budget.hold(places * (size + 1) * (bits / 4 + 64));
  budget.work(moduli_for(bits) *
              (visit_cost(polynomials, counts) + 1e5 +
               places * (charpoly_cost(size) + 500 * size + 30 * size * size + (size + 1) * (sweep + 100 + bits / 8))));
  const std::size_t grid = leading.size();
  Reconstruction reconstruction((n + 1) * grid, bound + 1);
  for (mpz_class q = next_modulus(); !reconstruction.is_complete(); q = next_modulus(q)) {
    const Modulus f(q);
    std::vector<std::vector<Residue>> values(n + 1);  // of the coefficients of lambda^s, at the points
    const bool done = for_each_point(f, polynomials, counts, 1, [&](const std::vector<Residue>& at_point) {
      std::vector<Residue> matrix(n * n, 0);
      Residue scale = f.one();
      const Residue* value = at_point.data();
      for (std::size_t k = 0; k < points; ++k) {
        const Residue inverse = f.inverse(*value);
        if (inverse == 0) return false;
        scale = f.times(scale, *value++);
        for (std::size_t j = 0; j < points; ++j) matrix[2 * k * n + k + j] = f.times(*value++, inverse);
        if (k > 0) matrix[(2 * k - 1) * n + points / 2 - 1 + k] = f.one();
      }
      const std::vector<Residue> chi = characteristic_polynomial(f, std::move(matrix), n);
      for (std::size_t s = 0; s < chi.size(); ++s) values[s].push_back(f.times(chi[s], scale));
      return !chi.empty();
    });
    std::vector<Residue> all;
    bool interpolated = done;
    for (auto& own : values) {
      interpolated = interpolated && interpolate(f, own, counts, 1);
      all.insert(all.end(), own.begin(), own.end());
    }
    if (interpolated) reconstruction.add(f, all);
  }
  result.coefficients = {leading.degrees, reconstruction.result()};
  if (sign < 0)
    for (auto& c : result.coefficients.coefficients) c = -c;
  return result;
}

/// 2^{k deg} rest(side 2^{-k}), times side^deg: if it is <= 0, a real root of the rest is not less than 2^{-k}.
std::vector<mpz_class> value_at(const Bernstein& rest, unsigned long k, int side) {
  const std::size_t size = rest.size(), p = rest.count() - 1;
  std::vector<mpz_class> result(size);
  for (std::size_t s = 0; s <= p; ++s)
    for (std::size_t i = 0; i < size; ++i) {
      const mpz_class term = rest.coefficients[s * size + i] << (k * (p - s));
      if (side > 0 || (p - s) % 2 == 0)
        result[i] += term;
      else
        result[i] -= term;
    }
  return result;
}

/// Whether t^k is nowhere on the leaf an eigenvector to 2^{-k}: for the new point at t_r / 2, r odd, sum_j e_j t_j^k differs from
/// (t_r / 2)^k.
bool lacks_power(const Rule& rule, const std::vector<Stencil>& rows, unsigned long k, const Region& region, Budget& budget) {
  const int n = rule.points / 2;
  const auto power_of_knot = [&](int j) {
    Polynomial power = constant(1);
    const Polynomial knot = multiply(constant(j), j > 0 ? variable(rule.gamma) : constant(1), budget);
    for (unsigned long i = 0; i < k; ++i) power = multiply(power, knot, budget);
    return power;
  };
  for (int i = 0; i < 2 * n; ++i) {
    const Stencil& row = rows[static_cast<std::size_t>(i)];
    // Row i is that of the knot number 2i + 1 - 2n, and begins at the knot number i + 1 - 2n.
    Polynomial defect = multiply(row.denominator, multiply(constant(-1), power_of_knot(2 * i + 1 - 2 * n), budget), budget);
    for (int j = 0; j < 2 * n; ++j) {
      const Polynomial scaled = multiply(constant(mpz_class(1) << k), power_of_knot(i + j + 1 - 2 * n), budget);
      defect = add(std::move(defect), multiply(row.numerators[static_cast<std::size_t>(j)], scaled, budget), budget);
    }
    Region box;
    const Bernstein local = on_region({std::move(defect)}, region, box, budget);
    if (strict_sign(local.coefficients, local.degrees, box) != 0) return true;
  }
  return false;
}

}  // namespace

void prove_n3(const Certificate& certificate, const Leaf& leaf, Budget& budget) {
  budget.start_leaf();
  Region box, region = leaf.region;
  const Bernstein denominator = on_region({certificate.scheme.denominator}, region, box, budget);  // with all divisors
  if (strict_sign(denominator.coefficients, denominator.degrees, box) == 0)
    throw Rejected{"denominator", "a denominator of the rule has no proven strict sign"};
  region.push_back({{leaf.gamma, false}, {leaf.gamma, true}, ""});
  const std::vector<Stencil> rows = matrix_rows(*certificate.rule, region, budget);
  Characteristic made = characteristic(rows, region, budget);
  box = std::move(made.box);
  Bernstein rest = std::move(made.coefficients);
  const std::size_t size = rest.size();
  const auto order = static_cast<unsigned long>(certificate.order);
  const double entries = static_cast<double>(rest.coefficients.size()), length = limbs(rest) + 64 * 64;
  budget.work(static_cast<double>(order + 1) * entries * 6 * cost(length, 1));
  for (unsigned long k = 0; k <= order; ++k) {
    // rest = (2^k lambda - 1) quotient, from the constant term on; what remains is the value at 2^{-k}, times a power
    // of 2 and -1.
    Bernstein quotient{rest.degrees, {}};
    std::vector<mpz_class> before(size);
    for (std::size_t s = 0; s < rest.count(); ++s)
      for (std::size_t i = 0; i < size; ++i) {
        before[i] = (before[i] << k) - rest.coefficients[s * size + i];
        quotient.coefficients.push_back(before[i]);
      }
    const bool divides = std::all_of(before.begin(), before.end(), [](const mpz_class& c) { return c == 0; });
    if (!divides && strict_sign(before, rest.degrees, box) == 0)
      throw Rejected{"eigenvalue", "that 2^-" + std::to_string(k) + " is an eigenvalue everywhere or nowhere on the " +
                                       "leaf is not proved"};
    if (!divides) continue;
    if (lacks_power(*certificate.rule, rows, k, region, budget)) return;
    quotient.coefficients.resize(quotient.coefficients.size() - size);
    rest = std::move(quotient);
  }
  if (box.empty()) {
    for (std::size_t s = 0; s < rest.count(); ++s) rest.coefficients[s] <<= order * (rest.count() - 1 - s);
    if (all_roots_inside(rest.coefficients, budget))
      throw Rejected{"eigenvalue", "all other eigenvalues of L are less than 2^-m at this point"};
    return;
  }
  for (unsigned long k = 0; k <= order; ++k)
    for (const int side : {1, -1}) {
      const std::vector<mpz_class> value = value_at(rest, k, side);
      if (std::all_of(value.begin(), value.end(), [](const mpz_class& c) { return c <= 0; })) return;
    }
  // With all roots inside, r_p^{p-1} prod_{i<j} (1 - z_i z_j) would be positive.
  for (std::size_t s = 0; s < rest.count(); ++s)
    for (std::size_t i = 0; i < size; ++i) rest.coefficients[s * size + i] <<= order * (rest.count() - 1 - s);
  if (rest.count() > 2) {
    const Bernstein determinant = boundary_determinant(rest, budget);
    if (std::all_of(determinant.coefficients.begin(), determinant.coefficients.end(),
                    [](const mpz_class& c) { return c <= 0; }))
      return;
  }
  throw Rejected{"eigenvalue", "no other eigenvalue of L is proved to have a modulus of 2^-m or more on the leaf"};
}

}  // namespace limes::checker
