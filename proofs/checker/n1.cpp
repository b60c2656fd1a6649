// SPDX-License-Identifier: MIT
//
// Theorem N1 (Warren 1995; Daubechies, Guskov & Sweldens 1999; Karciauskas & Peters 2013): midpoints are inserted, so
// after finitely many steps every knot with a ratio gamma != 1 is isolated. There, let L(gamma) be the matrix of one
// step on the 4n-1 nearest points. If the scheme for equal intervals is C^m (theorem U1), L has the eigenvectors t^k to
// the eigenvalues 2^{-k}, k = 0..m, and all its other eigenvalues are less than 2^{-m}, then the scheme is C^m.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/modular.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

/// t_j = j, j <= 0, and gamma j, j >= 0.
Polynomial knot(const Rule& rule, int j, Budget& budget) {
  return multiply(constant(j), j > 0 ? variable(rule.gamma) : constant(1), budget);
}

/// (b) L v_k = 2^{-k} v_k for k = 0..m: for the new point at t_r / 2, r odd, sum_j e_j t_j^k = (t_r / 2)^k. The rows of
/// the old points have this property since t_{2j} = 2 t_j.
void prove_eigenvectors(const Rule& rule, const std::vector<Stencil>& rows, int order, Budget& budget) {
  const int n = rule.points / 2;
  std::vector<Polynomial> powers;  // of the knots t_{1-2n} .. t_{2n-1}
  for (int j = 1 - 2 * n; j < 2 * n; ++j) powers.push_back(constant(1));
  for (int k = 0; k <= order; ++k) {
    for (int i = 0; i < 2 * n; ++i) {
      const Stencil& row = rows[static_cast<std::size_t>(i)];
      Polynomial sum;
      for (int j = 0; j < 2 * n; ++j)
        sum =
            add(std::move(sum),
                multiply(row.numerators[static_cast<std::size_t>(j)], powers[static_cast<std::size_t>(i + j)], budget),
                budget);
      // Row i is that of the knot number 2i + 1 - 2n.
      const Polynomial expected = multiply(row.denominator, powers[static_cast<std::size_t>(2 * i)], budget);
      if (multiply(sum, constant(mpz_class(1) << static_cast<unsigned long>(k)), budget) != expected)
        throw Rejected{"eigenvectors", "the matrix L does not have the eigenvector t^" + std::to_string(k)};
    }
    for (int j = 1 - 2 * n; j < 2 * n; ++j) {
      Polynomial& power = powers[static_cast<std::size_t>(j + 2 * n - 1)];
      power = multiply(power, knot(rule, j, budget), budget);
    }
  }
}

/// x^n p(1/x). \pre n >= the degree of p in x
Polynomial reversed(const Polynomial& p, std::size_t x, int n) {
  Polynomial result;
  for (const auto& [exponents, c] : p) {
    Exponents mirrored = exponents;
    mirrored[x] = static_cast<std::uint16_t>(n - exponents[x]);
    result[mirrored] = c;
  }
  return result;
}

/// (e) e_{k,j}(1/gamma) = e_{2n-1-k,2n+1-j}(gamma) for k = 0..2n-1: then L(1/gamma) is L(gamma) mirrored.
void prove_symmetry(const Rule& rule, const std::vector<Stencil>& rows, Budget& budget) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Stencil &row = rows[k], &mirrored = rows[rows.size() - 1 - k];
    int n = degree(row.denominator, rule.gamma);
    for (const auto& e : row.numerators) n = std::max(n, degree(e, rule.gamma));
    const Polynomial denominator = reversed(row.denominator, rule.gamma, n);
    for (std::size_t j = 0; j < row.numerators.size(); ++j)
      if (multiply(reversed(row.numerators[j], rule.gamma, n), mirrored.denominator, budget) !=
          multiply(mirrored.numerators[row.numerators.size() - 1 - j], denominator, budget))
        throw Rejected{"symmetry", "the stencils for gamma and 1/gamma are no mirror images"};
  }
}

