#include "schemes/nonstationary/mask_sequence.hpp"

#include <algorithm>
#include <array>

namespace limes {

const Mask& MaskSequence::at_level(int k) const {
  return k < static_cast<int>(first_levels.size()) ? first_levels[static_cast<std::size_t>(k)] : mask;
}

const MaskSequence::Range* MaskSequence::find(AngleType type) const {
  const auto found = std::find_if(types.begin(), types.end(), [&](const Range& range) { return range.type == type; });
  return found == types.end() ? nullptr : &*found;
}

Mask limit_mask(const MaskSequence& sequence, int variables) {
  const LaurentPolynomial limit = sequence.mask.symbol.at(std::array<Rational, 1>{1});
  std::vector<RationalFunction> coefficients;
  for (const Rational& c : limit.rational_coefficients())
    coefficients.push_back(RationalFunction::constant(variables, c));
  return {sequence.mask.arity,
          LaurentPolynomial(variables, limit.is_zero() ? 0 : limit.lowest(), std::move(coefficients))};
}

}  // namespace limes
