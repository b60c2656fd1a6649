#pragma once

#include "analysis/nonstationary/level_range.hpp"

#include <string>

namespace limes {

/// For all k >= from_level and all angles of an interval
///
///     || S_{c^(k)} - S_c ||_inf <= constant x_k^order,   x_k = theta p^{-(k+1)},
///
/// where c^(k) = p^j a^(k) / sigma^j with j = factors, sigma = 1 + z + .. + z^{p-1}, and c likewise from the limit mask a.
struct AsymptoticBound {
  int from_level = 0;
  int factors = 0;
  int order = 0;
  Rational constant;
};

struct AsymptoticAttempt {
  std::optional<AsymptoticBound> bound;
  /// Why there is none.
  std::string reason;
};

/// A bound with order > smoothness - factors, so that sum_k p^{(smoothness - factors) k} ||S_{c^(k)} - S_c|| is finite; with as few
/// factors as possible. c_i(mu) - c_i(1) = (mu - 1)^r h_i(mu) exactly, sum |h_i| is bounded by Bernstein coefficients on an
/// interval that contains mu_k for k >= from_level, and |mu_k - 1| <= x_k^2/2 (times cosh of the largest x_k): order = 2 r, the
/// least order of a derivative of some c_i(mu(x)) that does not vanish at 0.
AsymptoticAttempt bound_difference_to_limit(const MaskSequence& sequence, AngleType type, const Interval& angles,
                                            int smoothness);

}  // namespace limes
