#pragma once

#include "schemes/nonstationary/mask_sequence.hpp"

#include <array>
#include <optional>

namespace limes {

/// An interval that contains cos or cosh of theta p^{-(k+1)} / divisor for all angles theta of an interval: mu_k when the divisor
/// is 1. Ends of balls round outward; an end at theta = 0 is exactly 1, and open when theta = 0 is excluded.
/// \pre the angles belong to a range of the type, k >= 0, divisor >= 1
Interval level_range(int arity, AngleType type, const Interval& angles, int k, int divisor = 1);

/// An interval, not a point, that contains mu_j for all j >= k and its limit 1.
Interval tail_range(int arity, AngleType type, const Interval& angles, int k);

/// The least k, not less than the number of first levels, from which on the denominators of the mask are positive by one
/// Bernstein form on tail_range, every step before being defined at every angle too. Nothing when a pole may be in the way.
std::optional<int> uniform_level(const MaskSequence& sequence, AngleType type, const Interval& angles);

/// The common denominator D > 0 near mu = 1 of a mask in mu, and the numerators A_i = D a_i from the lowest index on.
struct CommonDenominator {
  MultivariatePolynomial denominator;
  std::vector<MultivariatePolynomial> numerators;
};
CommonDenominator over_common_denominator(const LaurentPolynomial& symbol);

}  // namespace limes
