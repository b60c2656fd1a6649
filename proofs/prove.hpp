#pragma once

#include "algebra/stop.hpp"
#include "proofs/proof_limits.hpp"
#include "proofs/verdict.hpp"

namespace limes {

/// Decides a claim about a scheme, if the theorems at hand can: the claim is proved on a cover of its region, or its opposite on a
/// point of it. Every certificate is given to the independent checker before it becomes a verdict.
/// \pre claim.region has one interval per parameter. \throws InternalError when the checker rejects a certificate.
Verdict prove(const Scheme& scheme, const Claim& claim, const ProofLimits& limits = {}, const Stop& stop = {});

/// As prove(), but the opposite is not tried: certified or undecided.
Verdict prove_as_stated(const Scheme& scheme, const Claim& claim, const ProofLimits& limits = {}, const Stop& stop = {});

}  // namespace limes
