#include "reports/unity/weight_figures_impl.hpp"

#include "geometry/refine_polygon.hpp"
#include "reports/proof/figures_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace limes::unity_impl {
namespace {

using report_impl::csv;
using report_impl::small_plot;

constexpr int samples = 400;

std::vector<double> grid(double lower, double upper) {
  std::vector<double> points;
  for (int k = 0; k <= samples; ++k) points.push_back(lower + (upper - lower) * k / samples);
  return points;
}

std::vector<PlotPoint> zip(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<PlotPoint> points;
  for (std::size_t k = 0; k < x.size(); ++k) points.push_back({x[k], y[k]});
  return points;
}

/// sum_k c_k w(2u - s_k) at the points, with the scheme's own mask.
std::vector<double> refined_weight(const Scheme& scheme, const RefinementEquation& equation, const std::vector<double>& points) {
  std::vector<double> sum(points.size(), 0);
  for (int k = 0; k < equation.count; ++k) {
    const double c = approx_double(scheme.mask.symbol.coefficient(equation.first_index() + k).constant_value());
    if (c == 0) continue;
    std::vector<double> dilated;
    for (const double u : points) dilated.push_back(2 * u - approx_double(equation.first_shift) - k);
    const std::vector<double> values = approx_values(equation.weight, dilated);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += c * values[i];
  }
  return sum;
}

/// w(u) / sum_i w(u - i).
std::vector<double> normalised_weight(const WeightFunction& weight, const std::vector<double>& points) {
  const int reach = static_cast<int>(std::ceil(approx_double(weight.support().width()))) + 1;
  std::vector<double> sum(points.size(), 0);
  for (int i = -reach; i <= reach; ++i) {
    std::vector<double> moved(points);
    for (double& u : moved) u -= i;
    const std::vector<double> values = approx_values(weight, moved);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += values[k];
  }
  std::vector<double> result = approx_values(weight, points);
  for (std::size_t k = 0; k < sum.size(); ++k) result[k] /= sum[k];
  return result;
}

/// Points of the projective scheme after some levels for one point 1 among zeros, against the parameter of the weight function: the level's index i
/// belongs to w(2^k u - i - (2^k - 1) delta), delta the fractional part of the shifts.
std::vector<PlotPoint> projective_limit(const Scheme& scheme, const RefinementEquation& equation) {
  constexpr int levels = 7;
  const UniformRule rule = approx_uniform_rule(scheme.mask, {});
  const long half = static_cast<long>(rule.mask.size()) + 2;
  std::vector<double> weights(static_cast<std::size_t>(2 * half + 1), 1.0), values(weights.size(), 0.0);
  values[static_cast<std::size_t>(half)] = 1;
  long first = -half;
  for (int level = 0; level < levels; ++level) {
    // Only indices that depend on no weights beyond the ends.
    const long length = static_cast<long>(rule.mask.size()), next_first = 2 * first + rule.first_index + length - 1;
    const long next_last = 2 * (first + static_cast<long>(weights.size()) - 1) + rule.first_index;
    std::vector<double> next_weights, next_values;
    for (long i = next_first; i <= next_last; ++i) {
      double y = 0, x = 0;
      for (long k = 0; k < length; ++k) {
        const long twice = i - rule.first_index - k;
        if (twice % 2 != 0) continue;
        const auto j = static_cast<std::size_t>(twice / 2 - first);
        y += rule.mask[static_cast<std::size_t>(k)] * weights[j];
        x += rule.mask[static_cast<std::size_t>(k)] * values[j];
      }
      next_weights.push_back(y);
      next_values.push_back(x);
    }
    weights = std::move(next_weights);
    values = std::move(next_values);
    first = next_first;
  }
  const double scale = std::ldexp(1.0, -levels), centre = approx_double(equation.weight.centre);
  const double delta = approx_double(equation.first_shift) - equation.first_index();
  std::vector<PlotPoint> points;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    points.push_back({(static_cast<double>(first) + static_cast<double>(k) + centre) * scale + delta * (1 - scale), values[k] / weights[k]});
  }
  const double lower = approx_double(equation.weight.support().lower), upper = approx_double(equation.weight.support().upper);
  std::erase_if(points, [&](const PlotPoint& p) { return p.x < lower || p.x > upper; });
  return points;
}

}  // namespace

Figure weight_figure(const Scheme& scheme, const WeightStudy& study) {
  const RefinementEquation& equation = study.derived.equation;
  const Stroke dashed{palette(0), 0.7, Dash::dashed}, solid{palette(1), 1, Dash::solid};
  const std::vector<double> points = grid(approx_double(equation.domain.lower), approx_double(equation.domain.upper));
  const std::vector<double> weight = approx_values(equation.weight, points), refined = refined_weight(scheme, equation, points);
  std::vector<double> residual(weight);
  for (std::size_t k = 0; k < residual.size(); ++k) residual[k] -= refined[k];

  Figure figure{.name = scheme.name + "-weight", .panels = {}, .caption = {}};
  Plot first = small_plot("$w$");
  first.items = {PlotCurve{zip(points, refined), solid}, PlotCurve{zip(points, weight), dashed}};
  figure.panels.push_back({first, csv("u,w", zip(points, weight)) + csv("u,refined", zip(points, refined))});
  const auto* polynomial = std::get_if<PiecewisePolynomial>(&equation.weight.shape);
  if (!polynomial || !polynomial->global) {
    const std::vector<PlotPoint> quotient = zip(points, normalised_weight(equation.weight, points)), limit = projective_limit(scheme, equation);
    Plot second = small_plot("limit");
    second.items = {PlotCurve{limit, solid}, PlotCurve{quotient, dashed}};
    figure.panels.push_back({second, csv("u,w over its sum", quotient) + csv("u,limit", limit)});
  }
  Plot third = small_plot("residual");
  third.items = {PlotCurve{zip(points, residual), solid}};
  figure.panels.push_back({third, csv("u,residual", zip(points, residual))});
  figure.caption = rich("The weight function $w$ (dashed) and its refinement $\\sum_kc_kw(2u-s_k)$; the quotient $w/\\sum_iw(u-i)$ (dashed) and the limit of the scheme that refines weights and divides by them, for one "
                        "point $1$ among zeros, after $7$ steps; the residual of the refinement equation.");
  return figure;
}

Figure cost_figure(const Scheme& scheme, const WeightStudy& study) {
  std::vector<PlotPoint> orders, exponents;
  for (const SmoothnessCost& cost : study.costs) {
    if (cost.error <= 0) continue;
    orders.push_back({static_cast<double>(cost.sum_rules), cost.error});
    if (cost.exponent.lower && (exponents.empty() || exponents.back().y != cost.error)) exponents.push_back({approx_double(*cost.exponent.lower), cost.error});
  }
  std::sort(exponents.begin(), exponents.end(), [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
  Figure figure{.name = scheme.name + "-cost", .panels = {}, .caption = rich("$E$ against the order of the sum rules, and against the certified lower bound of the Hölder exponent.")};
  const auto add = [&](const std::string& label, const std::string& header, const std::vector<PlotPoint>& points) {
    if (points.empty()) return;
    Plot plot = small_plot("");
    plot.x.label = label;
    plot.y.label = "$E$";
    plot.y.logarithmic = true;
    plot.items = {PlotCurve{points, {palette(1), 1, Dash::solid}}, PlotMarkers{points, palette(1), 1.6}};
    figure.panels.push_back({plot, csv(header, points)});
  };
  add("sum rules", "sum rules,E", orders);
  add("exponent", "exponent,E", exponents);
  return figure;
}

}  // namespace limes::unity_impl
