// The plots of a scheme, with their data. Everything is computed here in double precision from the scheme, except the exact norms and the
// eigenvalues, which are enclosures.
#include "algebra/error.hpp"
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "geometry/curvature.hpp"
#include "geometry/io/csv.hpp"
#include "geometry/knots.hpp"
#include "geometry/refine_polygon.hpp"
#include "reports/plot/polygon_plot.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes::report_impl {
namespace {

constexpr double panel_width = 108, panel_height = 86;

std::string csv(const std::string& header, const std::vector<PlotPoint>& points) {
  std::string text = header + "\n";
  for (const PlotPoint& p : points) text += fmt::format("{:.12g},{:.12g}\n", p.x, p.y);
  return text;
}

Plot small_plot(const std::string& title) {
  Plot plot{.title = title, .x = {}, .y = {}, .items = {}};
  plot.width = panel_width;
  plot.height = panel_height;
  return plot;
}

/// Values of the basic limit function's data after some levels: element k belongs to (first + k) / p^levels.
struct LevelData {
  long first = 0;
  double step = 1;
  std::vector<double> values;
};

LevelData cascade(const UniformRule& rule, int levels) {
  LevelData data{0, 1, {1}};
  for (int level = 0; level < levels; ++level) {
    LevelData next{data.first * rule.arity + rule.first_index, data.step / rule.arity, {}};
    next.values.assign((data.values.size() - 1) * static_cast<std::size_t>(rule.arity) + rule.mask.size(), 0);
    for (std::size_t j = 0; j < data.values.size(); ++j) {
      for (std::size_t k = 0; k < rule.mask.size(); ++k) next.values[j * static_cast<std::size_t>(rule.arity) + k] += data.values[j] * rule.mask[k];
    }
    data = std::move(next);
  }
  return data;
}

/// Divided differences of an order, at the middle of their support.
std::vector<PlotPoint> divided_differences(LevelData data, int order) {
  data.values.insert(data.values.begin(), static_cast<std::size_t>(order), 0);
  data.values.insert(data.values.end(), static_cast<std::size_t>(order), 0);
  double factor = 1;
  for (int k = 0; k < order; ++k) {
    for (std::size_t i = 0; i + 1 < data.values.size(); ++i) data.values[i] = data.values[i + 1] - data.values[i];
    data.values.pop_back();
    factor /= data.step;
  }
  std::vector<PlotPoint> points;
  for (std::size_t k = 0; k < data.values.size(); ++k) {
    points.push_back({(static_cast<double>(data.first) - order + static_cast<double>(k) + 0.5 * order) * data.step, data.values[k] * factor});
  }
  return points;
}

int levels_for(const UniformRule& rule, double points) {
  const double support = static_cast<double>(rule.mask.size()) / (rule.arity - 1);
  return std::clamp(static_cast<int>(std::log(points / support) / std::log(rule.arity)), 2, 10);
}

std::string derivative_name(int order) { return order == 0 ? "$\\varphi$" : order == 1 ? "$\\varphi'$" : order == 2 ? "$\\varphi''$" : fmt::format("$\\varphi^{{({})}}$", order); }

std::string at_text(const Scheme& scheme, std::span<const Rational> point) {
  return scheme.parameters.empty() ? "" : fmt::format(" for ${}$", point_latex(scheme.parameter_names(), point));
}

/// phi, its last continuous derivative, and what happens to the next one.
std::optional<Figure> limit_function(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness) {
  const UniformRule rule = approx_uniform_rule(reported.scheme.mask, point);
  const int last = std::clamp(smoothness, 0, 8);
  Figure figure{.name = reported.scheme.name + "-limit", .panels = {}, .caption = {}};
  std::vector<int> orders{0};
  if (last > 0) orders.push_back(last);
  for (const int order : orders) {
    Plot plot = small_plot(derivative_name(order));
    const std::vector<PlotPoint> points = divided_differences(cascade(rule, levels_for(rule, 700)), order);
    plot.items.push_back(PlotCurve{points, {palette(1), 1, Dash::solid}});
    figure.panels.push_back({plot, csv("x,value", points)});
  }
  Plot plot = small_plot(fmt::format("divided differences, order {}", last + 1));
  const int fine = levels_for(rule, 380);
  std::string data;
  const std::pair<int, Stroke> curves[] = {{fine, {palette(6), 0.6, Dash::solid}}, {fine - 1, {palette(5), 0.6, Dash::solid}}, {std::max(1, fine - 2), {palette(0), 0.8, Dash::solid}}};
  for (const auto& [level, stroke] : curves) {
    const std::vector<PlotPoint> points = divided_differences(cascade(rule, level), last + 1);
    plot.items.push_back(PlotCurve{points, stroke});
    data += csv(fmt::format("x,value at level {}", level), points);
  }
  figure.panels.push_back({plot, data});
  figure.caption = rich(fmt::format("The basic limit function $\\varphi${}{}, and the divided differences of order ${}$ of its data at the levels ${}$, ${}$ and ${}$ (black to coloured){}.",
                                    at_text(reported.scheme, point), last > 0 ? fmt::format(", its derivative of order ${}$", last) : "", last + 1, std::max(1, fine - 2), fine - 1, fine,
                                    smoothness >= 0 ? ": a continuous derivative of this order would be their limit" : ""));
  return figure;
}

/// Exact norms by level.
std::optional<Figure> norms(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness, const Stop& stop) {
  if (smoothness < 0) return std::nullopt;
  const Mask mask = at(reported.scheme.mask, point);
  std::vector<std::pair<int, std::vector<PlotPoint>>> curves;
  std::string data = "order,level,exact,decimal\n";
  for (const int m : {smoothness, smoothness + 1}) {
    const std::optional<LaurentPolynomial> b = difference_symbol(mask, m + 1);
    if (!b) continue;
    std::vector<PlotPoint> points;
    for (int level = 1; level <= 9; ++level) {
      try {
        const Rational norm = exact_contractivity_norm(*b, mask.arity, level, stop, 4e6);
        if (norm == 0) break;
        points.push_back({static_cast<double>(level), approx_double(norm)});
        data += fmt::format("{},{},{},{}\n", m, level, to_string(norm), to_decimal(norm, 12, Rounding::nearest));
        if (norm < Rational(1) / 20 || norm > 1000) break;
      } catch (const LimitError&) {
        break;
      }
    }
    curves.emplace_back(m, points);
  }
  if (curves.empty() || curves.front().second.size() < 2) return std::nullopt;
  Plot plot = small_plot("");
  plot.x.label = "level $l$";
  plot.y.label = "norm";
  plot.y.logarithmic = true;
  double longest = 1;
  for (const auto& [m, points] : curves) longest = std::max(longest, points.empty() ? 1 : points.back().x);
  plot.items.push_back(PlotCurve{{{1, 1}, {longest, 1}}, {palette(0), 0.5, Dash::dashed}});
  std::size_t colour = 1;
  std::string words;
  for (const auto& [m, points] : curves) {
    plot.items.push_back(PlotCurve{points, {palette(colour), 1, Dash::solid}});
    plot.items.push_back(PlotMarkers{points, palette(colour), 1.4});
    words += fmt::format("{}for $C^{{{}}}$ ({})", colour > 1 ? " and " : "", m, colour == 1 ? "blue" : "red");
    ++colour;
  }
  return Figure{.name = reported.scheme.name + "-norms", .panels = {{plot, data}},
                .caption = rich(fmt::format("The norm $\\lVert S_b^l\\rVert_\\infty$ by level{}, {}; below the dashed line it proves the smoothness.", at_text(reported.scheme, point), words))};
}

struct Spectrum {
  Rational gamma;
  std::vector<ComplexRoot> roots;
};

/// The eigenvalues of L(gamma) without one simple 2^{-k} for each k = 0..m.
std::vector<ComplexRoot> remaining_eigenvalues(const SubdivisionMatrix& matrix, std::vector<Rational> point, const Rational& gamma, int smoothness) {
  point.push_back(gamma);
  Polynomial chi = characteristic_polynomial(matrix.at(point));
  for (int k = 0; k <= smoothness; ++k) {
    const auto [quotient, remainder] = divide(chi, Polynomial({-power(Rational(2), -k), 1}));
    if (remainder.is_zero()) chi = quotient;
  }
  return enclose_complex_roots(chi, 40);
}

PlotPoint approx_point(const ComplexRoot& root) { return {approx_double(root.re.midpoint()), approx_double(root.im.midpoint())}; }

/// Eigenvalues in the disc of radius 2^{-m}, and as functions of gamma.
std::optional<Figure> eigenvalues(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness, const Stop& stop) {
  if (!reported.scheme.insertion_rule || smoothness < 0) return std::nullopt;
  Box box;
  for (const Rational& x : point) box.push_back(Interval::point(x));
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*reported.scheme.insertion_rule, box));
  const double rho = std::pow(2.0, -smoothness);
  Figure figure{.name = reported.scheme.name + "-eigenvalues", .panels = {}, .caption = {}};

  Plot disc = small_plot("");
  disc.equal_aspect = true;
  disc.width = disc.height = 130;
  std::vector<PlotPoint> circle;
  for (int k = 0; k < 96; ++k) circle.push_back({rho * std::cos(2 * std::numbers::pi * k / 96), rho * std::sin(2 * std::numbers::pi * k / 96)});
  disc.items.push_back(PlotRegion{{circle}, {238, 243, 248}});
  disc.items.push_back(PlotCurve{circle, {palette(0), 0.6, Dash::solid}, true});
  disc.x = {"Re", -1.12 * rho, 1.12 * rho};
  disc.y = {"Im", -1.12 * rho, 1.12 * rho};
  std::string data = "gamma,re,im,modulus,multiplicity\n";
  double radius = 2.6;
  const std::vector<std::pair<Rational, Color>> ratios{{1, palette(0)}, {Rational(1) / 4, palette(1)}, {Rational(1) / 20, palette(2)}};
  for (const auto& [gamma, color] : ratios) {
    std::vector<PlotPoint> places;
    for (const ComplexRoot& root : remaining_eigenvalues(matrix, point, gamma, smoothness)) {
      places.push_back(approx_point(root));
      data += fmt::format("{},{},{},{},{}\n", to_string(gamma), to_decimal(root.re.midpoint(), 9, Rounding::nearest), to_decimal(root.im.midpoint(), 9, Rounding::nearest),
                          to_decimal(root.modulus.midpoint(), 9, Rounding::nearest), root.multiplicity);
    }
    disc.items.push_back(PlotMarkers{places, color, radius});
    radius -= 0.8;  // those that coincide stay visible
  }
  figure.panels.push_back({disc, data});

  // Real eigenvalues and moduli of the others by gamma, as dots: curves that meet need no order.
  Plot curves = small_plot("");
  curves.width = 190;
  curves.height = 130;
  curves.x = {"$\\gamma$", 0.0, 1.0};
  curves.y = {"$\\lambda$", -1.12 * rho, 1.12 * rho};
  curves.items.push_back(PlotRegion{{{{0, -rho}, {1, -rho}, {1, rho}, {0, rho}}}, {238, 243, 248}});
  std::vector<PlotPoint> real, moduli;
  std::string curve_data = "gamma,kind,value\n";
  for (int k = 1; k <= 60; ++k) {
    stop.check();
    const Rational gamma = Rational(k * k) / 3600;  // denser where roots move fast
    for (const ComplexRoot& root : remaining_eigenvalues(matrix, point, gamma, smoothness)) {
      if (!root.is_real() && root.im.upper < 0) continue;
      const double value = approx_double(root.is_real() ? root.re.midpoint() : root.modulus.midpoint());
      (root.is_real() ? real : moduli).push_back({approx_double(gamma), value});
      curve_data += fmt::format("{},{},{:.9g}\n", to_string(gamma), root.is_real() ? "real" : "modulus of a complex pair", value);
    }
  }
  curves.items.push_back(PlotMarkers{real, palette(3), 0.8});
  curves.items.push_back(PlotMarkers{moduli, palette(2), 0.8});
  figure.panels.push_back({curves, curve_data});
  figure.caption = rich(fmt::format(
      "The eigenvalues of $L(\\gamma)$ besides $1,\\dots,2^{{-{0}}}${1}. Left: in the disc of radius $2^{{-{0}}}$ for $\\gamma=1$ (black), $1/4$ (blue), $1/20$ (red). Right: real eigenvalues (green) and "
      "moduli of complex pairs (red) against $\\gamma$.",
      smoothness, at_text(reported.scheme, point)));
  return figure;
}

