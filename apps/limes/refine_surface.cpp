// limes refine of surface schemes: meshes and nets in, meshes and pictures out.
#include "apps/limes/outputs.hpp"
#include "apps/limes/refine_surface.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "geometry/io/csv.hpp"
#include "geometry/io/obj.hpp"
#include "geometry/refine_mesh.hpp"
#include "geometry/tensor_net.hpp"
#include "reports/plot/surface_plot.hpp"
#include "schemes/nonstationary/angle.hpp"

#include <fmt/format.h>

#include <charconv>
#include <iostream>

namespace limes::app {
namespace {

/// The angles of both directions from theta, theta1, theta2, type, type1 and type2.
std::array<EdgeAngle, 2> angles_from(const Scheme& scheme, const std::vector<std::string>& settings) {
  const std::string& angle = scheme.surface->sequence.angle;
  const AngleType usual = scheme.surface->sequence.types.front().type;
  std::array<std::optional<Rational>, 2> thetas;
  std::array<std::optional<AngleType>, 2> types;
  const auto set = [](auto& places, const std::string& setting, const std::string& suffix, const auto& value) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (!suffix.empty() && suffix != std::to_string(k + 1)) continue;
      if (places[k]) throw InputError(fmt::format("--param {}: given twice", setting));
      places[k] = value;
    }
  };
  for (const std::string& setting : settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string name = setting.substr(0, equals), value = setting.substr(std::min(equals + 1, setting.size()));
    const bool is_type = name.starts_with("type");
    const std::string suffix = name.substr(std::min(name.size(), is_type ? std::size_t{4} : angle.size()));
    if ((!is_type && !name.starts_with(angle)) || (!suffix.empty() && suffix != "1" && suffix != "2") || value.empty())
      throw InputError(fmt::format("--param {}: expected {}=ANGLE or type=TYPE, or {}1, {}2, type1, type2 for one direction", setting, angle, angle, angle));
    if (is_type) {
      if (value != "trigonometric" && value != "hyperbolic" && value != "polynomial")
        throw InputError(fmt::format("--param {}: the type is trigonometric, polynomial or hyperbolic", setting));
      if (value == "polynomial") set(thetas, setting, suffix, Rational(0));
      set(types, setting, suffix, value == "polynomial" ? usual : value == "hyperbolic" ? AngleType::hyperbolic : AngleType::trigonometric);
    } else {
      const std::optional<Rational> theta = [&] {
        try {
          return single_angle(read_angles(value));
        } catch (const InputError& error) {
          throw InputError(fmt::format("--param {}: {}", setting, error.reason()));
        }
      }();
      if (!theta) throw InputError(fmt::format("--param {}: refining needs one angle", setting));
      set(thetas, setting, suffix, *theta);
    }
  }
  std::array<EdgeAngle, 2> angles;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!thetas[k]) throw InputError(fmt::format("refining needs the angle of an edge: --param {}=ANGLE, or type=polynomial", angle));
    angles[k] = {types[k].value_or(usual), *thetas[k]};
    const MaskSequence::Range* range = scheme.surface->sequence.find(angles[k].type);
    if (!range) throw InputError(fmt::format("{} has no {} type", scheme.name, to_string(angles[k].type)));
    if (!range->angles.contains(angles[k].theta))
      throw InputError(fmt::format("--param {}: outside of the parameter's range {}", angle, to_string(range->angles)));
  }
  return angles;
}

NetEnds ends_from(const std::string& text) {
  return text == "periodic" ? NetEnds::periodic : text == "poles" ? NetEnds::poles : text == "first-pole" ? NetEnds::first_pole : NetEnds::open;
}

/// "8x14"
std::pair<std::size_t, std::size_t> net_size(const std::string& text) {
  std::size_t rows = 0, columns = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, rows);
  const bool cross = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
  const auto second = cross ? std::from_chars(first.ptr + 1, end, columns) : first;
  if (!cross || second.ec != std::errc() || second.ptr != end || rows == 0 || columns == 0 || rows > 1u << 16 || columns > 1u << 16)
    throw InputError(fmt::format("--net {}: expected ROWSxCOLUMNS", text));
  return {rows, columns};
}

TensorNet net_from(const NumberTable& table, const RefineOptions& options) {
  if (table.columns != 3) throw InputError("a net needs three coordinates a line", {table.file.string(), table.lines.front(), 0});
  TensorNet net;
  std::tie(net.rows, net.columns) = net_size(options.net);
  for (std::size_t i = 0; i < table.values.size(); i += 3) net.points.push_back({table.values[i], table.values[i + 1], table.values[i + 2]});
  net.across_rows = ends_from(options.rows);
  net.across_columns = ends_from(options.columns);
  return net;
}

struct RefinedSurface {
  PolygonMesh data, result;
};

RefinedSurface refined(const Scheme& scheme, const RefineOptions& options, const Stop& stop) {
  const std::array<EdgeAngle, 2> angles = angles_from(scheme, options.parameters);
  MeshRefinement refinement{options.levels};
  if (options.ends == "shrink") throw InputError("--ends shrink: a surface ends by extend (the default) or exact");
  if (options.ends == "exact") refinement.boundary = MeshBoundary::exact;
  const LevelWeights weights = approx_level_weights(*scheme.surface, angles, options.levels);
  const bool is_obj = options.data.extension() == ".obj";
  if (is_obj == !options.net.empty()) throw InputError("a surface needs a mesh in an .obj file, or a net of points and --net ROWSxCOLUMNS");
  try {
    if (!is_obj) {
      const TensorNet net = net_from(read_csv_file(options.data), options);
      return {polygon_mesh(net), polygon_mesh(refine_net(net, weights, refinement, stop))};
    }
    const PolygonMesh mesh = read_obj_file(options.data);
    return {mesh, polygon_mesh(refine_mesh(quad_mesh(mesh), weights, refinement, stop))};
  } catch (const InputError& error) {
    if (!error.position().file.empty() || error.reason().starts_with("--")) throw;
    throw error.located(options.data.string(), 0);
  }
}

std::string content(const std::string& kind, const RefinedSurface& surface, const RefineOptions& options, const Scheme& scheme) {
  if (kind == "obj") return to_obj(surface.result);
  SurfacePlotOptions plot_options;
  plot_options.title = fmt::format("{}, {} levels", scheme.name, options.levels);
  if (options.azimuth) plot_options.azimuth = *options.azimuth;
  if (options.elevation) plot_options.elevation = *options.elevation;
  if (options.show_net) plot_options.lines = edge_lines(surface.data);
  return picture(kind, surface_plot(surface.result, plot_options));
}

}  // namespace

int refine_surface(const Scheme& scheme, const RefineOptions& options, const Stop& stop) {
  if (!scheme.surface->virtual_points)
    throw InputError(fmt::format("{} gives rules around extraordinary points of its own; only schemes with virtual points can be refined", scheme.name));
  if (!options.knots.empty() || options.closed || options.comb) throw InputError("--knots, --closed and --comb are for polygons");
  const std::vector<OutputFile> outputs = outputs_by_ending(options.outputs, {"obj", "svg", "pgf", "png"});
  const RefinedSurface surface = refined(scheme, options, stop);
  for (const OutputFile& output : outputs) {
    write_file(output.file, content(output.kind, surface, options, scheme));
    if (!options.json && !options.quiet)
      std::cout << fmt::format("{}: {} vertices, {} faces\n", output.file, surface.result.points.size(), surface.result.faces.size());
  }
  if (options.json) std::cout << outputs_json(outputs);
  return all_as_expected;
}

}  // namespace limes::app
