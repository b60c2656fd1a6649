#include "schemes/surface/surface_rule.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

/// Calls a function of every mask of a sequence; errors name the curve scheme.
template <class Function>
void for_all_masks(const std::string& curve, const MaskSequence& sequence, Function&& function) {
  try {
    function(sequence.mask);
    for (const Mask& mask : sequence.first_levels) function(mask);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", curve, error.reason()));
  }
}

}  // namespace

RingRule SurfaceRule::rings_at_level(int k) const {
  if (virtual_points) return virtual_point_rule(sequence.at_level(k));
  RingRule rule = tensor_rule(sequence.at_level(k));
  rule.given = rings.given;
  return rule;
}

MaskSequence constant_sequence(const Mask& mask) {
  if (mask.symbol.variables() > 0) throw InputError("the curve scheme of a surface scheme has no parameters");
  std::vector<RationalFunction> coefficients;
  for (const RationalFunction& c : mask.symbol.coefficients()) coefficients.push_back(RationalFunction::constant(1, c.constant_value()));
  MaskSequence sequence;
  sequence.types = {{AngleType::trigonometric, Interval::point(0)}};
  sequence.mask = {mask.arity, LaurentPolynomial(1, mask.symbol.is_zero() ? 0 : mask.symbol.lowest(), std::move(coefficients))};
  return sequence;
}

SurfaceRule surface_rule(std::string curve, MaskSequence sequence) {
  RingRule rings;
  for_all_masks(curve, sequence, [](const Mask& mask) { virtual_point_rule(mask); });
  rings = virtual_point_rule(sequence.mask);
  return {std::move(curve), std::move(sequence), true, std::move(rings)};
}

SurfaceRule surface_rule(std::string curve, MaskSequence sequence, std::map<RingPoint, std::vector<RingTerm>> given) {
  RingRule rings;
  for_all_masks(curve, sequence, [&](const Mask& mask) {
    RingRule rule = tensor_rule(mask);
    if (!rule.dual && given.contains({0, 0})) {
      for (const RingTerm& t : given.at({0, 0})) {
        if (t.point != RingPoint{} && t.harmonic != 0) throw InputError("the rule of the vertex 0,0 consists of at(0,0) and means");
      }
    }
    rule.given = given;
    // One ring more than the invariant ones has rules, too: limit patches need it.
    rule.invariant_rings(rule.invariant_rings() + 1);
    if (rings.given.empty()) rings = std::move(rule);
    else if (rings.dual != rule.dual) throw InputError("its masks are primal and dual");
  });
  return {std::move(curve), std::move(sequence), false, std::move(rings)};
}

}  // namespace limes
