#include "analysis/nonstationary/level_range.hpp"

#include "algebra/number/elementary.hpp"
#include "algebra/polynomial/bernstein_form.hpp"

namespace limes {
namespace {

Interval enclosure(AngleType type, const Rational& x) {
  return type == AngleType::trigonometric ? cos_enclosure(x) : cosh_enclosure(x);
}

/// Whether the mask has no pole on an interval of mu.
bool is_defined(const Mask& mask, const Interval& mu) {
  return prove_strict_sign(common_denominator(mask.symbol), {mu}) != 0;
}

}  // namespace

Interval level_range(int arity, AngleType type, const Interval& angles, int k, int divisor) {
  const Rational scale = power(Rational(arity), -(k + 1)) / divisor;
  // Seen from the end at 1: the smaller angle.
  const Interval near = enclosure(type, angles.lower * scale), far = enclosure(type, angles.upper * scale);
  const bool open = angles.lower == 0 && angles.lower_open;
  if (angles.is_point()) return near;
  if (type == AngleType::trigonometric) return {far.lower, near.upper, false, open};
  return {near.lower, far.upper, open, false};
}

Interval tail_range(int arity, AngleType type, const Interval& angles, int k) {
  if (angles.upper == 0) {
    const Rational some(1, 1024);
    return type == AngleType::trigonometric ? Interval{1 - some, 1} : Interval{1, 1 + some};
  }
  return level_range(arity, type, {0, angles.upper}, k);
}

std::optional<int> uniform_level(const MaskSequence& sequence, AngleType type, const Interval& angles) {
  constexpr int max_level = 64;
  const CommonDenominator common = over_common_denominator(sequence.mask.symbol);
  for (int k = 0; k <= max_level; ++k) {
    const Interval tail = tail_range(sequence.mask.arity, type, angles, k);
    if (k >= static_cast<int>(sequence.first_levels.size()) &&
        BernsteinForm(common.denominator, {tail}).strict_sign() > 0)
      return k;
    if (!is_defined(sequence.at_level(k), level_range(sequence.mask.arity, type, angles, k))) return std::nullopt;
  }
  return std::nullopt;
}

CommonDenominator over_common_denominator(const LaurentPolynomial& symbol) {
  CommonDenominator result{common_denominator(symbol), {}};
  if (result.denominator(std::array<Rational, 1>{1}) < 0) result.denominator = -result.denominator;
  result.numerators = numerators_over(symbol, result.denominator);
  return result;
}

}  // namespace limes
