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
    /// What was tested is mirrored(factor): it stands for gamma >= 1.
    bool is_mirrored = false;
    RootDominance dominance;
  };
  bool proved = false;
  /// Those of ell, then those of r; up to the first that fails.
  std::vector<Part> parts;
  std::string reason;
  /// Parameters, then gamma: a point at which a root of the last part has modulus >= 2^{-m}.
  std::optional<std::vector<Rational>> counterexample;
};

/// Tests the factors one by one on region x (0, 1]; with gamma -> 1/gamma as a second pass when `both_sides` are
/// wanted: at most where the rule is not mirror-symmetric. Stops at the first factor that fails.
/// \param region the parameters' intervals, without gamma. \throws Interrupted
SpectrumDominance prove_spectrum_dominance(const SplitCharacteristicPolynomial& split, const Box& region,
                                           bool both_sides, const RootDominanceOptions& options = {},
                                           const Stop& stop = {});

}  // namespace limes
