#pragma once

#include "analysis/nonuniform/root_dominance.hpp"
#include "analysis/spectral_radius/polytope_norm.hpp"
#include "analysis/uniform/contractivity_bound.hpp"

namespace limes {

/// How hard the provers try before they say undecided.
struct ProofLimits {
  ContractivityLimits contractivity;
  /// The tests of Theorem N1 for one factor of a characteristic polynomial, and their boxes.
  RootDominanceOptions dominance;
  /// Polytope norms: vectors, and the dimension of the sections.
  PolytopeLimits polytope{.max_vectors = 400, .precision = 48, .eagerness = 0.5};
  int max_polytope_dimension = 20;
  /// Leaves of one proof.
  int max_leaves = 20000;
  /// Bisections of one leaf.
  int max_depth = 60;
  /// Length of words of difference sections.
  int max_word_length = 12;
  /// Words formed in floating point per point.
  std::size_t max_words = 10000;
  /// Words tested exactly per point or leaf.
  int max_exact_words = 32;
};

}  // namespace limes
