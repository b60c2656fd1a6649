// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/polynomial.hpp"

namespace limes::checker {

/// prod_k (multiple n_k + 1), the coefficients in a multiple of the multidegree n; as an estimate it cannot overflow.
double tensor_size(const std::vector<int>& degrees, double multiple);

/// Polynomials c_0, c_1, .. (the coefficients of a symbol in z, or a single one) on the closure of a box, all in the
/// same multidegree n, as *scaled* Bernstein coefficients: with t_k from 0 to 1 along axis k and s_k = 1 - t_k,
///
///     c_j = sum_I c_{j,I} prod_k t_k^{I_k} s_k^{n_k - I_k},  c_{j,I} = (Bernstein coefficient) prod_k binom(n_k, I_k).
///
/// They have the signs of the Bernstein coefficients, the product of two polynomials is the convolution of their scaled
/// coefficients, and after a common positive factor all of them are integers. The last axis runs fastest.
struct Bernstein {
  std::vector<int> degrees;
  std::vector<mpz_class> coefficients;

  std::size_t size() const { return static_cast<std::size_t>(tensor_size(degrees, 1)); }  ///< of one polynomial
  std::size_t count() const { return coefficients.size() / size(); }
  Bernstein polynomial(std::size_t j) const;
  bool is_zero(std::size_t j) const;
};

/// The greatest size of a coefficient, and the nanoseconds of a multiplication with addition.
double limbs(const Bernstein& p);
inline double cost(double limbs_x, double limbs_y) { return 30 + 0.7 * limbs_x * limbs_y; }

/// The polynomials times one common positive number. \pre the box has no points but for parameters that do not occur;
/// `axes` are the others, `degrees` their degrees n
Bernstein to_bernstein(const std::vector<Polynomial>& polynomials, const Region& box,
                       const std::vector<std::size_t>& axes, const std::vector<int>& degrees, Budget& budget);
/// The symbol p(z) q(z^spacing); of two single polynomials, their product.
Bernstein convolve(const Bernstein& p, const Bernstein& q, std::size_t spacing = 1);
Bernstein power(const Bernstein& p, int n);

/// Whether no coefficient (of one polynomial) is negative, and every face of the box that contains none of its excluded
/// points has a positive one. A point inside of a face sees the face's coefficients with positive weights, so p > 0 on
/// the box itself. A face without excluded points contains a smallest one: at every axis a closed end, or the whole open
/// interval.
bool is_positive(const std::vector<mpz_class>& coefficients, const std::vector<int>& degrees, const Region& box);

}  // namespace limes::checker
