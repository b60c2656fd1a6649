#pragma once

#include "algebra/stop.hpp"
#include "geometry/quad_mesh.hpp"
#include "geometry/refine_mesh.hpp"

#include <cstddef>
#include <vector>

namespace limes {

/// How a net ends in one direction: a boundary; the last row is followed by the first one, which is not repeated; or both end rows
/// are poles, single points over which the net continues as q_{-k, n} = q_{k, n + N} with 2 N the number of columns; or only the first
/// row is one.
enum class NetEnds { open, periodic, poles, first_pole };

/// Points q_{m, n}, m = 0 .. rows - 1, n = 0 .. columns - 1, row after row.
struct TensorNet {
  std::size_t rows = 0, columns = 0;
  std::vector<Point3> points;
  NetEnds across_rows = NetEnds::open;     // of the index m
  NetEnds across_columns = NetEnds::open;  // of the index n; no poles

  const Point3& at(std::size_t m, std::size_t n) const { return points[m * columns + n]; }
};

/// The net after some levels of the tensor product of two four-point rules: direction 0 of the weights is that of the index m,
/// direction 1 that of n. Old points stay. [Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, section 2.2]
/// \throws InputError: fewer than two rows or columns (three where periodic; with fewer than four in a line the exact boundary is the linear one), a number of points other
/// than rows columns, poles with an odd number of columns, not periodic around them, or end rows that are not one point. LimitError,
/// Interrupted.
TensorNet refine_net(TensorNet net, const LevelWeights& weights, const MeshRefinement& refinement, const Stop& stop = Stop());

/// The net as a mesh; a row that is a pole becomes one vertex, with triangles.
PolygonMesh polygon_mesh(const TensorNet& net);

}  // namespace limes
