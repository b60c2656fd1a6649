#pragma once

#include "algebra/matrix/polynomial_matrix.hpp"
#include "algebra/stop.hpp"

namespace limes {

/// The determinant of a square matrix over Q[x_0, .., x_{n-1}], exactly: rows are brought to integers, determinants are
/// taken at enough integer points (a tensor grid), and the integer polynomial with these values is interpolated. The
/// grid is large enough by a proven bound: the degree in x_k is at most the sum over the rows of the greatest degree in
/// the row, and likewise for columns. Much faster than elimination over polynomials when the degrees are moderate.
/// \pre a is square. \throws LimitError above 10^7 grid points; Interrupted.
MultivariatePolynomial determinant(const PolynomialMatrix& a, const Stop& stop = {});

}  // namespace limes