std::optional<Figure> comb(const ReportedScheme& reported, const std::vector<Rational>& point, const std::filesystem::path& polygons, const Stop& stop) {
  std::error_code error;
  const std::filesystem::path file = polygons / "beetle.csv";
  if (polygons.empty() || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const Polygon data = polygon_from(read_csv_file(file), true);
  const Scheme& scheme = reported.scheme;
  const bool nonuniform = scheme.insertion_rule.has_value();
  const int levels = scheme.mask.arity == 2 ? 5 : 3;
  Polygon refined = data;
  if (nonuniform) {
    refined = refine_polygon(data.with_knots(spaced_knots(data, KnotSpacing::centripetal)), approx_nonuniform_rule(*scheme.insertion_rule, point), {.levels = levels}, stop);
  } else {
    refined = refine_polygon(data, approx_uniform_rule(scheme.mask, point), {.levels = levels}, stop);
  }
  // The longest tooth that is not an outlier is as long as a tenth of the picture.
  std::vector<double> sizes;
  for (const double c : curvatures(refined)) sizes.push_back(std::abs(c));
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  double extent = 0;
  for (std::size_t i = 0; i < data.size(); ++i) extent = std::max(extent, distance(data[0], data[i]));
  const double typical = sorted[sorted.size() * 95 / 100];
  if (!(typical > 0) || !std::isfinite(typical)) return std::nullopt;
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
  plot.width = 260;
  plot.height = 120;
  return Figure{.name = scheme.name + "-comb",
                .panels = {{plot, to_csv(refined)}},
                .caption = rich(fmt::format("A closed polygon after ${}$ steps{}{}, with its curvature comb (teeth beyond $2.5$ times a typical length are cut off).", levels,
                                            at_text(scheme, point), nonuniform ? " over centripetal knots" : ""))};
}

}  // namespace

