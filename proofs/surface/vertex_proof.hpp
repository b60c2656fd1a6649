#pragma once

#include "algebra/stop.hpp"
#include "proofs/certificate.hpp"
#include "proofs/proof_limits.hpp"

namespace limes {

/// What the prover of Theorems E1 and E2 brings back: a proof that the checker accepts, or why there is none.
struct VertexAttempt {
  std::optional<VertexProof> proof;
  std::string reason;
};

/// Decides a claim about the extraordinary vertices (faces) of a surface scheme. Separators and cells are found in floating point and
/// proposed to the checker until it accepts a proof. Of a nonstationary scheme the spectral condition is about the limit matrix M, with
/// sum_k 2^k ||M_k - M|| < inf. \pre scheme.surface and claim.valences
VertexAttempt prove_vertex_claim(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop);

/// Theorem E1, whatever the claim's statement is, and, for "C1" at the angle 0, Theorem E2.
VertexAttempt prove_spectral_condition(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop);
VertexAttempt prove_smooth_at_vertices(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop);

/// Why the checker rejects a proof of the claim, or nothing.
std::optional<std::string> vertex_rejection(const Scheme& scheme, const Claim& claim, const VertexProof& proof);

/// What the proof says, in one sentence.
std::string describe_vertex_proof(const Certificate& certificate);

/// The JSON text of a certificate about extraordinary vertices.
std::string vertex_certificate_json(const Certificate& certificate);

}  // namespace limes
