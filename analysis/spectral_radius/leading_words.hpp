#pragma once

#include "algebra/stop.hpp"
#include "analysis/spectral_radius/matrix_family.hpp"

namespace limes {

/// A word and, approximately, rho(product)^{1/length}.
struct LeadingWord {
  Word word;
  double radius = 0;
};

/// What the search for words may cost.
struct LeadingWordLimits {
  int max_length = 20;
  /// Prefixes that are kept of each length: those of greatest norm.
  int width = 200;
};

/// Words with the greatest averaged spectral radii that a branch and bound over prefixes finds in floating point (all prefixes of a
/// leading word's best rotation have norm^{1/k} at least its radius) [Gripenberg 1996]; no word is a power or a rotation of another
/// one. The best first, the others within a relative `tolerance` of it, the shortest before the longer. Never empty; a hint.
std::vector<LeadingWord> approx_leading_words(const MatrixFamily& family, const LeadingWordLimits& limits, double tolerance,
                                              const Stop& stop);

}  // namespace limes
