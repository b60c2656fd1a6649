#pragma once

#include "analysis/spectral_radius/exact_polytope.hpp"

#include <variant>

namespace limes {

/// What an enclosure of a joint spectral radius may cost, and how close it is to be.
struct SpectralRadiusOptions {
  /// upper <= lower (1 + 10^-digits) is aimed at.
  int digits = 6;
  PolytopeLimits polytopes = {};
  /// An upper bound that is proved otherwise: where it is narrow, and the radius is not found exactly, no polytope is searched.
  std::optional<Rational> known_upper = {};
};

/// A polytope with its bound, or a proof that the block's radius is an algebraic number.
struct BoundedPolytope {
  Rational bound;
  Polytope polytope;
};
using BlockProof = std::variant<BoundedPolytope, ExactPolytope>;

/// lower <= JSR <= upper with the proofs of both. [Gripenberg 1996; Guglielmi & Protasov 2013, 2016]
struct SpectralRadiusBounds {
  Rational lower = 0;
  Rational upper = 0;
  /// rho(B_word)^{1/|word|} >= lower; empty when lower = 0.
  Word word;
  /// JSR is exactly this.
  std::optional<AlgebraicNumber> exact;
  BlockTriangularForm form;
  /// One proof a diagonal block: each block's radius is at most `upper`.
  std::vector<BlockProof> blocks;
  /// The work was stopped; the bounds hold, but may be wide.
  bool interrupted = false;
};

/// Always gives bounds, narrow ones where the algorithms succeed within the limits; honours `stop` with what is known by then.
SpectralRadiusBounds bound_spectral_radius(const MatrixFamily& family, const SpectralRadiusOptions& options, const Stop& stop);

/// rho(a)^{1/k} >= bound, decided on the characteristic polynomial. \pre k >= 1, bound >= 0
bool exact_radius_at_least(const RationalMatrix& a, int k, const Rational& bound);

}  // namespace limes
