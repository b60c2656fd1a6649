// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/curve_limits.hpp"
#include "proofs/checker/ring.hpp"

namespace limes::checker {

/// Theorem E2: proves that the characteristic map is regular and injective.
class CharacteristicMap {
 public:
  /// \param scheme its weights in n alone (limit_scheme())  \param valence for weights with n; none when the proof is for many
  /// \throws Rejected at "map" when the curve scheme is not proved C^1 or a rule of its own meets the annulus
  CharacteristicMap(const RingScheme& scheme, const RingBlocks& blocks, int rings, std::optional<int> valence,
                    Budget& budget);

  /// For all valences with cos(pi/n) in the interval, after `level` steps of subdivision of the annulus.
  /// \returns what contains the eigenvalue of the map, a positive number \throws Rejected at "map"
  Enclosure prove(const Enclosure& cosine, int level, Budget& budget) const;

 private:
  friend class MapProof;
  const RingScheme& scheme_;
  const RingBlocks& blocks_;
  CurveLimits limits_;
  std::map<RingPoint, RingRow> outer_;  ///< the rules of the points beyond the rings, a >= b
};

}  // namespace limes::checker
