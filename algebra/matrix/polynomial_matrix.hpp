#pragma once

#include "algebra/matrix/rational_matrix.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"
#include "algebra/stop.hpp"

#include <vector>

namespace limes {

/// A dense matrix with entries in Q[x_0, .., x_{n-1}], row by row.
class PolynomialMatrix {
 public:
  PolynomialMatrix() = default;
  PolynomialMatrix(int variables, int rows, int columns);
  static PolynomialMatrix identity(int variables, int size);

  int variables() const { return variables_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  MultivariatePolynomial& operator()(int i, int j) { return entries_[std::size_t(i) * columns_ + j]; }
  const MultivariatePolynomial& operator()(int i, int j) const { return entries_[std::size_t(i) * columns_ + j]; }
  /// The matrix at a point.
  RationalMatrix at(std::span<const Rational> point) const;

 private:
  int variables_ = 0;
  int rows_ = 0;
  int columns_ = 0;
  std::vector<MultivariatePolynomial> entries_;
};

PolynomialMatrix operator*(const PolynomialMatrix& a, const PolynomialMatrix& b);

/// det(lambda I - a) as its n + 1 coefficients in lambda (element k multiplies lambda^k; the last one is 1), exactly: the matrix is
/// evaluated on a tensor grid of rational points, one integer characteristic polynomial each, and the coefficients are
/// interpolated. The grid is large enough by a proven degree bound: deg_i of the coefficient of lambda^{n-k} is at most the
/// greatest sum of k row (or column, whichever is less) degrees in x_i.
/// \pre a is square \throws LimitError for more than 10^7 values on the grids
std::vector<MultivariatePolynomial> characteristic_polynomial(const PolynomialMatrix& a, const Stop& stop = {});

}  // namespace limes
