#include "schemes/surface/surface_rule.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

namespace limes {

SurfaceRule surface_rule(std::string curve, MaskSequence sequence) {
  std::vector<const Mask*> masks{&sequence.mask};
  for (const Mask& mask : sequence.first_levels) masks.push_back(&mask);
  for (const Mask* mask : masks) {
    const auto& a = mask->symbol.coefficients();
    const bool four_points = mask->arity == 2 && mask->symbol.lowest() == -3 && a.size() == 7 && a[1].is_zero() && a[5].is_zero() &&
                             a[3] == RationalFunction::constant(a[3].variables(), 1) && a[0] == a[6] && a[2] == a[4];
    if (!four_points) throw InputError(fmt::format("{} is no symmetric interpolatory four-point scheme", curve));
  }
  return {std::move(curve), std::move(sequence)};
}

}  // namespace limes
