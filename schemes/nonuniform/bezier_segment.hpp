#pragma once

#include <utility>
#include <vector>

namespace limes {

/// A curve segment over one knot interval, u in [0, 1], in Bezier form: `pieces` polynomials of the same degree over
/// equal parts of the interval. A coefficient is a linear combination of the points p_{i-n+1} .. p_{i+n}, given by its
/// weights in a field K (of rational functions, rationals or doubles).
template <class K>
struct BezierSegment {
  int degree = 0;
  int pieces = 1;
  /// coefficients[k * (degree + 1) + j] is coefficient j of piece k.
  std::vector<std::vector<K>> coefficients;

  const std::vector<K>& coefficient(int piece, int j) const {
    return coefficients[static_cast<std::size_t>(piece * (degree + 1) + j)];
  }
};

}  // namespace limes
