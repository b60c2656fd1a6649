#include "geometry/strip_impl.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace limes {
namespace {

using geometry_impl::Strip;
using geometry_impl::Support;

/// The coefficients of x y, both from the constant coefficient on.
std::vector<double> product(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> result(x.size() + y.size() - 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) result[i + j] += x[i] * y[j];
  }
  return result;
}

/// What all steps together depend on.
Support common_support(const NonstationaryRule& rule) {
  const UniformRule& first = rule.steps.front();
  Support support{first.arity, first.first_index, first.last_index(), 0, 0, first.interpolatory_index.has_value(), {}};
  for (const UniformRule& step : rule.steps) {
    if (step.arity != first.arity) throw DomainError("the steps of a scheme have one arity");
    support.lowest = std::min(support.lowest, step.first_index);
    support.highest = std::max(support.highest, step.last_index());
    support.points = std::max(support.points, step.points());
    support.interpolatory = support.interpolatory && step.interpolatory_index == first.interpolatory_index;
  }
  support.centre_twice = support.interpolatory ? 2 * *first.interpolatory_index : support.lowest + support.highest;
  return support;
}

}  // namespace

NonstationaryRule approx_nonstationary_rule(const MaskSequence& sequence, AngleType type, const Rational& angle,
                                            int levels) {
  NonstationaryRule rule;
  double x = approx_double(angle);
  for (int k = 0; k < levels; ++k) {
    x /= sequence.mask.arity;
    const double mu = type == AngleType::trigonometric ? std::cos(x) : std::cosh(x);
    // What a difference of nearly equal numbers would lose is not lost: only mu is rounded.
    try {
      rule.steps.push_back(approx_uniform_rule(sequence.at_level(k), std::array<Rational, 1>{Rational(mu)}));
    } catch (const DomainError& error) {
      throw DomainError(fmt::format("step {}, {} = {}: {}", k + 1, sequence.level_parameter, mu, error.what()));
    }
  }
  return rule;
}

std::vector<double> approx_continuation(const std::vector<ExponentialFunction>& space, double angle) {
  using Wave = ExponentialFunction::Wave;
  // A sequence u(0), u(1), .. is annihilated by the product of z - 1, or z^2 - 2 cos(m theta) z + 1, z being the shift.
  std::vector<double> annihilator{1};
  for (const ExponentialFunction& f : space) {
    const double x = f.frequency * angle;
    if (f.wave == Wave::none) annihilator = product(annihilator, {1, -1});
    if (f.wave == Wave::cos) annihilator = product(annihilator, {1, -2 * std::cos(x), 1});
    if (f.wave == Wave::cosh) annihilator = product(annihilator, {1, -2 * std::cosh(x), 1});
  }
  std::vector<double> weights(annihilator.begin() + 1, annihilator.end());
  for (double& w : weights) w = -w;
  return weights;
}

Polygon refine_polygon(const Polygon& polygon, const NonstationaryRule& rule, const Refinement& refinement,
                       const Stop& stop) {
  if (refinement.levels > static_cast<int>(rule.steps.size())) throw DomainError("fewer steps than levels");
  if (refinement.levels == 0) return {polygon.dimension(), polygon.coordinates(), polygon.closed()};
  Support support = common_support(rule);
  if (refinement.ends == EndRule::exact) {
    if (rule.continuation.empty()) throw DomainError("exact ends need a continuation");
    support.continuation = rule.continuation;
  }
  Strip strip =
      geometry_impl::refined_strip(polygon, support, refinement, stop, [&](const Strip& from, Strip& to, int level) {
        geometry_impl::refine_level(rule.steps[static_cast<std::size_t>(level - 1)], from, to);
      });
  return {polygon.dimension(), std::move(strip.coordinates), polygon.closed()};
}

}  // namespace limes
