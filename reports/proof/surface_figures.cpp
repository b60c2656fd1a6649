// Shaded pictures of refined control nets, in double precision.
#include "algebra/error.hpp"
#include "geometry/io/csv.hpp"
#include "geometry/tensor_net.hpp"
#include "reports/plot/surface_plot.hpp"
#include "reports/proof/figures_impl.hpp"
#include "schemes/nonstationary/angle.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace limes::report_impl {
namespace {

using Json = nlohmann::json;

NetEnds ends_of(const Json& example, const char* key) {
  const std::string text = example.value(key, "open");
  return text == "periodic" ? NetEnds::periodic : text == "poles" ? NetEnds::poles : text == "first-pole" ? NetEnds::first_pole : NetEnds::open;
}

/// Enough faces to look smooth.
int levels_for(const TensorNet& net) { return net.points.size() < 80 ? 3 : 2; }

Figure::Panel surface_panel(const SurfaceRule& rule, const Json& example, const std::filesystem::path& folder, const Stop& stop) {
  TensorNet net{.rows = example.at("rows"), .columns = example.at("columns"), .points = {}, .across_rows = ends_of(example, "across_rows"), .across_columns = ends_of(example, "across_columns")};
  const NumberTable table = read_csv_file(folder / example.at("net").get<std::string>());
  for (std::size_t i = 0; i + 2 < table.values.size(); i += 3) net.points.push_back({table.values[i], table.values[i + 1], table.values[i + 2]});
  std::array<EdgeAngle, 2> angles;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool hyperbolic = example.contains("types") && example["types"].at(k) == "hyperbolic";
    angles[k] = {hyperbolic ? AngleType::hyperbolic : AngleType::trigonometric, read_angles(example.at("angles").at(k).get<std::string>()).midpoint()};
  }
  const int levels = levels_for(net);
  MeshRefinement refinement{levels};
  refinement.boundary = MeshBoundary::exact;
  SurfacePlotOptions options;
  options.title = example.at("title");
  options.azimuth = example.at("view").at(0);
  options.elevation = example.at("view").at(1);
  options.lines = edge_lines(polygon_mesh(net));
  const PolygonMesh mesh = polygon_mesh(refine_net(net, approx_level_weights(rule, angles, levels), refinement, stop));
  Plot plot = surface_plot(mesh, options);
  plot.width = 140;
  plot.height = 120;
  for (PlotItem& item : plot.items) {
    if (auto* curve = std::get_if<PlotCurve>(&item)) curve->stroke.width = curve->closed ? 0.3 : 0.35;
  }
  std::string data = "x,y,z\n";
  for (const Point3& p : mesh.points) data += fmt::format("{:.9g},{:.9g},{:.9g}\n", p.x, p.y, p.z);
  return {std::move(plot), data};
}

}  // namespace

Blocks surface_figures(const Scheme& scheme, const std::filesystem::path& nets, const Stop& stop) {
  std::ifstream stream(nets / "surfaces.json");
  if (nets.empty() || !stream) return {};
  Json examples;
  try {
    examples = Json::parse(stream);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: {}", (nets / "surfaces.json").string(), error.what()));
  }
  Figure figure{.name = scheme.name + "-surfaces", .panels = {}, .caption = {}};
  for (const Json& example : examples) figure.panels.push_back(surface_panel(*scheme.surface, example, nets, stop));
  figure.caption = rich("Control nets and their surfaces, with an angle for each direction that makes the scheme reproduce them [@BariMustafaGhaffarNisarBaleanu2021]; the shell is in none of the reproduced spaces.");
  return {figure};
}

}  // namespace limes::report_impl
