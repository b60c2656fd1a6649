#pragma once

#include "geometry/quad_mesh.hpp"
#include "reports/plot/plot.hpp"

namespace limes {

struct SurfacePlotOptions {
  std::string title;
  /// From where the surface is seen, in degrees: the angle about the z axis from the x axis on, and the height above the xy plane.
  double azimuth = 40, elevation = 25;
  Color color = {0x56, 0xb4, 0xe9};
  /// A control net, drawn over the surface as lines.
  std::vector<std::vector<Point3>> lines;
};

/// The surface in parallel projection, the far faces first, each in one shade of the colour by the angle between its normal and the
/// light, which comes from above the viewer's left shoulder; both sides are lit. z points up.
/// \throws LimitError above 200000 faces
Plot surface_plot(const PolygonMesh& mesh, const SurfacePlotOptions& options = {});

/// The edges of a mesh, once each.
std::vector<std::vector<Point3>> edge_lines(const PolygonMesh& mesh);

}  // namespace limes
