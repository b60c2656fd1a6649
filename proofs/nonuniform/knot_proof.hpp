#pragma once

#include "analysis/nonuniform/root_dominance.hpp"
#include "proofs/certificate.hpp"
#include "proofs/proof_limits.hpp"
#include "proofs/uniform/smoothness_proof.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"

#include <functional>
#include <optional>
#include <string>

namespace limes {

/// What the prover of Theorem N1 brings back.
struct KnotProofAttempt {
  std::optional<KnotProof> proof;
  /// Why it is not proved.
  std::string reason;
  /// The parameter value at which the uniform part got stuck.
  std::optional<std::vector<Rational>> failing_point;
  /// Parameters, then gamma: a point at which some root has modulus >= 2^{-m}.
  std::optional<std::vector<Rational>> expanding_point;
};

/// The region in pieces on each of which all denominators of the rule in the parameters have a strict sign by their Bernstein
/// coefficients (the checker does not bisect for that); the region itself as a rule.
/// \throws LimitError when there are too many
std::vector<Box> pieces_without_poles(const InsertionRule& rule, const Box& region);
/// One proof of the leaves of all pieces; the first attempt that fails, if any does.
ProofAttempt on_pieces(const std::vector<Box>& pieces, const std::function<ProofAttempt(const Box&)>& prove);

/// Theorem N1: tries to prove that the scheme is C^m for every strictly increasing knot sequence at every parameter value of the
/// region: the uniform scheme by U1, polynomial eigenvectors, and dominance of all other roots of the characteristic polynomial
/// at an isolated knot ratio gamma in (0, 1]; gamma > 1 is the mirror image of a mirror-symmetric rule, and for others has
/// leaves of its own. [Warren 1995; Karciauskas & Peters 2013]
KnotProofAttempt prove_smooth_for_all_knots(const InsertionRule& rule, int m, const Box& region, const ProofLimits& limits,
                                            const Stop& stop);

/// Theorem N3: tries to prove that the scheme is not C^m for all knots, at every parameter value of the region: on each leaf by a
/// knot ratio gamma at which an eigenvalue besides 1, .., 2^{-m} has modulus >= 2^{-m}: on leaves that are no points a real one, one of a complex
/// pair, or another one of 1, .., 2^{-m}. \param first a ratio that is tried first
ProofAttempt refute_by_ratio(const InsertionRule& rule, int m, const Box& region, const std::optional<Rational>& first,
                             const ProofLimits& limits, const Stop& stop);

}  // namespace limes
