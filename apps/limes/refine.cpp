#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/outputs.hpp"
#include "apps/limes/refine_surface.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "analysis/nonstationary/space_moments.hpp"
#include "geometry/io/csv.hpp"
#include "geometry/knots.hpp"
#include "geometry/refine_polygon.hpp"
#include "reports/plot/polygon_plot.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

/// The polygon with the knots that --knots asks for.
Polygon with_knots(const Polygon& polygon, const NumberTable& table, const std::string& knots) {
  const std::optional<KnotSpacing> spacing = read_knot_spacing(knots);
  if (!spacing) return polygon.with_knots(knots_from(read_csv_file(knots), polygon));
  const std::optional<std::size_t> repeated = first_repeated_point(polygon);
  if (repeated && *spacing != KnotSpacing::uniform) {
    const std::size_t next = (*repeated + 1) % polygon.size();
    throw InputError(
        fmt::format("the same point as on line {}{}, but {} spacing needs neighbours that differ",
                    table.lines[*repeated], next == 0 ? " (a closed polygon names its first point once)" : "", knots),
        {table.file.string(), table.lines[next], 0});
  }
  return polygon.with_knots(spaced_knots(polygon, *spacing));
}

/// The polygon refined, and how for the title.
struct Refined {
  Polygon data;
  Polygon result;
  std::string title;
};

NonstationaryRule nonstationary_rule(const MaskSequence& sequence, AngleType type, const Rational& angle, const Refinement& refinement) {
  NonstationaryRule rule = approx_nonstationary_rule(sequence, type, angle, refinement.levels);
  if (refinement.ends != EndRule::exact) return rule;
  // Where exponents collide, at theta = 0, more polynomials may be reproduced than at other angles.
  std::vector<ExponentialFunction> space = reproduced_space(sequence, type, false);
  if (angle == 0) space = reproduced_polynomials(sequence);
  if (space.empty()) throw InputError("--ends exact: the scheme reproduces no function");
  rule.continuation = approx_continuation(space, approx_double(angle));
  return rule;
}

Refined refined(const Scheme& scheme, const RefineOptions& options, const Stop& stop) {
  const std::vector<Rational> values = point_from_settings(scheme, options.parameters, "refining needs");
  const NumberTable table = read_csv_file(options.data);
  Polygon polygon = polygon_from(table, options.closed);
  Refinement refinement{options.levels, EndRule::automatic};
  if (options.ends == "extend") refinement.ends = EndRule::extend;
  if (options.ends == "shrink") refinement.ends = EndRule::shrink;
  if (options.ends == "exact") {
    refinement.ends = EndRule::exact;
    if (!scheme.sequence) throw InputError(fmt::format("--ends exact: {} is not a nonstationary scheme", scheme.name));
  }
  std::string title = scheme.name;
  for (std::size_t k = 0; k < values.size(); ++k) {
    title += fmt::format(", {} = {}", scheme.parameters[k].name,
                         scheme.sequence ? to_decimal(values[k], 6, Rounding::nearest) : to_string(values[k]));
  }
  try {
    if (scheme.kind == SchemeKind::nonuniform) {
      const std::string knots = options.knots.empty() ? to_string(KnotSpacing::centripetal) : options.knots;
      title += read_knot_spacing(knots) ? fmt::format(", {} knots", knots) : "";
      polygon = with_knots(polygon, table, knots);
      return {polygon,
              refine_polygon(polygon, approx_nonuniform_rule(*scheme.insertion_rule, values), refinement, stop), title};
    }
    if (!options.knots.empty() && options.knots != to_string(KnotSpacing::uniform)) {
      throw InputError(
          fmt::format("--knots {}: {} is a {} scheme, its knots are equally spaced", options.knots, scheme.name, to_string(scheme.kind)));
    }
    if (scheme.sequence) {
      const AngleType type = type_from_settings(scheme, options.parameters);
      if (scheme.sequence->types.size() > 1) title += ", " + (values.front() == 0 ? "polynomial" : to_string(type));
      return {polygon, refine_polygon(polygon, nonstationary_rule(*scheme.sequence, type, values.front(), refinement), refinement, stop),
              title};
    }
    return {polygon, refine_polygon(polygon, approx_uniform_rule(scheme.mask, values), refinement, stop), title};
  } catch (const InputError& error) {
    // What has no file yet is about the points.
    if (!error.position().file.empty() || error.reason().starts_with("--")) throw;
    throw error.located(options.data.string(), 0);
  }
}

std::string content(const std::string& kind, const Refined& what, const RefineOptions& options) {
  if (kind == "csv") return to_csv(what.result);
  return picture(kind, polygon_plot(what.data, what.result, {what.title, options.comb}));
}

}  // namespace

int run_refine(const RefineOptions& options) {
  const Session session(options);
  for (const std::filesystem::path& output : options.outputs) {
    std::error_code ignored;
    if (std::filesystem::equivalent(output, options.data, ignored)) throw InputError(fmt::format("-o {}: that is the input", output.string()));
  }
  const Scheme scheme = load_scheme(options.scheme);
  if (scheme.surface) return refine_surface(scheme, options, session.stop());
  if (!options.net.empty()) throw InputError(fmt::format("--net: {} is no surface scheme", scheme.name));
  const std::vector<OutputFile> outputs = outputs_by_ending(options.outputs, {"csv", "svg", "pgf", "png"});
  const Refined what = refined(scheme, options, session.stop());
  for (const OutputFile& output : outputs) {
    if (output.kind != "csv" && what.data.dimension() < 2) {
      throw InputError(fmt::format("-o {}: a picture needs points with at least two coordinates", output.file));
    }
    write_file(output.file, content(output.kind, what, options));
    if (!options.json && !options.quiet) std::cout << fmt::format("{}: {} points\n", output.file, what.result.size());
  }
  if (options.json) std::cout << outputs_json(outputs);
  return all_as_expected;
}

}  // namespace limes::app
