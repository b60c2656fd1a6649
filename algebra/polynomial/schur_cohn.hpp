#pragma once

#include "algebra/polynomial/polynomial.hpp"

namespace limes {

/// Complex roots of a real polynomial with multiplicity, by position relative to a circle |z| = radius about 0.
struct CircleCount {
  int inside = 0;
  int on = 0;
  int outside = 0;
};

/// Exact count for every non-zero polynomial, degenerate cases (roots on the circle, pairs z, radius^2/z) included: the part
/// shared with the reciprocal polynomial is counted through Sturm's theorem in z + 1/z, the rest through the signature of the
/// Schur-Cohn form over Q.
/// \pre a != 0, radius > 0. \throws DomainError otherwise.
CircleCount count_roots_by_circle(const Polynomial& a, const Rational& radius);

/// Whether all roots satisfy |z| < radius (Schur's recursion; true for non-zero constants). \pre a != 0, radius > 0
bool roots_inside_circle(const Polynomial& a, const Rational& radius);

}  // namespace limes
