#pragma once

#include "analysis/surface/vertex_spectrum.hpp"
#include "schemes/scheme.hpp"

namespace limes {

/// At which level parameters the matrix of a surface scheme is looked at.
struct SpectrumSettings {
  /// The value of mu itself, if it was given, or the scheme has no angle, or the angle is 0 and every level the same.
  std::optional<Rational> mu;
  AngleType type = AngleType::trigonometric;
  /// Otherwise the angle of an edge, theta = rational + turns pi.
  Rational rational, turns;

  /// At level k. \pre k >= 0
  LevelParameter at_level(int k) const;
};

/// From "theta=pi/3", "type=hyperbolic" or "mu=1" (names as the curve scheme has them); without settings the limit mu = 1.
/// \throws InputError when the scheme is no surface scheme, a setting is no such thing or given twice, an angle is outside of the scheme's range
SpectrumSettings spectrum_settings(const Scheme& scheme, const std::vector<std::string>& settings);

}  // namespace limes
