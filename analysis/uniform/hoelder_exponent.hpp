#pragma once

#include "analysis/spectral_radius/spectral_radius_bounds.hpp"
#include "analysis/uniform/stability.hpp"

#include <string>

namespace limes {

/// An enclosure; an end that is not proved is missing.
struct ExponentBounds {
  std::optional<Rational> lower;
  std::optional<Rational> upper;
};

/// The Hoelder exponent of a uniform scheme: the supremum of m + gamma, 0 <= gamma <= 1, such that all limits have m derivatives, the last
/// one with exponent gamma. (Theorem U3 of docs/theory.md.)
struct HoelderExponent {
  /// The greatest k with sigma^k | a.
  int order = 0;
  std::optional<Stability> stability;
  /// Of the difference sections B_0 .. B_{p-1} of a = sigma^k p^{-(k-1)} b: the exponent is (k-1) - log_p of it, if the shifts are stable.
  SpectralRadiusBounds radius;
  /// radius.upper is a bound of ||S_b^l||^{1/l} for this l, not of radius.blocks.
  std::optional<int> level;
  ExponentBounds bounds;
  /// The exact exponent when it is rational.
  std::optional<Rational> exact;
  /// The greatest s with limits in the Sobolev space W_2^s locally, from the spectral radius of the transition operator.
  ExponentBounds sobolev;
  /// Why there is no lower bound: "a(1) is not p", ...
  std::string reason;
};

/// The sections B_e of the difference scheme of order k. \pre sigma^k | a, no parameters
MatrixFamily difference_sections(const Mask& mask, int order);

/// \param digits the width aimed at is 10^-digits
/// \pre the mask has no parameters. \throws InternalError when bounds contradict each other
HoelderExponent bound_hoelder_exponent(const Mask& mask, int digits, const PolytopeLimits& limits, const Stop& stop);

}  // namespace limes
