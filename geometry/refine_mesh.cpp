#include "geometry/refine_mesh.hpp"

#include "algebra/error.hpp"
#include "geometry/four_point_impl.hpp"
#include "geometry/refine_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace limes {
namespace {

/// One more line of points: beyond p0 of p0, p1, p2, p3; the last two may be missing.
struct Line {
  Point3 points[4];
  std::size_t count = 0;
  operator std::span<const Point3>() const { return {points, count}; }
};

/// What is special about the vertices of the control mesh; those made later are regular, or have two curve edges (edges of the
/// boundary, or sharp) and two faces on either side.
struct ControlVertices {
  enum Kind : std::uint8_t {
    regular,        // valence 4 inside of the surface
    extraordinary,  // another valence inside of the surface
    on_curve,       // two curve edges meet
    curve_end,      // another number of them, or one face only
  };
  std::vector<Kind> kinds;
  bool any_extraordinary = false;

  explicit ControlVertices(const QuadMesh& mesh) : kinds(mesh.vertices(), regular) {
    std::vector<std::uint32_t> faces(mesh.vertices(), 0), curve_edges(mesh.vertices(), 0);
    std::vector<bool> seen(mesh.edges(), false);
    for (MeshIndex h = 0; h < mesh.half_edges(); ++h) {
      ++faces[mesh.origin(h)];
      if (mesh.twin(h) != no_index || seen[mesh.edge(h)]) continue;
      seen[mesh.edge(h)] = true;
      ++curve_edges[mesh.origin(h)];
      ++curve_edges[mesh.target(h)];
    }
    for (std::size_t v = 0; v < kinds.size(); ++v) {
      if (curve_edges[v] == 0) kinds[v] = faces[v] == 4 ? regular : extraordinary;
      else kinds[v] = curve_edges[v] == 2 && faces[v] > 1 ? on_curve : curve_end;
      any_extraordinary = any_extraordinary || kinds[v] == extraordinary;
    }
  }
  Kind operator()(MeshIndex v) const { return v < kinds.size() ? kinds[v] : regular; }
};

/// The directions of a face's edges: half-edge 4 f + k has direction (turned[f] + k) mod 2.
using Directions = std::vector<std::uint8_t>;

Directions directions_of(const QuadMesh& mesh) {
  Directions turned(mesh.faces(), 2);
  std::vector<MeshIndex> open;
  std::vector<MeshIndex> by_edge(mesh.edges(), no_index);  // the other side, over sharp edges too
  std::vector<MeshIndex> across(mesh.half_edges(), no_index);
  for (MeshIndex h = 0; h < mesh.half_edges(); ++h) {
    MeshIndex& other = by_edge[mesh.edge(h)];
    if (other == no_index) {
      other = h;
    } else {
      across[h] = other;
      across[other] = h;
    }
  }
  for (MeshIndex start = 0; start < mesh.faces(); ++start) {
    if (turned[start] != 2) continue;
    turned[start] = 0;
    open.push_back(start);
    while (!open.empty()) {
      const MeshIndex f = open.back();
      open.pop_back();
      for (MeshIndex k = 0; k < 4; ++k) {
        const MeshIndex t = across[4 * f + k];
        if (t == no_index) continue;
        const auto wanted = std::uint8_t((turned[f] + k + t) & 1);
        if (turned[t / 4] == 2) {
          turned[t / 4] = wanted;
          open.push_back(t / 4);
        } else if (turned[t / 4] != wanted) {
          throw InputError(fmt::format("faces {} and {}: the mesh has no two directions, so it needs the same angle for both",
                                       f + 1, t / 4 + 1));
        }
      }
    }
  }
  return turned;
}

Directions split(const Directions& turned) {
  Directions result(4 * turned.size());
  for (std::size_t h = 0; h < result.size(); ++h) result[h] = std::uint8_t((turned[h / 4] + h) & 1);
  return result;
}

/// One level of one mesh.
class Level {
 public:
  /// `turned` is empty when both directions have the same weights.
  Level(const QuadMesh& mesh, const std::array<FourPointWeights, 2>& weights, MeshBoundary boundary,
        const ControlVertices& control, const Directions& turned)
      : mesh_(mesh), weights_(weights), boundary_(boundary), control_(control), turned_(turned) {
    if (control_.any_extraordinary) make_virtual_points();
  }

  std::vector<Point3> points() {
    std::vector<Point3> result;
    result.reserve(mesh_.vertices() + mesh_.edges() + mesh_.faces());
    result = mesh_.points();
    result.resize(mesh_.vertices() + mesh_.edges() + mesh_.faces());
    edge_points_ = result.data() + mesh_.vertices();
    Point3* face_points = edge_points_ + mesh_.edges();
    for (MeshIndex h = 0; h < mesh_.half_edges(); ++h) {
      if (mesh_.twin(h) == no_index) edge_points_[mesh_.edge(h)] = curve_point(h);
      else if (h < mesh_.twin(h)) edge_points_[mesh_.edge(h)] = four_point(along(h), beyond(mesh_.twin(h)), at_origin(h), at_target(h), beyond(h));
    }
    for (MeshIndex f = 0; f < mesh_.faces(); ++f) face_points[f] = face_point(f);
    return result;
  }

