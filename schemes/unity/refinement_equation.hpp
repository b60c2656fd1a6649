#pragma once

#include "algebra/matrix/rational_matrix.hpp"
#include "algebra/stop.hpp"
#include "schemes/unity/weight_function.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace limes {

/// The refinement equation w(u) = sum_k c_k w(2u - s_k), asked for on a closed interval, s_k = first_shift + k.
/// [MoltajiRunionsSamavati2016, eq. 10 with d = 1]
struct RefinementEquation {
  WeightFunction weight;
  Interval domain;
  Rational first_shift;
  int count = 0;

  /// The index of the mask's first coefficient: floor(first_shift).
  int first_index() const;
};

/// The equation with given parts or their defaults: the domain is the support; the shifts are those for which the dilate's support lies in the
/// domain, on the lattice that is symmetric about the axis of w (a half-integral one when the support has odd length), without an axis on the one
/// that meets the left end of the support.
/// \throws InputError: no dilate inside of the domain, shifts that are no whole number apart, more than 64, weights with a sum
/// sum_i w(u - i) that vanishes or changes its sign, a weight that is not finite
RefinementEquation refinement_equation(const WeightFunction& weight, const std::optional<Interval>& domain = std::nullopt,
                                       const std::optional<std::pair<Rational, Rational>>& shifts = std::nullopt);

/// Least squares in normal form: ||w - sum_k c_k w(2 . - s_k)||^2 = (-c, 1)^T gram (-c, 1), index `count` for w itself.
struct LeastSquares {
  RationalMatrix gram;
  /// Bits of the arithmetic that compressed the samples; 0: the integrals are exact.
  int precision = 0;
  /// Rows of the system; 0: exact integrals.
  int samples = 0;
};

/// Values on the closed uniform grid of `samples` points of the domain [MoltajiRunionsSamavati2016, eq. 18], compressed by blocked
/// Householder QR in `precision` bits (53: double, otherwise MPFR); the triangular factor R gives gram = R^T R exactly.
/// \pre samples >= 2, 53 <= precision <= 4096. \throws InputError, Interrupted
LeastSquares sampled_least_squares(const RefinementEquation& equation, int samples, int precision, const Stop& stop);

/// Integrals over the domain instead of sums (Galerkin): exact for piecewise polynomials, otherwise by Gauss-Legendre quadrature with about
/// `samples` nodes between the breaks, compressed in the same way.
LeastSquares integral_least_squares(const RefinementEquation& equation, int samples, int precision, const Stop& stop);

/// The singular values of the columns `basis` (all: the identity) of the system, falling, computed in MPFR from the Gram matrix: floating hints.
/// \param basis has `count` rows
std::vector<double> approx_singular_values(const LeastSquares& system, const RationalMatrix& basis);

/// Values of w at the points, in double precision.
std::vector<double> approx_values(const WeightFunction& weight, const std::vector<double>& points);

}  // namespace limes
