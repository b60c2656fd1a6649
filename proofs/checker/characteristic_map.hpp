// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/curve_limits.hpp"
#include "proofs/checker/vertex.hpp"

#include <nlohmann/json_fwd.hpp>

namespace limes::checker {

/// Theorem E2: proves that the characteristic map is regular and injective.
class CharacteristicMap {
 public:
  /// \param scheme its weights in n alone (limit_scheme())  \param limits of its mask
  /// \param valence for weights with n; none when the proof is for many valences
  /// \throws Rejected at "map" when a rule of its own meets the annulus, and as ring_blocks()
  CharacteristicMap(const RingScheme& scheme, const CurveLimits& limits, int rings, std::optional<int> valence,
                    Budget& budget);

  /// For all valences with cos(pi/n) in the interval, after `level` steps of subdivision of the annulus.
  /// \returns what contains the eigenvalue of the map, a positive number \throws Rejected at "map"
  Enclosure prove(const Enclosure& cosine, int level, Budget& budget) const;

 private:
  friend class MapProof;
  const RingScheme& scheme_;
  const CurveLimits& limits_;
  RingBlocks blocks_;
  std::map<RingPoint, RingRow> outer_;  ///< the rules of the points beyond the rings, a >= b
};

/// The last part of theorem E2: the maps of the valences that are separated one by one, and of all from `first` on when there are
/// separations for intervals, with their levels and intervals of cos(pi/n) in "map". \throws Rejected at "map", "proof" or "limits"
void prove_characteristic_maps(const RingScheme& scheme, int rings, const std::vector<Separation>& separations, int first,
                               const nlohmann::json& map, Budget& budget);

}  // namespace limes::checker
