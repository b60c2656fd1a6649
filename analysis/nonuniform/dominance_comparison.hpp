#pragma once

#include "analysis/nonuniform/root_dominance.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"

#include <vector>

namespace limes {

/// What one method alone makes of one factor: it proves dominance in so many leaves, or cannot at a point (hopeless_point), or a
/// root is outside (counterexample), or the boxes did not suffice (none of these).
struct MethodResult {
  DominanceMethod method = DominanceMethod::rouche;
  bool proved = false;
  int leaves = 0;
  /// Parameters, then gamma; for a mirrored factor gamma stands for 1/gamma.
  std::optional<std::vector<Rational>> hopeless_point;
  std::optional<std::vector<Rational>> counterexample;
};

struct FactorComparison {
  CharacteristicFactor factor;
  bool in_ell = false;
  /// mirrored(factor) was tested: it stands for gamma >= 1.
  bool is_mirrored = false;
  /// The four methods, one by one.
  std::vector<MethodResult> methods;
};

/// Every method alone on every factor of ell and r, on region x (0, 1], and with 1/gamma for gamma when chi is not symmetric.
/// \param region the parameters' intervals, without gamma. \param max_boxes for one method and factor. \throws Interrupted
std::vector<FactorComparison> compare_dominance_methods(const SplitCharacteristicPolynomial& split, const Box& region,
                                                        int max_boxes, const Stop& stop = {});

}  // namespace limes
