#include "reports/plot/surface_plot.hpp"

#include "algebra/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace limes {
namespace {

constexpr std::size_t most_faces = 200000;

double dot(const Point3& p, const Point3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Point3 cross(const Point3& p, const Point3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// An orthonormal frame: to the right and up in the picture, and towards the viewer.
struct View {
  Point3 right, up, toward;

  View(double azimuth, double elevation) {
    const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
    toward = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    right = {-std::sin(a), std::cos(a), 0};
    up = cross(toward, right);
  }
  PlotPoint operator()(const Point3& p) const { return {dot(right, p), dot(up, p)}; }
};

/// Twice the vector area of a polygon: for a plane one a normal.
Point3 normal(const std::vector<Point3>& points, const std::vector<MeshIndex>& face) {
  Point3 sum;
  for (std::size_t k = 1; k + 1 < face.size(); ++k) sum += cross(points[face[k]] - points[face[0]], points[face[k + 1]] - points[face[0]]);
  return sum;
}

Color shade(Color color, double light) {
  const auto mix = [&](std::uint8_t c) { return std::uint8_t(std::lround(std::clamp(light * c + 255 * std::max(0., light - 0.85), 0., 255.))); };
  return {mix(color.red), mix(color.green), mix(color.blue)};
}

}  // namespace

Plot surface_plot(const PolygonMesh& mesh, const SurfacePlotOptions& options) {
  if (mesh.faces.size() > most_faces) throw LimitError("a picture of a surface has at most 200000 faces");
  const View view(options.azimuth, options.elevation);
  const Point3 light = 0.5 * view.up - 0.4 * view.right + 0.77 * view.toward;
  struct Face {
    double depth;
    std::size_t index;
  };
  std::vector<Face> order;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    double depth = 0;
    for (const MeshIndex v : mesh.faces[f]) depth += dot(view.toward, mesh.points[v]);
    order.push_back({depth / double(mesh.faces[f].size()), f});
  }
  std::stable_sort(order.begin(), order.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
  Plot plot{.title = options.title, .x = {}, .y = {}, .items = {}, .frame = false, .equal_aspect = true};
  for (const Face& face : order) {
    const Point3 n = normal(mesh.points, mesh.faces[face.index]);
    const double length = std::sqrt(dot(n, n));
    const double cosine = length > 0 ? dot(n, light) / length : 0;
    const Color color = shade(options.color, 0.3 + 0.7 * std::abs(cosine));
    std::vector<PlotPoint> outline;
    for (const MeshIndex v : mesh.faces[face.index]) outline.push_back(view(mesh.points[v]));
    plot.items.push_back(PlotCurve{outline, {color, 0.5}, true});  // covers the seam beside the neighbours
    plot.items.push_back(PlotRegion{{std::move(outline)}, color});
  }
  for (const auto& line : options.lines) {
    PlotCurve curve{{}, {palette(0), 0.4}};
    for (const Point3& p : line) curve.points.push_back(view(p));
    plot.items.push_back(std::move(curve));
  }
  return plot;
}

std::vector<std::vector<Point3>> edge_lines(const PolygonMesh& mesh) {
  std::set<std::pair<MeshIndex, MeshIndex>> edges;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) edges.insert(std::minmax({face[k], face[(k + 1) % face.size()]}));
  }
  std::vector<std::vector<Point3>> lines;
  for (const auto& [a, b] : edges) lines.push_back({mesh.points[a], mesh.points[b]});
  return lines;
}

}  // namespace limes
