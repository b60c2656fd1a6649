// Refined polygons and their curvature, in double precision.
#include "geometry/curvature.hpp"
#include "geometry/io/csv.hpp"
#include "geometry/knots.hpp"
#include "geometry/refine_polygon.hpp"
#include "reports/plot/polygon_plot.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <algorithm>
#include <cmath>

namespace limes::report_impl {

std::optional<Polygon> polygon_of(const std::filesystem::path& folder, const std::string& name, bool closed) {
  std::error_code error;
  const std::filesystem::path file = folder / name;
  if (folder.empty() || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  return polygon_from(read_csv_file(file), closed);
}

Polygon refined_at(const Scheme& scheme, const std::vector<Rational>& point, const Polygon& data, int levels, const Stop& stop) {
  if (scheme.insertion_rule) {
    return refine_polygon(data.with_knots(spaced_knots(data, KnotSpacing::centripetal)), approx_nonuniform_rule(*scheme.insertion_rule, point), {.levels = levels}, stop);
  }
  return refine_polygon(data, approx_uniform_rule(scheme.mask, point), {.levels = levels}, stop);
}

int levels_of(const Scheme& scheme) { return scheme.mask.arity == 2 ? 5 : 3; }

double typical_curvature(const Polygon& refined) {
  std::vector<double> sizes;
  for (const double c : curvatures(refined)) sizes.push_back(std::abs(c));
  std::sort(sizes.begin(), sizes.end());
  const double typical = sizes[sizes.size() * 95 / 100];
  return typical > 0 && std::isfinite(typical) ? typical : 0;
}

Figure::Panel comb_panel(const Polygon& data, const Polygon& refined, double typical) {
  std::vector<double> sizes;
  for (const double c : curvatures(refined)) sizes.push_back(std::abs(c));
  double extent = 0;
  for (std::size_t i = 0; i < data.size(); ++i) extent = std::max(extent, distance(data[0], data[i]));
  Plot plot = polygon_plot(data, refined, {.title = "", .comb = 0.1 * extent / typical});
  for (PlotItem& item : plot.items) {
    if (auto* teeth = std::get_if<PlotComb>(&item)) {
      // Outliers would make the picture small.
      for (std::size_t i = 0; i < teeth->feet.size(); ++i) {
        const double longest = 2.5 * typical;
        if (sizes[i] <= longest) continue;
        const double shrink = longest / sizes[i];
        teeth->tips[i] = {teeth->feet[i].x + shrink * (teeth->tips[i].x - teeth->feet[i].x), teeth->feet[i].y + shrink * (teeth->tips[i].y - teeth->feet[i].y)};
      }
      teeth->stroke.width = 0.5;
      teeth->every = std::max<std::size_t>(1, teeth->feet.size() / 130);
    }
    if (auto* curve = std::get_if<PlotCurve>(&item)) curve->stroke.width = curve->stroke.dash == Dash::dashed ? 0.4 : 0.9;
    if (auto* markers = std::get_if<PlotMarkers>(&item)) markers->radius = 1;
  }
  plot.frame = false;
  plot.width = 215;
  plot.height = 120;
  return Figure::Panel{std::move(plot), to_csv(refined)};
}

namespace {

/// The certified region of the smoothest claim that is no point.
const Box* widest_region(const ReportedScheme& reported, int& smoothness) {
  const Box* best = nullptr;
  smoothness = -1;
  for (const DecidedClaim& decided : reported.claims) {
    const Claim& claim = decided.claim;
    if (claim.negated || claim.space || claim.subject != ClaimSubject::limits || decided.verdict.outcome != Outcome::certified) continue;
    if (claim.region.size() != 1 || claim.region.front().is_point()) continue;
    const bool wider = best && claim.smoothness == smoothness && claim.region.front().width() > best->front().width();
    if (claim.smoothness > smoothness || wider) best = &claim.region, smoothness = claim.smoothness;
  }
  return best;
}

}  // namespace

std::optional<Figure> comb_figure(const ReportedScheme& reported, const std::vector<Rational>& point, const std::filesystem::path& polygons, const Stop& stop) {
  const Scheme& scheme = reported.scheme;
  const bool nonuniform = scheme.insertion_rule.has_value();
  Figure figure{.name = scheme.name + "-comb", .panels = {}, .caption = {}};
  for (const char* name : {"beetle.csv", "letter-t.csv"}) {
    const std::optional<Polygon> data = polygon_of(polygons, name, true);
    if (!data) continue;
    const Polygon refined = refined_at(scheme, point, *data, levels_of(scheme), stop);
    if (const double typical = typical_curvature(refined); typical > 0) figure.panels.push_back(comb_panel(*data, refined, typical));
  }
  if (figure.panels.empty()) return std::nullopt;
  figure.caption = rich(fmt::format("Closed polygons after ${}$ steps{}{}, with their curvature combs. Teeth beyond $2.5$ times a typical length are cut off.", levels_of(scheme), at_text(scheme, point),
                                    nonuniform ? ", over centripetal knots" : ""));
  return figure;
}

std::optional<Figure> curvature_figure(const ReportedScheme& reported, const std::filesystem::path& polygons, const Stop& stop) {
  const Scheme& scheme = reported.scheme;
  int smoothness = -1;
  const Box* region = widest_region(reported, smoothness);
  const std::optional<Polygon> data = polygon_of(polygons, "equal-sides.csv", false);
  if (scheme.kind != SchemeKind::uniform || !region || smoothness < 2 || !data) return std::nullopt;
  const Interval& range = region->front();
  Plot curves = small_plot(""), curvature = small_plot("");
  curves.frame = false;
  curves.equal_aspect = true;
  curves.width = 170;
  curves.height = 110;
  curvature.width = 190;
  curvature.height = 110;
  curvature.x.label = "length";
  curvature.y.label = "curvature";
  std::vector<PlotPoint> corners;
  for (std::size_t i = 0; i < data->size(); ++i) corners.push_back({(*data)[i][0], (*data)[i][1]});
  curves.items.push_back(PlotCurve{corners, {{150, 150, 150}, 0.4, Dash::dashed}});
  std::string values = "parameter,length,curvature\n", points = "parameter,x,y\n", words;
  const char* names[] = {"blue", "red", "green"};
  for (int k = 0; k < 3; ++k) {
    // Simple values near both ends of the region and in its middle.
    const Rational at = range.lower + range.width() * Rational(1 + 7 * k, 16), reach = range.width() / 20;
    const Rational value = simplest_between(at - reach, at + reach);
    const Polygon refined = refined_at(scheme, {value}, *data, levels_of(scheme), stop);
    const std::vector<double> curvature_values = curvatures(refined);
    std::vector<PlotPoint> curve, graph;
    double length = 0;
    for (std::size_t i = 0; i < refined.size(); ++i) {
      if (i > 0) length += distance(refined[i - 1], refined[i]);
      curve.push_back({refined[i][0], refined[i][1]});
      graph.push_back({length, curvature_values[i]});
      points += fmt::format("{},{:.9g},{:.9g}\n", to_string(value), curve.back().x, curve.back().y);
      values += fmt::format("{},{:.9g},{:.9g}\n", to_string(value), length, curvature_values[i]);
    }
    curves.items.push_back(PlotCurve{std::move(curve), {palette(static_cast<std::size_t>(k) + 1), 0.8, Dash::solid}});
    curvature.items.push_back(PlotCurve{std::move(graph), {palette(static_cast<std::size_t>(k) + 1), 0.7, Dash::solid}});
    words += fmt::format("{}${}$ ({})", k == 0 ? "" : k == 2 ? " and " : ", ", point_latex(scheme.parameter_names(), std::vector{value}), names[k]);
  }
  return Figure{.name = scheme.name + "-curvature",
                .panels = {{curves, points}, {curvature, values}},
                .caption = rich(fmt::format("A polygon with sides of equal length after ${}$ steps for {}, where the scheme is $C^{{{}}}$: the curves, and their curvatures by length.", levels_of(scheme), words, smoothness))};
}

std::optional<Figure> square_figure(const ReportedScheme& reported, const std::vector<Rational>& point, const std::filesystem::path& polygons, const Stop& stop) {
  const Scheme& scheme = reported.scheme;
  const std::optional<Polygon> data = polygon_of(polygons, "square.csv", true);
  // Schemes with four points, for which the square's sides need not stay convex.
  if (scheme.mask.arity != 2 || scheme.mask.symbol.is_zero() || scheme.mask.symbol.highest() - scheme.mask.symbol.lowest() != 6 || !data) return std::nullopt;
  const Polygon refined = refined_at(scheme, point, *data, 6, stop);
  Plot whole = small_plot(""), side = small_plot("");
  whole.frame = false;
  whole.equal_aspect = true;
  whole.width = whole.height = 110;
  std::vector<PlotPoint> corners, curve, bottom;
  for (std::size_t i = 0; i < data->size(); ++i) corners.push_back({(*data)[i][0], (*data)[i][1]});
  double deepest = 0;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    curve.push_back({refined[i][0], refined[i][1]});
    if (i <= refined.size() / data->size()) bottom.push_back(curve.back());
  }
  for (const PlotPoint& p : bottom) deepest = std::max(deepest, std::abs(p.y));
  whole.items.push_back(PlotCurve{corners, {{150, 150, 150}, 0.4, Dash::dashed}, true});
  whole.items.push_back(PlotCurve{curve, {palette(1), 0.9, Dash::solid}, true});
  whole.items.push_back(PlotMarkers{corners, palette(0), 1.2});
  // The part about the middle of the side, stretched.
  std::vector<PlotPoint> middle;
  for (const PlotPoint& p : bottom) {
    if (p.x >= 1 && p.x <= 3) middle.push_back(p);
  }
  if (middle.empty() || deepest == 0) return std::nullopt;
  side.width = 190;
  side.items.push_back(PlotCurve{middle, {palette(1), 0.9, Dash::solid}});
  side.items.push_back(PlotMarkers{middle, palette(1), 0.8});
  side.x = {"$x$", 1.0, 3.0};
  side.y.label = "$y$";
  return Figure{.name = scheme.name + "-square",
                .panels = {{whole, to_csv(refined)}, {side, csv("x,y", middle)}},
                .caption = rich(fmt::format("A square after six steps{}, and the middle of its lower side with the vertical scale stretched.", at_text(scheme, point)))};
}

}  // namespace limes::report_impl
