#pragma once

#include "algebra/number/rational.hpp"

#include <vector>

namespace limes {

/// Proven bounds of a real number. lower <= upper.
struct RationalBounds {
  Rational lower, upper;
};

/// An extreme value of a function on [-1, 1], and a rational point where the inner bound is attained or passed.
struct ExtremeValue {
  RationalBounds bounds;
  Rational witness;
};

/// The squares of the least and greatest singular values (infimum and supremum of ||F x||^2 / ||x||^2 in l^2) of the matrix
/// whose columns are the filter f, each two rows below the one before: P and Q, or A and B transposed. Its Gram matrix is
/// Toeplitz with the symbol g_0 + 2 sum_d g_d cos(d omega), g_d = sum_i f_i f_{i + 2d}; on circulant matrices of all sizes
/// the singular values lie between the two, and come as near as one likes.
struct SquaredSingularValues {
  ExtremeValue least, greatest;
};

/// Extreme points are sought in double precision; the bounds, about 12 digits apart, are proved by Sturm's theorem.
/// \throws DomainError when the filter is empty or 0.
SquaredSingularValues squared_singular_values(const std::vector<Rational>& filter);

/// Bounds of the square root with a relative distance of 2^-60. \pre x >= 0
RationalBounds sqrt_bounds(const Rational& x);
/// The square root of what lies between bounds. \pre x.lower >= 0
RationalBounds sqrt_bounds(const RationalBounds& x);

}  // namespace limes
