#pragma once

#include "analysis/unity/projective_contraction.hpp"

namespace limes {

/// A rational eigenpair up to about 10^-30.
struct ApproxEigenpair {
  Rational value;
  std::vector<Rational> vector;  ///< one component is 1
};

/// Why the projective scheme is not C^1 (docs/theory.md, theorem P2): a word of k letters whose product of sections has eigenvalues with
/// 2^-k < |second / dominant| < 1, and a window, a word whose length is a multiple of the contraction's level, in which the second
/// eigenvector's limit does not vanish.
struct ProjectiveRoughness {
  ProjectiveContraction contraction;
  std::vector<int> word;
  ApproxEigenpair dominant, second;
  std::vector<int> window;
};

/// Searches words of up to `max_length` letters. Found in floating point; that both eigenvalues exist is verified by sign changes of the exact
/// characteristic polynomial, the rest is left to the checker of the certificate. \pre as find_projective_contraction
std::optional<ProjectiveRoughness> find_projective_roughness(const std::vector<Rational>& mask, const ProjectiveContraction& contraction,
                                                             int max_length, int max_level, const Stop& stop);

/// A word of up to `max_length` letters for which det(I - product) <= 0, exactly: the product has a real eigenvalue >= 1.
std::optional<std::vector<int>> find_growing_word(const std::vector<Rational>& mask, int max_length, const Stop& stop);

}  // namespace limes
