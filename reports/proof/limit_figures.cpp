// Basic limit functions, their derivatives, and norms by level. Limits are computed in double precision, norms exactly.
#include "algebra/error.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "geometry/refine_polygon.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes::report_impl {
namespace {

/// Values of the basic limit function's data after some levels: element k belongs to (first + k) / p^levels.
struct LevelData {
  long first = 0;
  double step = 1;
  std::vector<double> values;
};

template <class RuleAt>
LevelData cascade(const RuleAt& rule_at, int levels) {
  LevelData data{0, 1, {1}};
  for (int level = 0; level < levels; ++level) {
    const UniformRule& rule = rule_at(level);
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

/// Divided differences that have no limit, at three levels.
template <class RuleAt>
Plot failure_plot(const RuleAt& rule_at, int fine, int order, std::string& data) {
  Plot plot = small_plot(fmt::format("differences of order {}", order));
  const std::pair<int, Stroke> curves[] = {{fine, {palette(6), 0.5, Dash::solid}}, {fine - 1, {palette(5), 0.5, Dash::solid}}, {std::max(1, fine - 2), {palette(0), 0.7, Dash::solid}}};
  for (const auto& [level, stroke] : curves) {
    const std::vector<PlotPoint> points = divided_differences(cascade(rule_at, level), order);
    plot.items.push_back(PlotCurve{points, stroke});
    data += csv(fmt::format("x,value at level {}", level), points);
  }
  return plot;
}

}  // namespace

std::optional<Figure> limit_function_figure(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness) {
  const UniformRule rule = approx_uniform_rule(reported.scheme.mask, point);
  const auto the_rule = [&](int) -> const UniformRule& { return rule; };
  const int last = std::clamp(smoothness, 0, 8);
  Figure figure{.name = reported.scheme.name + "-limit", .panels = {}, .caption = {}};
  std::vector<int> orders{0};
  if (last > 0) orders.push_back(last);
  for (const int order : orders) {
    Plot plot = small_plot(derivative_name(order));
    const std::vector<PlotPoint> points = divided_differences(cascade(the_rule, levels_for(rule, 700)), order);
    plot.items.push_back(PlotCurve{points, {palette(1), 0.9, Dash::solid}});
    figure.panels.push_back({plot, csv("x,value", points)});
  }
  const int fine = levels_for(rule, 380);
  std::string data;
  figure.panels.push_back({failure_plot(the_rule, fine, last + 1, data), ""});
  figure.panels.back().data = data;
  figure.caption = rich(fmt::format("The basic limit function $\\varphi${}{}, and the divided differences of order ${}$ of its data at the levels ${}$, ${}$ and ${}$ (black to coloured){}.",
                                    at_text(reported.scheme, point), last > 0 ? fmt::format(", its derivative of order ${}$", last) : "", last + 1, std::max(1, fine - 2), fine - 1, fine,
                                    smoothness >= 0 ? ": a continuous derivative of this order would be their limit" : ""));
  return figure;
}

std::optional<Figure> angles_figure(const ReportedScheme& reported, int smoothness, const Stop& stop) {
  const Scheme& scheme = reported.scheme;
  const MaskSequence& sequence = *scheme.sequence;
  struct Angle {
    AngleType type;
    Rational theta;
    std::string name;
  };
  std::vector<Angle> angles;
  const auto add = [&](AngleType type, const Rational& theta, const std::string& name) {
    const MaskSequence::Range* range = sequence.find(type);
    if (range && range->angles.contains(theta)) angles.push_back({type, theta, name});
  };
  add(AngleType::trigonometric, 0, "polynomial, $\\theta=0$");
  add(AngleType::trigonometric, 1, "trigonometric, $\\theta=1$");
  add(AngleType::trigonometric, Rational(5) / 2, "trigonometric, $\\theta=5/2$");
  add(AngleType::hyperbolic, 3, "hyperbolic, $\\theta=3$");
  if (angles.size() < 2) return std::nullopt;
  const int order = std::max(smoothness, 0);
  Plot values = small_plot(derivative_name(0)), derivatives = small_plot(derivative_name(std::max(order, 1)));
  std::string value_data, derivative_data, words;
  const char* colours[] = {"black", "blue", "red", "green"};
  constexpr int levels = 6;
  std::optional<NonstationaryRule> wildest;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    stop.check();
    const NonstationaryRule rule = approx_nonstationary_rule(sequence, angles[k].type, angles[k].theta, levels);
    const auto rule_at = [&](int level) -> const UniformRule& { return rule.steps[static_cast<std::size_t>(level)]; };
    const LevelData data = cascade(rule_at, levels);
    const std::vector<PlotPoint> value = divided_differences(data, 0), derivative = divided_differences(data, std::max(order, 1));
    values.items.push_back(PlotCurve{value, {palette(k), 0.8, Dash::solid}});
    derivatives.items.push_back(PlotCurve{derivative, {palette(k), 0.8, Dash::solid}});
    value_data += csv(fmt::format("x,value for {} theta={}", to_string(angles[k].type), to_string(angles[k].theta)), value);
    derivative_data += csv(fmt::format("x,value for {} theta={}", to_string(angles[k].type), to_string(angles[k].theta)), derivative);
    words += fmt::format("{}{} ({})", k == 0 ? "" : k + 1 == angles.size() ? " and " : ", ", angles[k].name, colours[k]);
    if (angles[k].theta == 1) wildest = rule;
  }
  Figure figure{.name = scheme.name + "-angles", .panels = {{values, value_data}, {derivatives, derivative_data}}, .caption = {}};
  if (wildest) {
    const auto rule_at = [&](int level) -> const UniformRule& { return wildest->steps[static_cast<std::size_t>(level)]; };
    std::string data;
    figure.panels.push_back({failure_plot(rule_at, 5, order + 1, data), ""});
    figure.panels.back().data = data;
  }
  figure.caption = rich(fmt::format("The limit $\\varphi$ for the data of one point and {}: {}.{}", order > 0 ? fmt::format("its derivative of order ${}$", order) : "its divided differences", words,
                                    wildest ? fmt::format(" Right: for $\\theta=1$ the divided differences of order ${}$ at the levels $3$, $4$ and $5$ (black to coloured).", order + 1) : ""));
  return figure;
}

/// Exact norms by level.
std::optional<Figure> norms_figure(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness, const Stop& stop) {
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
  plot.x.ticks.emplace();
  for (int level = 1; level <= 9; level += 2) plot.x.ticks->push_back({double(level), std::to_string(level)});
  plot.y.label = "norm";
  plot.y.logarithmic = true;
  double longest = 1;
  for (const auto& [m, points] : curves) longest = std::max(longest, points.empty() ? 1 : points.back().x);
  std::erase_if(*plot.x.ticks, [&](const PlotTick& tick) { return tick.value > longest; });
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

}  // namespace limes::report_impl
