// SPDX-License-Identifier: MIT
//
// Theorem N1 (f): all roots of f = sum_s d_s lambda^s satisfy |lambda| < rho = 2^{-m} on a leaf. With r(z) = f(rho z),
// a polynomial of degree p in z: all roots of r satisfy |z| < 1. Everything is in scaled Bernstein form on the closure
// of the leaf; the sum of the scaled coefficients is a positive multiple of the value at the leaf's midpoint.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/modular.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

[[noreturn]] void fail(const std::string& why) { throw Rejected{"dominance", why}; }

/// Divides all polynomials by their common power of t_k at an open lower end of axis k, of 1 - t_k at an open upper
/// one: a shift of the indices.
void divide_common_powers(Bernstein& family, const Region& box) {
  const std::size_t axes = family.degrees.size(), size = family.size(), count = family.count();
  std::vector<std::vector<int>> indices{{}};  // of the coefficients of one polynomial
  for (const int n : family.degrees) {
    std::vector<std::vector<int>> next;
    for (const auto& index : indices)
      for (int i = 0; i <= n; ++i) {
        next.push_back(index);
        next.back().push_back(i);
      }
    indices = std::move(next);
  }
  std::vector<int> least = family.degrees, greatest(axes, -1);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t k = 0; k < axes && family.coefficients[j * size + i] != 0; ++k) {
        least[k] = std::min(least[k], indices[i][k]);
        greatest[k] = std::max(greatest[k], indices[i][k]);
      }
  for (std::size_t k = 0; k < axes; ++k) {
    if (!box[k].lower.after) least[k] = 0;
    if (box[k].upper.after) greatest[k] = family.degrees[k];
    if (greatest[k] < least[k]) fail("the factor vanishes on the leaf");
  }
  Bernstein result;
  for (std::size_t k = 0; k < axes; ++k) result.degrees.push_back(greatest[k] - least[k]);
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < size; ++i) {
      bool inside = true;
      for (std::size_t k = 0; k < axes; ++k)
        inside = inside && indices[i][k] >= least[k] && indices[i][k] <= greatest[k];
      if (inside) result.coefficients.push_back(family.coefficients[j * size + i]);
    }
  family = std::move(result);
}

/// sum_{s<p} |r_s,I| < r_p,I for every I: Rouche's theorem with r_p z^p (Karciauskas & Peters 2013, eq. 16).
void prove_rouche(const Bernstein& r) {
  const std::size_t size = r.size(), p = r.count() - 1;
  for (std::size_t i = 0; i < size; ++i) {
    mpz_class gap = r.coefficients[p * size + i];
    for (std::size_t s = 0; s < p; ++s) gap -= abs(r.coefficients[s * size + i]);
    if (gap <= 0) fail("a Bernstein coefficient of the leading term does not dominate (Rouche's test)");
  }
}

/// The roots vary continuously and are inside at the midpoint; on the way out one of them is 1 or -1, or two of them
/// have the product 1, which makes the determinant r_p^{p-1} prod_{i<j} (1 - z_i z_j) vanish. (r_p does not vanish
/// before: with all roots inside all r_s would vanish with it, r(1) too.)
void prove_boundary(const Bernstein& r, const Region& box, Budget& budget) {
  const std::size_t size = r.size(), p = r.count() - 1;
  std::vector<mpz_class> at_one(size), at_minus_one(size);  // r(1), (-1)^p r(-1)
  for (std::size_t s = 0; s <= p; ++s)
    for (std::size_t i = 0; i < size; ++i) {
      const mpz_class& c = r.coefficients[s * size + i];
      at_one[i] += c;
      at_minus_one[i] += (p - s) % 2 == 0 ? c : mpz_class(-c);
    }
  if (!is_positive(at_one, r.degrees, box)) fail("r(1) is not proved positive (boundary test)");
  if (!is_positive(at_minus_one, r.degrees, box)) fail("(-1)^p r(-1) is not proved positive (boundary test)");
  if (p == 1) return;
  const Bernstein determinant = boundary_determinant(r, budget);
  if (!is_positive(determinant.coefficients, determinant.degrees, box)) fail("the determinant is not proved positive (boundary test)");
}

