#pragma once

#include "geometry/point3.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace limes {

using MeshIndex = std::uint32_t;
inline constexpr MeshIndex no_index = ~MeshIndex{0};

/// An oriented surface of quadrilaterals, perhaps with boundary, as half-edges: half-edge h = 4 f + k runs from corner k to corner
/// k + 1 (mod 4) of face f, with the face on its left. Every edge has one or two half-edges, and the faces at a vertex form one fan.
/// Edges may be sharp: creases, over which nothing is averaged.
class QuadMesh {
 public:
  /// `corners` are four vertices a face, counterclockwise seen from outside; `sharp` are pairs of vertices.
  /// \throws InputError that names the face, edge or vertex, counted from 1: a corner that is no vertex, a face with a repeated
  /// vertex, an edge of more than two faces or of two faces of opposite orientation, a vertex of no face or of more than one fan, a
  /// sharp pair that is no edge, a coordinate that is not finite, no face at all.
  QuadMesh(std::vector<Point3> points, std::vector<MeshIndex> corners,
           const std::vector<std::pair<MeshIndex, MeshIndex>>& sharp = {});

  std::size_t vertices() const { return points_.size(); }
  std::size_t faces() const { return corners_.size() / 4; }
  std::size_t half_edges() const { return corners_.size(); }
  std::size_t edges() const { return edge_count_; }

  const std::vector<Point3>& points() const { return points_; }
  const Point3& point(MeshIndex vertex) const { return points_[vertex]; }

  MeshIndex origin(MeshIndex h) const { return corners_[h]; }
  MeshIndex target(MeshIndex h) const { return corners_[next(h)]; }
  static MeshIndex next(MeshIndex h) { return (h & ~MeshIndex{3}) | ((h + 1) & 3); }
  static MeshIndex previous(MeshIndex h) { return (h & ~MeshIndex{3}) | ((h + 3) & 3); }
  static MeshIndex opposite(MeshIndex h) { return h ^ 2; }
  /// The other half-edge of the edge; no_index on the boundary and across a sharp edge.
  MeshIndex twin(MeshIndex h) const { return twins_[h]; }
  /// The edge of a half-edge, 0 .. edges() - 1; both sides of a sharp edge have the same one.
  MeshIndex edge(MeshIndex h) const { return edges_[h]; }
  bool sharp(MeshIndex edge) const { return !sharp_.empty() && sharp_[edge]; }

  /// The corners of all faces, four each.
  const std::vector<MeshIndex>& corners() const { return corners_; }

  /// The connectivity after each face is split into four: vertices 0 .. V-1 are the old ones, V + e belongs to edge e, V + E + f to
  /// face f; face 4 f + k has the corners (k, edge k, f, edge k-1) of face f. `points` are those of all new vertices.
  /// \pre points.size() == vertices() + edges() + faces()
  QuadMesh split(std::vector<Point3> points) const;

 private:
  QuadMesh() = default;
  void number_edges(const std::vector<MeshIndex>& partners);

  std::vector<Point3> points_;
  std::vector<MeshIndex> corners_, twins_, edges_;
  std::vector<bool> sharp_;  // of edges; empty without sharp edges
  std::size_t edge_count_ = 0;
};

/// Faces with any number >= 3 of corners.
struct PolygonMesh {
  std::vector<Point3> points;
  std::vector<std::vector<MeshIndex>> faces;
  std::vector<std::pair<MeshIndex, MeshIndex>> sharp;
};

/// The mesh itself if all faces are quadrilaterals; else every face with n corners is split into n of them at its centroid and the
/// midpoints of its edges, and no vertex moves. \throws InputError as QuadMesh
QuadMesh quad_mesh(const PolygonMesh& mesh);

PolygonMesh polygon_mesh(const QuadMesh& mesh);

}  // namespace limes
