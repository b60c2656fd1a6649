#pragma once

#include "algebra/stop.hpp"
#include "proofs/certificate.hpp"

#include <optional>
#include <string>

namespace limes {

/// What a prover brings back about a mask without parameters: a proof, or why there is none.
struct MaskProofAttempt {
  std::optional<std::variant<ConeProof, ZeroLimitProof>> proof;
  Theorem theorem = Theorem::p0;
  std::string reason;
};

/// Theorem P0: only the limit zero; with `divergent`, also a growing word, so that the scheme is not C^0.
MaskProofAttempt prove_zero_limits(const Mask& mask, bool divergent, const Stop& stop);
/// Theorem P1: the projective scheme converges for equal initial weights.
MaskProofAttempt prove_projective_convergence(const Mask& mask, const Stop& stop);
/// Theorem P2: it is not C^1 in the uniform parametrisation.
MaskProofAttempt prove_projective_roughness(const Mask& mask, const Stop& stop);

}  // namespace limes