/// The factor at 1/gamma, times the least power of gamma that makes it a polynomial: for gamma > 0 with the same roots.
Factor mirrored(const Factor& factor, std::size_t gamma) {
  Factor result = factor;
  int n = 0;
  for (const auto& d : factor.coefficients) n = std::max(n, degree(d, gamma));
  for (auto& d : result.coefficients) d = reversed(d, gamma, n);
  return result;
}

/// (f) For the factors, or the mirrored ones, that the leaves cover (0, 1] times the claimed region.
void prove_covering(const Certificate& certificate, bool is_mirrored, Budget& budget) {
  Region whole = certificate.region;
  whole.push_back({{0, true}, {1, true}, "(0, 1]"});
  for (std::size_t k = 0; k < certificate.factors.size(); ++k) {
    const std::string name = (is_mirrored ? "mirrored factor " : "factor ") + std::to_string(k);
    std::vector<Region> leaves;
    for (const auto& leaf : certificate.dominance) {
      if (leaf.factor != k || leaf.mirrored != is_mirrored) continue;
      if (!is_inside(leaf.region, whole))
        throw Rejected{"covering", "a leaf of " + name + " is not inside of the claimed region times (0, 1]"};
      leaves.push_back(leaf.region);
    }
    if (!covers(leaves, whole, budget))
      throw Rejected{"covering", "the leaves of " + name + " do not cover the claimed region times (0, 1]"};
  }
}

/// Polynomials times one common number, dense in the given variables; no others occur.
std::vector<Dense> to_dense(const std::vector<Polynomial>& family, const std::vector<std::size_t>& variables,
                            Budget& budget) {
  mpz_class denominator = 1;
  double size = 1;
  for (const auto& p : family)
    for (const auto& [exponents, c] : p) {
      budget.work(100 + 4 * limbs(c) * limbs(denominator));
      denominator = lcm(denominator, c.get_den());
      size = std::max(size, limbs(c));
    }
  std::vector<Dense> result;
  for (const auto& p : family) {
    Dense dense;
    std::size_t count = 1;
    for (const std::size_t v : variables) {
      dense.degrees.push_back(degree(p, v));
      count *= static_cast<std::size_t>(dense.degrees.back() + 1);
    }
    budget.hold(tensor_size(dense.degrees, 1) * 32);
    budget.work(static_cast<double>(p.size()) * (100 + 4 * size * limbs(denominator)));
    budget.hold(static_cast<double>(p.size()) * 8 * (size + limbs(denominator)));
    dense.coefficients.resize(count);
    for (const auto& [exponents, c] : p) {
      std::size_t place = 0;
      for (std::size_t k = 0; k < variables.size(); ++k)
        place = place * static_cast<std::size_t>(dense.degrees[k] + 1) + exponents[variables[k]];
      dense.coefficients[place] = mpq_class(c * denominator).get_num();
    }
    result.push_back(std::move(dense));
  }
  return result;
}

