#pragma once

#include "analysis/nonuniform/root_dominance.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"

#include <string>
#include <vector>

namespace limes {

/// Root dominance for every factor of a split characteristic polynomial: all eigenvalues but 1, 1/2, .., 2^{-m} (once
/// each) have modulus < 2^{-m}, for all ratios gamma > 0 and all parameters of a region.
struct SpectrumDominance {
  struct Part {
    CharacteristicFactor factor;
    /// The factor is mirrored(): it stands for gamma >= 1. Only when the scheme is not symmetric.
    bool is_mirrored = false;
    RootDominance dominance;
  };
  bool proved = false;
  /// Those of ell, then those of r; up to the first that fails.
  std::vector<Part> parts;
  std::string reason;
};

/// Tests the factors one by one on region x (0, 1]; with gamma -> 1/gamma as a second pass when chi is not symmetric.
/// \param region the parameters' intervals, without gamma. \throws Interrupted
SpectrumDominance prove_spectrum_dominance(const SplitCharacteristicPolynomial& split, const Box& region,
                                           const RootDominanceOptions& options = {}, const Stop& stop = {});

}  // namespace limes
