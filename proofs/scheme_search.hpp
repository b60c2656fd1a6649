#pragma once

#include "algebra/stop.hpp"
#include "analysis/nonuniform/spectrum_screen.hpp"
#include "proofs/proof_limits.hpp"
#include "proofs/verdict.hpp"
#include "schemes/scheme.hpp"

#include <optional>
#include <vector>

namespace limes {

/// One start of a search for parameter values of a non-uniform scheme that make it C^m.
struct SearchTrial {
  int start = 0;
  /// The greatest of the screen's radii at the parameter values below; the scheme cannot be C^m unless it is < 1 (up to rounding).
  double approx_radius = 0;
  /// Short rationals near the minimum that was found.
  std::vector<Rational> parameters;
  /// "C^m at these parameter values": nothing when the screen says no.
  std::optional<Verdict> verdict;
};

/// From a random point of the box, which depends on (seed, start) only, downhill over the greatest radius of the screen (smoothed
/// at first), then to rationals as short as the radius allows, then prove().
/// \pre a non-uniform scheme; the screen is that of its rule and of m. \throws Interrupted
SearchTrial search_trial(const Scheme& scheme, int m, const SpectrumScreen& screen, const Box& box, unsigned seed, int start,
                         const ProofLimits& limits, const Stop& stop);

}  // namespace limes
