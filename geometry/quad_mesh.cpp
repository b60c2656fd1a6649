#include "geometry/quad_mesh.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace limes {
namespace {

/// The half-edges between two vertices, in either direction.
struct EdgeRecord {
  MeshIndex low, high, half_edge;
  bool operator<(const EdgeRecord& other) const {
    return std::tie(low, high, half_edge) < std::tie(other.low, other.high, other.half_edge);
  }
};

void check_faces(const std::vector<Point3>& points, const std::vector<MeshIndex>& corners) {
  if (corners.empty()) throw InputError("the mesh has no face");
  if (points.size() >= no_index || corners.size() >= no_index) throw InputError("the mesh has too many vertices or faces");
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Point3& p = points[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError(fmt::format("vertex {} has a coordinate that is not finite", v + 1));
  }
  for (std::size_t f = 0; f < corners.size() / 4; ++f) {
    for (std::size_t k = 0; k < 4; ++k) {
      const MeshIndex v = corners[4 * f + k];
      if (v >= points.size()) throw InputError(fmt::format("face {} has vertex {}, but there are only {}", f + 1, v + 1, points.size()));
      for (std::size_t j = 0; j < k; ++j) {
        if (corners[4 * f + j] == v) throw InputError(fmt::format("face {} has vertex {} twice", f + 1, v + 1));
      }
    }
  }
}

}  // namespace

QuadMesh::QuadMesh(std::vector<Point3> points, std::vector<MeshIndex> corners,
                   const std::vector<std::pair<MeshIndex, MeshIndex>>& sharp)
    : points_(std::move(points)), corners_(std::move(corners)) {
  if (corners_.size() % 4 != 0) throw DomainError("QuadMesh: four corners a face");
  check_faces(points_, corners_);
  std::vector<EdgeRecord> records;
  records.reserve(corners_.size());
  for (MeshIndex h = 0; h < corners_.size(); ++h) {
    const auto [low, high] = std::minmax({origin(h), target(h)});
    records.push_back({low, high, h});
  }
  std::sort(records.begin(), records.end());
  std::vector<MeshIndex> partners(corners_.size(), no_index);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const EdgeRecord& a = records[i];
    const auto same = [&](std::size_t j) { return j < records.size() && records[j].low == a.low && records[j].high == a.high; };
    if (!same(i + 1)) continue;
    const MeshIndex b = records[i + 1].half_edge;
    if (same(i + 2))
      throw InputError(fmt::format("the edge of vertices {} and {} has more than two faces", a.low + 1, a.high + 1));
    if (origin(a.half_edge) == origin(b))
      throw InputError(fmt::format("faces {} and {} have opposite orientations at the edge of vertices {} and {}",
                                   a.half_edge / 4 + 1, b / 4 + 1, a.low + 1, a.high + 1));
    partners[a.half_edge] = b;
    partners[b] = a.half_edge;
    ++i;
  }
  // One fan at each vertex: turning from one of its half-edges reaches all.
  std::vector<MeshIndex> valence(points_.size(), 0), first(points_.size(), no_index);
  for (MeshIndex h = 0; h < corners_.size(); ++h) {
    ++valence[origin(h)];
    MeshIndex& start = first[origin(h)];
    if (start == no_index || partners[h] == no_index) start = h;  // clockwise-most, where there is a boundary
  }
  for (MeshIndex v = 0; v < points_.size(); ++v) {
    if (first[v] == no_index) throw InputError(fmt::format("vertex {} belongs to no face", v + 1));
    MeshIndex reached = 0;
    for (MeshIndex h = first[v]; h != no_index;) {
      ++reached;
      h = partners[previous(h)];
      if (h == first[v]) break;
    }
    if (reached != valence[v]) throw InputError(fmt::format("the faces at vertex {} do not form one fan", v + 1));
  }
  number_edges(partners);
  twins_ = std::move(partners);
  for (const auto& [a, b] : sharp) {
    const auto [low, high] = std::minmax({a, b});
    const auto found = std::lower_bound(records.begin(), records.end(), EdgeRecord{low, high, 0});
    if (found == records.end() || found->low != low || found->high != high)
      throw InputError(fmt::format("the sharp line of vertices {} and {} is no edge", a + 1, b + 1));
    const MeshIndex h = found->half_edge;
    if (sharp_.empty()) sharp_.assign(edge_count_, false);
    sharp_[edges_[h]] = true;
    if (twins_[h] != no_index) twins_[twins_[h]] = no_index;
    twins_[h] = no_index;
  }
}

void QuadMesh::number_edges(const std::vector<MeshIndex>& partners) {
  edges_.assign(corners_.size(), no_index);
  edge_count_ = 0;
  for (MeshIndex h = 0; h < corners_.size(); ++h) {
    if (edges_[h] != no_index) continue;
    edges_[h] = MeshIndex(edge_count_++);
    if (partners[h] != no_index) edges_[partners[h]] = edges_[h];
  }
}

