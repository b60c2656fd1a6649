// The four-point rule of one level on points, and what lies beyond the end of a line. Included by sources only.
#pragma once

#include "geometry/refine_mesh.hpp"

#include <span>

namespace limes {

inline Point3 four_point(const FourPointWeights& w, const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return w.outer * (a + d) + w.inner * (b + c);
}

/// The point before q_0 of the line q_0, q_1, ..; the exact rule needs four points, and is the linear one where there are fewer.
inline Point3 continued(std::span<const Point3> q, const FourPointWeights& w, MeshBoundary boundary) {
  if (boundary == MeshBoundary::linear || q.size() < 4) return 2 * q[0] - q[1];
  const double c = w.edge_cosine;
  return (2 + 2 * c) * q[0] - (2 + 4 * c) * q[1] + (2 + 2 * c) * q[2] - q[3];
}

}  // namespace limes