 private:
  const FourPointWeights& along(MeshIndex h) const { return weights_[turned_.empty() ? 0 : (turned_[h / 4] + h) & 1]; }
  const Point3& at_origin(MeshIndex h) const { return mesh_.point(mesh_.origin(h)); }
  const Point3& at_target(MeshIndex h) const { return mesh_.point(mesh_.target(h)); }
  const Point3& edge_point_of(MeshIndex h) const { return edge_points_[mesh_.edge(h)]; }

  /// The half-edge that continues h in a straight line, when its target is a regular vertex; else no_index.
  MeshIndex straight(MeshIndex h) const {
    if (control_(mesh_.target(h)) != ControlVertices::regular) return no_index;
    const MeshIndex crossing = mesh_.twin(QuadMesh::next(h));
    return crossing == no_index ? no_index : QuadMesh::next(crossing);
  }

  /// The point after the target on the line of an edge inside of the surface.
  Point3 beyond(MeshIndex h) const {
    const MeshIndex ahead = straight(h);
    if (ahead != no_index) return at_target(ahead);
    if (control_(mesh_.target(h)) == ControlVertices::extraordinary) return virtual_points_.at(mesh_.twin(h));
    Line line{{at_target(h), at_origin(h), {}, {}}, 2};
    for (MeshIndex back = straight(mesh_.twin(h)); back != no_index && line.count < 4; back = straight(back)) {
      line.points[line.count++] = at_target(back);
    }
    return continued(line, along(h), boundary_);
  }

  /// The edge of a boundary or crease before or after h, on the same side; no_index where the curve ends.
  MeshIndex curve_after(MeshIndex h) const {
    if (control_(mesh_.target(h)) == ControlVertices::curve_end) return no_index;
    MeshIndex g = QuadMesh::next(h);
    while (mesh_.twin(g) != no_index) g = QuadMesh::next(mesh_.twin(g));
    return g;
  }
  MeshIndex curve_before(MeshIndex h) const {
    if (control_(mesh_.origin(h)) == ControlVertices::curve_end) return no_index;
    MeshIndex g = QuadMesh::previous(h);
    while (mesh_.twin(g) != no_index) g = QuadMesh::previous(mesh_.twin(g));
    return g;
  }

  /// The curve rule on an edge of a boundary or crease.
  Point3 curve_point(MeshIndex h) const {
    Line from_target{{at_target(h), at_origin(h), {}, {}}, 2}, from_origin{{at_origin(h), at_target(h), {}, {}}, 2};
    for (MeshIndex g = curve_before(h); g != no_index && from_target.count < 4; g = curve_before(g))
      from_target.points[from_target.count++] = at_origin(g);
    for (MeshIndex g = curve_after(h); g != no_index && from_origin.count < 4; g = curve_after(g))
      from_origin.points[from_origin.count++] = at_target(g);
    const FourPointWeights& w = along(h);
    const Point3 before = from_target.count > 2 ? from_target.points[2] : continued(from_origin, w, boundary_);
    const Point3 after = from_origin.count > 2 ? from_origin.points[2] : continued(from_target, w, boundary_);
    return four_point(w, before, at_origin(h), at_target(h), after);
  }

  /// Of edge points in a row across faces, the one after that of h, on the other side of h.
  Point3 row_beyond(MeshIndex h) const {
    const MeshIndex across = mesh_.twin(h);
    if (across != no_index) return edge_point_of(QuadMesh::opposite(across));
    MeshIndex g = QuadMesh::opposite(h);
    Line line{{edge_point_of(h), edge_point_of(g), {}, {}}, 2};
    for (g = mesh_.twin(g); g != no_index && line.count < 4; g = mesh_.twin(g)) {
      g = QuadMesh::opposite(g);
      line.points[line.count++] = edge_point_of(g);
    }
    return continued(line, along(QuadMesh::next(h)), boundary_);
  }

  /// From the row of edge points that crosses edges k and k + 2 of the face.
  Point3 face_point(MeshIndex f, MeshIndex k) const {
    const MeshIndex h = 4 * f + k, g = QuadMesh::opposite(h);
    return four_point(along(QuadMesh::next(h)), row_beyond(h), edge_point_of(h), edge_point_of(g), row_beyond(g));
  }

  /// Whether that row ends at an edge with an extraordinary vertex, whose edge point depends on more than the face's 16 points.
  bool leaves_the_grid(MeshIndex f, MeshIndex k) const {
    for (const MeshIndex h : {4 * f + k, 4 * f + k + 2}) {
      const MeshIndex across = mesh_.twin(h);
      if (across == no_index) continue;
      const MeshIndex far = QuadMesh::opposite(across);
      if (control_(mesh_.origin(far)) == ControlVertices::extraordinary ||
          control_(mesh_.target(far)) == ControlVertices::extraordinary)
        return true;
    }
    return false;
  }

