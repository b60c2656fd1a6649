#pragma once

#include "analysis/uniform/hoelder_exponent.hpp"
#include "schemes/scheme.hpp"

#include <string>

namespace limes {

/// The certificate of the bounds of a joint spectral radius (theorem JSR), deterministic byte by byte, accepted by limes-check.
/// \throws LimitError when the check would be too long; InternalError when limes-check rejects it
std::string prove_spectral_radius(const MatrixFamily& family, const SpectralRadiusBounds& bounds);

/// The certificate of the bounds of the Hoelder exponent of a scheme's mask at a parameter value (theorem U3), likewise.
/// \pre bounds.lower is there
std::string prove_hoelder_exponent(const Scheme& scheme, std::span<const Rational> point, const HoelderExponent& exponent);

struct ProvedExponent {
  HoelderExponent exponent;
  /// Empty without a lower bound.
  std::string certificate;
};

/// Bounds of the exponent at a parameter value with their certificate; where the exact value is too much for the checker, bounds without it.
/// \throws LimitError when these are too much, too
ProvedExponent bound_and_prove_hoelder_exponent(const Scheme& scheme, std::span<const Rational> point, int digits, const Stop& stop);

}  // namespace limes
