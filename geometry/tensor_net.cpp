#include "geometry/tensor_net.hpp"

#include "algebra/error.hpp"
#include "geometry/four_point_impl.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

/// Whether the first, or else the last, row is a pole.
bool is_pole(NetEnds ends, bool first) { return ends == NetEnds::poles || (first && ends == NetEnds::first_pole); }

void check(const TensorNet& net) {
  const auto need = [](bool holds, const std::string& reason) {
    if (!holds) throw InputError(reason);
  };
  need(net.points.size() == net.rows * net.columns,
       fmt::format("a net of {} rows and {} columns needs {} points, not {}", net.rows, net.columns, net.rows * net.columns, net.points.size()));
  need(net.rows >= (net.across_rows == NetEnds::periodic ? 3u : 2u), "the net has too few rows");
  need(net.columns >= (net.across_columns == NetEnds::periodic ? 3u : 2u), "the net has too few columns");
  need(!is_pole(net.across_columns, true), "the poles of a net are its first and last row");
  if (!is_pole(net.across_rows, true)) return;
  need(net.across_columns == NetEnds::periodic && net.columns % 2 == 0, "a net with poles needs an even number of periodic columns");
  for (const std::size_t m : {std::size_t{0}, net.rows - 1}) {
    if (m > 0 && !is_pole(net.across_rows, false)) continue;
    for (std::size_t n = 1; n < net.columns; ++n)
      need(net.at(m, n) == net.at(m, 0), fmt::format("row {} is no pole: its points differ", m + 1));
  }
}

/// What lies beyond the first, or the last, of `count` points in a line.
template <class At>
Point3 beyond(std::size_t count, bool at_end, const At& at, const FourPointWeights& w, MeshBoundary boundary) {
  std::array<Point3, 4> q;
  const std::size_t known = std::min(count, q.size());
  for (std::size_t i = 0; i < known; ++i) q[i] = at(at_end ? count - 1 - i : i);
  return continued({q.data(), known}, w, boundary);
}

/// New rows between the old ones.
TensorNet with_new_rows(const TensorNet& net, const FourPointWeights& w, MeshBoundary boundary) {
  TensorNet result = net;
  const std::size_t old = net.rows, columns = net.columns;
  result.rows = net.across_rows == NetEnds::periodic ? 2 * old : 2 * old - 1;
  result.points.resize(result.rows * columns);
  for (std::size_t n = 0; n < columns; ++n) {
    const auto at = [&](std::size_t m) { return net.at(m, n); };
    const std::size_t over = (n + columns / 2) % columns;
    const auto before = [&](std::size_t m) {
      if (m > 0) return at(m - 1);
      if (net.across_rows == NetEnds::periodic) return at(old - 1);
      return is_pole(net.across_rows, true) ? net.at(1, over) : beyond(old, false, at, w, boundary);
    };
    const auto after = [&](std::size_t m) {
      if (m + 1 < old) return at(m + 1);
      if (net.across_rows == NetEnds::periodic) return at(m + 1 - old);
      return is_pole(net.across_rows, false) ? net.at(old - 2, over) : beyond(old, true, at, w, boundary);
    };
    for (std::size_t m = 0; m < old; ++m) result.points[2 * m * columns + n] = at(m);
    for (std::size_t m = 0; 2 * m + 1 < result.rows; ++m) {
      const std::size_t next = (m + 1) % old;
      result.points[(2 * m + 1) * columns + n] = four_point(w, before(m), at(m), at(next), after(m + 1));
    }
  }
  return result;
}

TensorNet transposed(const TensorNet& net) {
  TensorNet result{net.columns, net.rows, std::vector<Point3>(net.points.size()), net.across_columns, net.across_rows};
  for (std::size_t m = 0; m < net.rows; ++m) {
    for (std::size_t n = 0; n < net.columns; ++n) result.points[n * net.rows + m] = net.at(m, n);
  }
  return result;
}

}  // namespace

TensorNet refine_net(TensorNet net, const LevelWeights& weights, const MeshRefinement& refinement, const Stop& stop) {
  check(net);
  if (double(net.points.size()) * std::pow(4., refinement.levels) > double(refinement.max_vertices))
    throw LimitError(fmt::format("after {} levels the net would have more than {} vertices", refinement.levels, refinement.max_vertices));
  for (int level = 0; level < refinement.levels; ++level) {
    stop.check();
    const std::array<FourPointWeights, 2> w = weights(level);
    net = with_new_rows(net, w[0], refinement.boundary);
    net = transposed(with_new_rows(transposed(net), w[1], refinement.boundary));
    for (std::size_t n = 1; n < net.columns; ++n) {  // but for rounding, poles are points already
      if (is_pole(net.across_rows, true)) net.points[n] = net.points.front();
      if (is_pole(net.across_rows, false)) net.points[net.points.size() - n] = net.at(net.rows - 1, 0);
    }
  }
  return net;
}

PolygonMesh polygon_mesh(const TensorNet& net) {
  check(net);
  PolygonMesh mesh;
  std::vector<MeshIndex> index(net.points.size());
  for (std::size_t m = 0; m < net.rows; ++m) {
    const bool pole = (m == 0 && is_pole(net.across_rows, true)) || (m + 1 == net.rows && is_pole(net.across_rows, false));
    for (std::size_t n = 0; n < net.columns; ++n) {
      if (!pole || n == 0) mesh.points.push_back(net.at(m, n));
      index[m * net.columns + n] = MeshIndex(mesh.points.size() - 1);
    }
  }
  const std::size_t rows = net.across_rows == NetEnds::periodic ? net.rows : net.rows - 1;
  const std::size_t columns = net.across_columns == NetEnds::periodic ? net.columns : net.columns - 1;
  for (std::size_t m = 0; m < rows; ++m) {
    for (std::size_t n = 0; n < columns; ++n) {
      std::vector<MeshIndex> face;
      const std::size_t m1 = (m + 1) % net.rows, n1 = (n + 1) % net.columns;
      for (const std::size_t corner : {m * net.columns + n, m1 * net.columns + n, m1 * net.columns + n1, m * net.columns + n1}) {
        if (face.empty() || (face.back() != index[corner] && face.front() != index[corner])) face.push_back(index[corner]);
      }
      mesh.faces.push_back(std::move(face));
    }
  }
  return mesh;
}

}  // namespace limes