  Point3 face_point(MeshIndex f) const {
    if (!control_.any_extraordinary) return face_point(f, 0);
    bool corner = false;
    for (MeshIndex k = 0; k < 4; ++k) corner = corner || control_(mesh_.origin(4 * f + k)) == ControlVertices::extraordinary;
    const bool first = leaves_the_grid(f, 0), second = leaves_the_grid(f, 1);
    if (first != second) return face_point(f, first ? 1 : 0);
    return corner || first ? 0.5 * (face_point(f, 0) + face_point(f, 1)) : face_point(f, 0);
  }

  void make_virtual_points() {
    std::vector<bool> done(control_.kinds.size(), false);
    for (MeshIndex h = 0; h < mesh_.half_edges(); ++h) {
      const MeshIndex v = mesh_.origin(h);
      if (control_(v) != ControlVertices::extraordinary || done[v]) continue;
      done[v] = true;
      std::vector<MeshIndex> spokes{h};  // counterclockwise
      for (MeshIndex g = mesh_.twin(QuadMesh::previous(h)); g != h; g = mesh_.twin(QuadMesh::previous(g))) spokes.push_back(g);
      const std::size_t n = spokes.size();
      const auto l = [&](std::size_t i) { return at_target(spokes[i % n]); };
      const auto k = [&](std::size_t i) { return at_target(QuadMesh::next(spokes[i % n])); };
      Point3 sum_l, sum_k;
      for (std::size_t i = 0; i < n; ++i) {
        sum_l += l(i);
        sum_k += k(i);
      }
      const double weight = 4. / double(n), kappa = weights_[0].kappa();
      for (std::size_t i = n; i < 2 * n; ++i) {
        const Point3 diagonals = k(i - 2) + k(i - 1) + k(i) + k(i + 1) - weight * sum_k;
        virtual_points_[spokes[i % n]] = weight * sum_l - (l(i - 1) + l(i) + l(i + 1)) + kappa * diagonals;
      }
    }
  }

  const QuadMesh& mesh_;
  const std::array<FourPointWeights, 2>& weights_;
  const MeshBoundary boundary_;
  const ControlVertices& control_;
  const Directions& turned_;
  std::unordered_map<MeshIndex, Point3> virtual_points_;  // by the half-edge from the extraordinary vertex
  Point3* edge_points_ = nullptr;
};

bool same(const std::array<FourPointWeights, 2>& w) { return w[0].outer == w[1].outer && w[0].inner == w[1].inner; }

}  // namespace

LevelWeights approx_level_weights(const SurfaceRule& rule, const std::array<EdgeAngle, 2>& angles, int levels) {
  std::vector<std::array<FourPointWeights, 2>> weights{std::size_t(levels)};
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const EdgeAngle& angle = angles[direction];
    const NonstationaryRule steps = approx_nonstationary_rule(rule.sequence, angle.type, angle.theta, levels);
    for (std::size_t level = 0; level < weights.size(); ++level) {
      const double edge = std::ldexp(approx_double(angle.theta), -int(level));
      const std::vector<double>& mask = steps.steps[level].mask;  // (outer, 0, inner, 1, inner, 0, outer)
      weights[level][direction] = {mask.front(), mask[2], angle.type == AngleType::trigonometric ? std::cos(edge) : std::cosh(edge)};
    }
  }
  return [weights = std::move(weights)](int level) { return weights.at(std::size_t(level)); };
}

QuadMesh refine_mesh(QuadMesh mesh, const LevelWeights& weights, const MeshRefinement& refinement, const Stop& stop) {
  double vertices = double(mesh.vertices()), edges = double(mesh.edges()), faces = double(mesh.faces());
  for (int level = 0; level < refinement.levels; ++level) {
    vertices += edges + faces;
    edges = 2 * edges + 4 * faces;
    faces *= 4;
    if (vertices > double(refinement.max_vertices))
      throw LimitError(fmt::format("after {} levels the mesh would have more than {} vertices", level + 1, refinement.max_vertices));
  }
  const ControlVertices control(mesh);
  Directions turned;
  if (refinement.levels > 0 && !same(weights(0))) {
    if (control.any_extraordinary)
      throw InputError("a mesh with extraordinary vertices needs the same angle in both directions");
    turned = directions_of(mesh);
  }
  for (int level = 0; level < refinement.levels; ++level) {
    stop.check();
    const std::array<FourPointWeights, 2> w = weights(level);
    mesh = mesh.split(Level(mesh, w, refinement.boundary, control, turned).points());
    if (!turned.empty()) turned = split(turned);
  }
  return mesh;
}

}  // namespace limes
