// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/ring.hpp"

namespace limes::checker {

constexpr int max_valence = 1000;

/// The valences first, first + 1, .., last; without a last one all from the first on.
struct Valences {
  int first = 3;
  std::optional<int> last;
};

/// For one valence n, or for c = cos(2 pi/n) in [from, to]: the subdominant eigenvalue is the only one of block 1 with a modulus above the
/// separator.
struct Separation {
  int valence = 0;  ///< or 0
  mpq_class from, to, separator;
};

/// Theorem E1. \param scheme its weights in n alone (limit_scheme())  \param one_by_one [{"valence", "separator"}, ..] from valences.first on
/// \param all of the others when there is no last valence, else nullptr \throws Rejected at "spectrum", "proof" or as ring_blocks()
std::vector<Separation> prove_spectral_condition(const RingScheme& scheme, int rings, const Valences& valences,
                                                 const nlohmann::json& one_by_one, const nlohmann::json* all,
                                                 Budget& budget);

}  // namespace limes::checker