QuadMesh QuadMesh::split(std::vector<Point3> points) const {
  if (points.size() != vertices() + edges() + faces()) throw DomainError("QuadMesh::split: wrong number of points");
  if (4 * half_edges() >= no_index) throw LimitError("the mesh has too many faces");
  QuadMesh result;
  result.points_ = std::move(points);
  result.corners_.resize(4 * half_edges());
  result.twins_.resize(4 * half_edges());
  result.edges_.resize(4 * half_edges());
  const auto edge_vertex = [&](MeshIndex h) { return MeshIndex(vertices()) + edge(h); };
  // Edge e becomes 2 e (from the origin of its first half-edge on) and 2 e + 1; the edges inside of the faces follow.
  const auto inner_edges = MeshIndex(2 * edges());
  std::vector<MeshIndex> lead(edges(), no_index);
  for (MeshIndex h = 0; h < half_edges(); ++h) {
    if (lead[edge(h)] == no_index) lead[edge(h)] = origin(h);
  }
  for (MeshIndex h = 0; h < half_edges(); ++h) {  // the new face h at the corner origin(h)
    const MeshIndex before = previous(h), n = 4 * h;
    result.corners_[n] = origin(h);
    result.corners_[n + 1] = edge_vertex(h);
    result.corners_[n + 2] = MeshIndex(vertices() + edges()) + h / 4;
    result.corners_[n + 3] = edge_vertex(before);
    result.twins_[n] = twin(h) == no_index ? no_index : 4 * next(twin(h)) + 3;
    result.twins_[n + 1] = 4 * next(h) + 2;
    result.twins_[n + 2] = 4 * before + 1;
    result.twins_[n + 3] = twin(before) == no_index ? no_index : 4 * twin(before);
    result.edges_[n] = 2 * edge(h) + (origin(h) == lead[edge(h)] ? 0 : 1);
    result.edges_[n + 1] = inner_edges + h;
    result.edges_[n + 2] = inner_edges + before;
    result.edges_[n + 3] = 2 * edge(before) + (origin(h) == lead[edge(before)] ? 0 : 1);
  }
  result.edge_count_ = inner_edges + half_edges();
  if (!sharp_.empty()) {
    result.sharp_.assign(result.edge_count_, false);
    for (std::size_t e = 0; e < edges(); ++e) result.sharp_[2 * e] = result.sharp_[2 * e + 1] = sharp_[e];
  }
  return result;
}

QuadMesh quad_mesh(const PolygonMesh& mesh) {
  const bool quads = std::all_of(mesh.faces.begin(), mesh.faces.end(), [](const auto& face) { return face.size() == 4; });
  std::vector<MeshIndex> corners;
  if (quads) {
    for (const auto& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
    return {mesh.points, std::move(corners), mesh.sharp};
  }
  std::vector<Point3> points = mesh.points;
  // Errors of the halves of an edge would name vertices and faces that the file has not: so edges are checked here.
  struct Edge {
    MeshIndex midpoint;
    MeshIndex origin, face;  // of the first half-edge
    int faces = 0;
  };
  std::map<std::pair<MeshIndex, MeshIndex>, Edge> edges;
  const auto midpoint = [&](MeshIndex a, MeshIndex b) { return edges.at(std::minmax(a, b)).midpoint; };
  const auto add_edge = [&](MeshIndex a, MeshIndex b, std::size_t f) {
    const auto [place, is_new] = edges.try_emplace(std::minmax(a, b), Edge{MeshIndex(points.size()), a, MeshIndex(f)});
    Edge& edge = place->second;
    if (is_new) points.push_back(0.5 * (mesh.points[a] + mesh.points[b]));
    if (++edge.faces > 2) throw InputError(fmt::format("the edge of vertices {} and {} has more than two faces", std::min(a, b) + 1, std::max(a, b) + 1));
    if (!is_new && edge.origin == a)
      throw InputError(fmt::format("faces {} and {} have opposite orientations at the edge of vertices {} and {}", edge.face + 1, f + 1,
                                   std::min(a, b) + 1, std::max(a, b) + 1));
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    if (face.size() < 3) throw InputError(fmt::format("face {} has fewer than three vertices", f + 1));
    Point3 sum;
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (face[k] >= mesh.points.size())
        throw InputError(fmt::format("face {} has vertex {}, but there are only {}", f + 1, face[k] + 1, mesh.points.size()));
      if (std::count(face.begin(), face.end(), face[k]) > 1)
        throw InputError(fmt::format("face {} has vertex {} twice", f + 1, face[k] + 1));
      sum += mesh.points[face[k]];
    }
    for (std::size_t k = 0; k < face.size(); ++k) add_edge(face[k], face[(k + 1) % face.size()], f);
    const auto centre = MeshIndex(points.size());
    points.push_back((1. / double(face.size())) * sum);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const MeshIndex v = face[k], after = face[(k + 1) % face.size()], before = face[(k + face.size() - 1) % face.size()];
      const MeshIndex e1 = midpoint(v, after), e0 = midpoint(before, v);
      corners.insert(corners.end(), {v, e1, centre, e0});
    }
  }
  std::vector<std::pair<MeshIndex, MeshIndex>> sharp;
  for (const auto& [a, b] : mesh.sharp) {
    const auto found = edges.find(std::minmax(a, b));
    if (found == edges.end()) throw InputError(fmt::format("the sharp line of vertices {} and {} is no edge", a + 1, b + 1));
    sharp.emplace_back(a, found->second.midpoint);
    sharp.emplace_back(found->second.midpoint, b);
  }
  return {std::move(points), std::move(corners), sharp};
}

PolygonMesh polygon_mesh(const QuadMesh& mesh) {
  PolygonMesh result{mesh.points(), {}, {}};
  const std::vector<MeshIndex>& c = mesh.corners();
  for (std::size_t h = 0; h < c.size(); h += 4) result.faces.push_back({c[h], c[h + 1], c[h + 2], c[h + 3]});
  for (MeshIndex h = 0; h < c.size(); ++h) {
    if (mesh.sharp(mesh.edge(h)) && mesh.origin(h) < mesh.target(h)) result.sharp.emplace_back(mesh.origin(h), mesh.target(h));
  }
  return result;
}

}  // namespace limes
