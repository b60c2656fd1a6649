#pragma once

#include "algebra/stop.hpp"
#include "proofs/certificate.hpp"
#include "proofs/proof_limits.hpp"

namespace limes {

/// What the provers of Theorems S1 and S2 bring back: a proof with its outcome, or why there is none.
struct SequenceAttempt {
  Outcome outcome = Outcome::undecided;
  std::optional<Certificate::Proof> proof;
  std::string reason;
};

/// Decides a claim about a nonstationary scheme for the angles of its region, if S1 (C^m) or S2 (spaces) can. "C^m" is never
/// refuted: that the limit scheme is not C^m says nothing about the scheme (four-point with w_k = 1/(8+k) is C^1, its limit, the
/// polygon, is not). [Dyn & Levin 1995]
SequenceAttempt prove_sequence_claim(const MaskSequence& sequence, const Claim& claim, const ProofLimits& limits,
                                     const Stop& stop);

/// Theorem S2 alone. \pre claim.space
SequenceAttempt prove_space_claim(const MaskSequence& sequence, const Claim& claim);

/// What an S2 proof says, in one sentence.
std::string describe_space_proof(const Certificate& certificate);

/// The JSON text of a certificate about a nonstationary scheme.
std::string sequence_certificate_json(const Certificate& certificate);

}  // namespace limes