std::vector<Rational> simple_point(const Box& box) {
  std::vector<Rational> point;
  for (const Interval& x : box) {
    const Rational quarter = x.width() / 4;
    point.push_back(x.is_point() ? x.lower : simplest_between(x.lower + quarter, x.upper - quarter));
  }
  return point;
}

std::vector<Rational> shown_point(const ReportedScheme& reported) {
  const Box* best = nullptr;
  int smoothness = -1;
  for (const DecidedClaim& decided : reported.claims) {
    const Claim& claim = decided.claim;
    if (claim.negated || claim.space || claim.subject != ClaimSubject::limits || decided.verdict.outcome != Outcome::certified) continue;
    // Of equal smoothness a region rather than a point, and the larger one.
    const bool wider = best && claim.smoothness == smoothness && !claim.region.empty() && claim.region.front().width() > best->front().width();
    if (claim.smoothness > smoothness || wider) best = &claim.region, smoothness = claim.smoothness;
  }
  const Box region = best ? *best : reported.scheme.parameter_box();
  return simple_point(region);
}

int certified_smoothness(const ReportedScheme& reported, std::span<const Rational> point) {
  int smoothness = -1;
  for (const DecidedClaim& decided : reported.claims) {
    if (decided.claim.negated || decided.claim.space || decided.claim.subject != ClaimSubject::limits || decided.verdict.outcome != Outcome::certified || !contains(decided.claim.region, point)) continue;
    smoothness = std::max(smoothness, decided.claim.smoothness);
  }
  return smoothness;
}

Blocks scheme_figures(const ReportedScheme& reported, const std::filesystem::path& polygons, const Stop& stop) {
  if (reported.scheme.surface) return surface_figures(reported);
  if (reported.scheme.kind != SchemeKind::uniform && !reported.scheme.insertion_rule) return {};
  const std::vector<Rational> point = shown_point(reported);
  const int smoothness = certified_smoothness(reported, point);
  Blocks blocks;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) blocks.push_back(std::move(*figure));
  };
  try {
    add(limit_function(reported, point, smoothness));
    add(eigenvalues(reported, point, smoothness, stop));
    std::optional<Figure> norm = norms(reported, point, smoothness, stop), teeth = comb(reported, point, polygons, stop);
    // Both are narrow: one figure.
    if (norm && teeth) {
      norm->panels.push_back(std::move(teeth->panels.front()));
      norm->caption = rich("Left: ") + norm->caption + rich(" Right: ") + teeth->caption;
      teeth.reset();
    }
    add(std::move(norm));
    add(std::move(teeth));
  } catch (const DomainError&) {
    // A pole at the shown point: no pictures.
  }
  return blocks;
}

}  // namespace limes::report_impl