/// (c) det(lambda - L) prod lc(f)^mult = prod_{k<=m} (lambda - 2^{-k}) prod f^mult.
///
/// Times the denominators D of the rows, and 2^{m(m+1)/2}, both sides are polynomials with integer coefficients in
/// lambda, gamma and the parameters. Their degrees are bounded by sums over the rows and factors, their coefficients by
/// products of norms; they are equal modulo a number when they are so at a grid with more points than these degrees,
/// and equal when they are so modulo numbers with a product greater than the sum of the bounds.
void prove_characteristic_polynomial(const std::vector<Stencil>& rows, const std::vector<Factor>& factors, int order,
                                     std::vector<std::size_t> variables, Budget& budget) {
  const std::size_t points = rows.size(), n = 2 * points - 1;
  std::vector<Dense> polynomials;  // of every row D, e_1 D, .., e_2n D; of every factor d_0, .., d_p
  mpz_class left = 1, right = 1;   // bounds of the coefficients
  std::vector<int> left_degrees(variables.size(), 0), right_degrees = left_degrees;
  const auto greatest = [&](std::size_t first, std::size_t last, std::size_t v) {
    int result = 0;
    for (std::size_t k = first; k < last; ++k) result = std::max(result, polynomials[k].degrees[v]);
    return result;
  };
  for (const auto& row : rows) {
    std::vector<Polynomial> family{row.denominator};
    family.insert(family.end(), row.numerators.begin(), row.numerators.end());
    const std::size_t first = polynomials.size();
    for (auto& p : to_dense(family, variables, budget)) polynomials.push_back(std::move(p));
    mpz_class sum = 0;
    for (std::size_t k = first; k < polynomials.size(); ++k) sum += norm(polynomials[k]);
    left *= 2 * sum;  // and 2 >= the norm of a row lambda e_i - e_j
    right *= norm(polynomials[first]);
    for (std::size_t v = 0; v < variables.size(); ++v) {
      left_degrees[v] += greatest(first, polynomials.size(), v);
      right_degrees[v] += polynomials[first].degrees[v];
    }
  }
  for (const auto& factor : factors) {
    const std::size_t first = polynomials.size();
    for (auto& p : to_dense(factor.coefficients, variables, budget)) polynomials.push_back(std::move(p));
    mpz_class sum = 0;
    for (std::size_t k = first; k < polynomials.size(); ++k) sum += norm(polynomials[k]);
    for (int k = 0; k < factor.multiplicity; ++k) {
      left *= norm(polynomials.back());
      right *= sum;
      for (std::size_t v = 0; v < variables.size(); ++v) {
        left_degrees[v] += polynomials.back().degrees[v];
        right_degrees[v] += greatest(first, polynomials.size(), v);
      }
    }
  }
  for (int k = 1; k <= order; ++k) left <<= static_cast<unsigned long>(k);
  for (int k = 0; k <= order; ++k) right *= (mpz_class(1) << static_cast<unsigned long>(k)) + 1;
  std::vector<int> counts;
  double visits = 1;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    counts.push_back(std::max(left_degrees[v], right_degrees[v]) + 1);
    visits *= counts.back();
  }
  const mpz_class bound = left + right;
  const double size = static_cast<double>(n);
  const double moduli = moduli_for(static_cast<double>(mpz_sizeinbase(bound.get_mpz_t(), 2)) + 1);
  budget.work(moduli *
              (visit_cost(polynomials, counts) + visits * (charpoly_cost(size) + 500 * size + 20 * size * size)));

  const auto agree = [&](const Modulus& f, const std::vector<Residue>& values, bool& usable) {
    std::vector<Residue> matrix(n * n, 0), product{f.one()};
    const Residue* value = values.data();
    for (std::size_t k = 0; k < points; ++k) {
      const Residue inverse = f.inverse(*value++);
      if (!(usable = inverse != 0)) return false;
      for (std::size_t j = 0; j < points; ++j) matrix[2 * k * n + k + j] = f.times(*value++, inverse);
      if (k > 0) matrix[(2 * k - 1) * n + points / 2 - 1 + k] = f.one();
    }
    const auto multiply_by = [&](const Residue* coefficients, std::size_t count) {
      std::vector<Residue> next(product.size() + count - 1, 0);
      for (std::size_t i = 0; i < product.size(); ++i)
        for (std::size_t j = 0; j < count; ++j) next[i + j] = f.plus(next[i + j], f.times(product[i], coefficients[j]));
      product = std::move(next);
    };
    Residue scale = f.one(), half = f.inverse(f.plus(f.one(), f.one())), root = f.one();
    for (int k = 0; k <= order; ++k, root = f.times(root, half)) {
      const Residue linear[] = {f.minus(0, root), f.one()};
      multiply_by(linear, 2);
    }
    for (const auto& factor : factors) {
      const std::size_t count = factor.coefficients.size();
      for (int k = 0; k < factor.multiplicity; ++k) {
        multiply_by(value, count);
        scale = f.times(scale, value[count - 1]);
      }
      value += count;
    }
    const std::vector<Residue> chi = characteristic_polynomial(f, std::move(matrix), n);
    if (!(usable = !chi.empty())) return false;
    for (std::size_t i = 0; i <= n; ++i)
      if (f.times(chi[i], scale) != product[i]) return false;
    return true;
  };
  mpz_class modulus = next_modulus(), product = 1;
  for (int failures = 0; product <= bound; modulus = next_modulus(modulus)) {
    const Modulus f(modulus);
    bool usable = true;
    // The points start far from 0, where a denominator may vanish.
    const bool equal = for_each_point(f, polynomials, counts, modulus / 3 - 1000 * failures,
                                      [&](const std::vector<Residue>& values) { return agree(f, values, usable); });
    if (equal)
      product *= modulus;
    else if (usable || ++failures == 4)
      throw Rejected{"characteristic", "the factors do not multiply up to the characteristic polynomial of L"};
  }
}

}  // namespace

