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
  const LaurentPolynomial& symbol = sequence.mask.symbol;
  std::vector<RationalFunction> coefficients;
  for (const Rational& c : symbol.at(std::array<Rational, 1>{1}).rational_coefficients()) {
    coefficients.push_back(RationalFunction::constant(variables, c));
  }
  // at() drops zeros at the ends.
  const LaurentPolynomial limit = symbol.at(std::array<Rational, 1>{1});
  return {sequence.mask.arity, LaurentPolynomial(variables, limit.is_zero() ? 0 : limit.lowest(), std::move(coefficients))};
}

}  // namespace limes
