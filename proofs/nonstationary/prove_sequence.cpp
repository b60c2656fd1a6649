// Theorem S1 on an interval of angles.

#include "proofs/nonstationary/sequence_proof.hpp"

#include "algebra/error.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

SequenceAttempt prove_asymptotic(const MaskSequence& sequence, const Claim& claim, const ProofLimits& limits,
                                 const Stop& stop) {
  SequenceAttempt attempt;
  if (claim.negated) {
    attempt.reason = "no theorem at hand shows that a nonstationary scheme is not smooth";
    return attempt;
  }
  const int m = claim.smoothness;
  const Mask limit = limit_mask(sequence, 0);
  ProofAttempt smooth = prove_smooth(limit, m, {}, limits, stop);
  if (!smooth.proved) {
    attempt.reason =
        fmt::format("the limit scheme is not proved to be C{} ({}), which refutes nothing", m, smooth.reason);
    return attempt;
  }
  AsymptoticAttempt asymptotic = bound_difference_to_limit(sequence, claim.type, claim.region.front(), m);
  if (!asymptotic.bound) {
    attempt.reason = asymptotic.reason;
    return attempt;
  }
  Certificate certificate{.scheme = "limit",
                          .parameters = {},
                          .definition = limit,
                          .claim = Claim{.smoothness = m, .space = {}, .region = {}, .source = {}, .erratum = {}},
                          .verdict = Outcome::certified,
                          .theorem = Theorem::u1,
                          .proof = LeafProof{smooth.stability, std::move(smooth.leaves)}};
  attempt.proof = AsymptoticProof{*asymptotic.bound, to_json(certificate), certificate.level()};
  attempt.outcome = Outcome::certified;
  return attempt;
}

}  // namespace

SequenceAttempt prove_sequence_claim(const MaskSequence& sequence, const Claim& claim, const ProofLimits& limits,
                                     const Stop& stop) {
  const MaskSequence::Range* range = sequence.find(claim.type);
  if (!range || claim.region.size() != 1 || !range->angles.contains(claim.region.front())) {
    throw DomainError("a claim about a nonstationary scheme is about angles in the range of one of its types");
  }
  return claim.space ? prove_space_claim(sequence, claim) : prove_asymptotic(sequence, claim, limits, stop);
}

}  // namespace limes