std::vector<Stencil> matrix_rows(const Rule& rule, const Region& region, Budget& budget) {
  std::vector<Stencil> rows;
  for (int k = 0; k < rule.points; ++k) {
    rows.push_back(isolated_stencil(rule, k, budget));
    for (std::size_t v = 0; v < region.size(); ++v) {
      if (!region[v].is_point()) continue;
      for (auto& e : rows.back().numerators) e = substitute(e, v, region[v].lower.value, budget);
      rows.back().denominator = substitute(rows.back().denominator, v, region[v].lower.value, budget);
    }
    if (rows.back().denominator.empty()) throw Rejected{"denominator", "a denominator of the rule vanishes"};
  }
  return rows;
}

void prove_n1(const Certificate& certificate, Budget& budget) {
  const Rule& rule = *certificate.rule;
  const int order = certificate.order, size = 2 * rule.points - 1;
  prove_covering(certificate, false, budget);
  if (certificate.both_sides) prove_covering(certificate, true, budget);
  std::vector<Factor> factors = certificate.factors;
  long eigenvalues = order + 1;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    Factor& f = factors[k];
    for (std::size_t v = 0; v < certificate.region.size(); ++v)
      if (certificate.region[v].is_point())
        for (auto& d : f.coefficients) d = substitute(d, v, certificate.region[v].lower.value, budget);
    if (f.coefficients.back().empty())
      throw Rejected{"characteristic", "the leading coefficient of factor " + std::to_string(k) + " is zero"};
    eigenvalues += static_cast<long>(f.multiplicity) * (static_cast<long>(f.coefficients.size()) - 1);
  }
  if (eigenvalues != size) throw Rejected{"characteristic", "the degrees of the factors do not add up to 4n-1"};

  const std::vector<Stencil> rows = matrix_rows(rule, certificate.region, budget);
  prove_eigenvectors(rule, rows, order, budget);
  if (!certificate.both_sides) prove_symmetry(rule, rows, budget);
  std::vector<std::size_t> variables{rule.gamma};
  for (std::size_t v = 0; v < certificate.region.size(); ++v)
    if (!certificate.region[v].is_point()) variables.push_back(v);
  prove_characteristic_polynomial(rows, factors, order, variables, budget);
  for (std::size_t i = 0; i < certificate.dominance.size(); ++i) {
    const Dominance& leaf = certificate.dominance[i];
    try {
      const Factor& factor = factors[leaf.factor];
      prove_dominance(leaf.mirrored ? mirrored(factor, rule.gamma) : factor, order, leaf, budget);
    } catch (const Rejected& rejected) {
      throw Rejected{rejected.step, "dominance leaf " + std::to_string(i + 1) + ": " + rejected.reason};
    }
  }
}

}  // namespace limes::checker