/// F(c, .) = |r(e^{it})|^2 = A_0 + 2 sum_k T_k(c) A_k, c = cos t, A_k = sum_i r_i r_{i+k}: no root ever is on the
/// circle.
void prove_circle(const Bernstein& r, const std::vector<mpq_class>& cuts, Budget& budget) {
  const std::size_t p = r.count() - 1;
  const double entries = tensor_size(r.degrees, 1), doubled = tensor_size(r.degrees, 2),
               degree = static_cast<double>(p);
  budget.work((degree + 1) * (degree + 2) / 2 * entries * entries * cost(limbs(r), limbs(r)));
  budget.hold((degree + 4) * doubled * (40 + 16 * limbs(r)));
  std::vector<Bernstein> a;
  for (std::size_t k = 0; k <= p; ++k) {
    for (std::size_t i = 0; i + k <= p; ++i) {
      const Bernstein term = convolve(r.polynomial(i), r.polynomial(i + k));
      if (i == 0) a.push_back({term.degrees, std::vector<mpz_class>(term.coefficients.size())});
      for (std::size_t j = 0; j < term.coefficients.size(); ++j) a[k].coefficients[j] += term.coefficients[j];
    }
  }
  mpq_class lower = -1;
  for (std::size_t piece = 0; piece <= cuts.size(); ++piece) {
    const mpq_class upper = piece < cuts.size() ? cuts[piece] : mpq_class(1);
    if (lower >= upper) fail("the cuts are not increasing and inside of (-1, 1)");
    const mpz_class g = lcm(lower.get_den(), upper.get_den());
    const double size = degree * 2 * limbs(g) + 1;
    budget.work(degree * degree * degree * cost(size, size) + doubled * degree * degree * cost(limbs(a[0]) + 1, size));
    // g^k T_k on [lower, upper], homogeneous of degree k in (1-t, t), then raised to g^p and degree p.
    const Bernstein c{{1}, {mpq_class(lower * g).get_num(), mpq_class(upper * g).get_num()}}, one{{1}, {g, g}};
    std::vector<Bernstein> chebyshev{{{0}, {1}}, c};
    for (std::size_t k = 2; k <= p; ++k) {
      chebyshev.push_back(convolve(c, chebyshev[k - 1]));
      const Bernstein before = convolve(power(one, 2), chebyshev[k - 2]);
      for (std::size_t i = 0; i <= k; ++i)
        chebyshev[k].coefficients[i] = 2 * chebyshev[k].coefficients[i] - before.coefficients[i];
    }
    for (std::size_t k = 0; k <= p; ++k) chebyshev[k] = convolve(power(one, static_cast<int>(p - k)), chebyshev[k]);
    for (std::size_t i = 0; i <= p; ++i) {
      for (std::size_t j = 0; j < a[0].coefficients.size(); ++j) {
        mpz_class sum = 0;
        for (std::size_t k = 0; k <= p; ++k)
          sum += chebyshev[k].coefficients[i] * a[k].coefficients[j] * (k == 0 ? 1 : 2);
        if (sum <= 0) fail("a Bernstein coefficient of F is not positive (circle test)");
      }
    }
    lower = upper;
  }
}

}  // namespace

