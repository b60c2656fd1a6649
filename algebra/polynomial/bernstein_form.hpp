#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <vector>

namespace limes {

/// The tensor Bernstein form of a polynomial on the closure of a box: with degrees n = (n_0, .., n_{d-1}) and the affine map of
/// [0,1]^d onto the box, p = sum_I c_I prod_i binom(n_i, I_i) t_i^{I_i} (1-t_i)^{n_i-I_i}. The range of p lies in the convex hull
/// of the c_I; corner coefficients are values. Coefficients are stored with the last index running fastest. Exact throughout.
/// A point axis of the box is allowed: the variable is substituted and its degree is 0.
class BernsteinForm {
 public:
  BernsteinForm(const MultivariatePolynomial& p, const Box& box);
  /// In a multidegree at least that of p (entries of point axes are ignored). \throws DomainError when it is too small.
  BernsteinForm(const MultivariatePolynomial& p, const Box& box, const std::vector<int>& degrees);

  const Box& box() const { return box_; }
  const std::vector<int>& degrees() const { return degrees_; }
  const std::vector<Rational>& coefficients() const { return coefficients_; }
  /// Least and greatest coefficient: lower() <= p <= upper() on the box.
  const Rational& lower() const;
  const Rational& upper() const;
  /// +1 or -1 when all coefficients are strictly of that sign, otherwise 0 (unknown).
  int strict_sign() const;
  /// +1 or -1 when no coefficient has the other sign and every face of the box that is not excluded (by *open* ends) has one that is not
  /// zero: the sign of p on the box itself, as the basis polynomials of a face's coefficients are positive inside of the face. p may
  /// vanish on excluded faces and on parts of them. 0 when unknown or p = 0.
  int strict_sign_off_open_faces() const;
  /// The two halves along an axis by de Casteljau. \pre the axis is no point
  std::pair<BernsteinForm, BernsteinForm> bisect(int axis) const;

 private:
  BernsteinForm() = default;
  Box box_;
  std::vector<int> degrees_;
  std::vector<Rational> coefficients_;
};

/// The sign of p on the whole box (off its open faces), proved by Bernstein coefficients with at most `max_boxes` bisection
/// boxes: +1, -1, or 0 when it is not proved. A 0 is no statement about p.
int prove_strict_sign(const MultivariatePolynomial& p, const Box& box, int max_boxes = 4096);

}  // namespace limes
