#pragma once

#include "geometry/polygon.hpp"

namespace limes {

/// Discrete curvature by the circle through three consecutive points a, b, c with u = a - b, v = c - b: the vector
///   K = 2 ((1 - u.v/|u|^2) u + (1 - u.v/|v|^2) v) / |u - v|^2
/// points from b to the circle's centre and has length 1/radius, in any dimension. For collinear points with b between
/// a and c it is 0; where two of the three points coincide there is no circle, and K is 0 too. The ends of an open
/// polygon take over the value beside them; fewer than three points have none, all 0.
/// Its rounding errors are about 10^-16 |p| / h^2 for edges of length h: eight to ten levels of refinement show a
/// limit's curvature, many more show noise.
/// \returns a vector of R^d per point, point after point
std::vector<double> curvature_vectors(const Polygon& polygon);

/// The lengths of the curvature vectors; in the plane with a sign, positive where the polygon turns to the left.
std::vector<double> curvatures(const Polygon& polygon);

/// The curvature comb: from each point a tooth to p_i - scale K_i, on the outer side of the curve and as long as scale
/// times the curvature. \returns the tips, point after point. \throws DomainError when one is not finite
std::vector<double> curvature_comb(const Polygon& polygon, double scale);

}  // namespace limes