// With x for t / (1-t), it is the determinant of polynomials in x whose coefficients are the scaled ones: from its
// values modulo enough numbers at enough points.
Bernstein boundary_determinant(const Bernstein& r, Budget& budget) {
  const std::size_t p = r.count() - 1, n = p - 1;
  std::vector<Dense> coefficients;
  budget.hold(static_cast<double>(r.coefficients.size()) * (40 + 8 * limbs(r)));
  for (std::size_t s = 0; s <= p; ++s) coefficients.push_back({r.degrees, r.polynomial(s).coefficients});
  mpz_class bound = 1;  // the product of the rows' norms
  for (std::size_t i = 1; i <= n; ++i) {
    mpz_class row = 1;
    for (std::size_t j = i; j <= n; ++j) row += norm(coefficients[p - j + i]);
    for (std::size_t j = p - i; j <= n; ++j) row += norm(coefficients[i + j - p]);
    bound *= row;
  }
  double points = 1, sweep = 0;
  std::vector<int> degrees, counts;
  for (const int d : r.degrees) {
    degrees.push_back(d * static_cast<int>(n));
    counts.push_back(degrees.back() + 1);
    points *= counts.back();
    sweep += 8. * counts.back();
  }
  const double bits = static_cast<double>(mpz_sizeinbase(bound.get_mpz_t(), 2)) + 1, size_n = static_cast<double>(n);
  budget.hold(points * (bits / 4 + 64));
  const double per_modulus =
      visit_cost(coefficients, counts) + points * (800 + 5 * size_n * size_n * size_n + sweep + 100 + bits / 8);
  budget.work(moduli_for(bits) * per_modulus);
  Reconstruction reconstruction(static_cast<std::size_t>(points), bound);
  for (mpz_class q = next_modulus(); !reconstruction.is_complete(); q = next_modulus(q)) {
    const Modulus modulus(q);
    std::vector<Residue> values;
    const bool done = for_each_point(modulus, coefficients, counts, 0, [&](const std::vector<Residue>& at_point) {
      std::vector<Residue> matrix(n * n, 0);
      for (std::size_t i = 1; i <= n; ++i)
        for (std::size_t j = 1; j <= n; ++j) {
          Residue& entry = matrix[(i - 1) * n + j - 1];
          if (j >= i) entry = at_point[p - j + i];
          if (i + j >= p) entry = modulus.minus(entry, at_point[i + j - p]);
        }
      values.push_back(0);
      return determinant(modulus, std::move(matrix), n, values.back());
    });
    if (done && interpolate(modulus, values, counts, 0)) reconstruction.add(modulus, values);
  }
  return {degrees, reconstruction.result()};
}

void prove_dominance(const Factor& factor, int order, const Dominance& leaf, Budget& budget) {
  budget.start_leaf();
  Region box;
  Bernstein r = on_region(factor.coefficients, leaf.region, box, budget);
  budget.work(static_cast<double>(r.coefficients.size()) * (500 + 10 * limbs(r) * limbs(r) + order));
  divide_common_powers(r, box);
  mpz_class content = 0;
  for (const auto& c : r.coefficients) content = gcd(content, c);
  if (content == 0) fail("the factor vanishes on the leaf");
  for (auto& c : r.coefficients) c /= content;
  const std::size_t size = r.size(), p = r.count() - 1;
  std::vector<mpz_class> midpoint(p + 1);
  for (std::size_t s = 0; s <= p; ++s)
    for (std::size_t i = 0; i < size; ++i) {
      r.coefficients[s * size + i] <<= static_cast<unsigned long>(order) * (p - s);
      midpoint[s] += r.coefficients[s * size + i];
    }
  if (midpoint[p] == 0) fail("the leading coefficient vanishes at the leaf's midpoint");
  if (midpoint[p] < 0)
    for (auto& c : r.coefficients) c = -c;
  if (leaf.test == Dominance::Test::rouche) return prove_rouche(r);
  if (leaf.test == Dominance::Test::separation) return prove_separation(r, order, leaf, budget);
  if (!all_roots_inside(midpoint, budget)) fail("at the leaf's midpoint not all roots are inside");
  if (leaf.test == Dominance::Test::boundary)
    prove_boundary(r, box, budget);
  else
    prove_circle(r, leaf.cuts, budget);
}

}  // namespace limes::checker
