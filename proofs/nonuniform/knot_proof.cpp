// Theorem N1 on a region of parameters.

#include "proofs/nonuniform/knot_proof.hpp"

#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

Box with_ratio(Box region, const Interval& gamma) {
  region.push_back(gamma);
  return region;
}

}  // namespace

KnotProofAttempt prove_smooth_for_all_knots(const InsertionRule& rule, int m, const Box& region, const ProofLimits& limits,
                                            const Stop& stop) {
  KnotProofAttempt attempt;
  ProofAttempt uniform = prove_smooth(uniform_mask(rule), m, region, limits, stop);
  if (!uniform.proved) {
    attempt.reason = "equal intervals: " + uniform.reason;
    attempt.failing_point = uniform.failing_point;
    return attempt;
  }
  const std::vector<std::vector<RationalFunction>> stencils = isolated_ratio_stencils(rule, region);
  if (!is_mirror_symmetric(stencils)) {
    attempt.reason = "the rule is not mirror-symmetric";
    return attempt;
  }
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(stencils);
  if (matrix.reproduced_degree(m) < m) {
    attempt.reason = fmt::format("the rule does not reproduce polynomials of degree {} at an isolated knot", m);
    return attempt;
  }
  const SplitCharacteristicPolynomial split = split_characteristic_polynomial(matrix, m, stop);
  if (split.missing_eigenvalue) {
    attempt.reason = fmt::format("2^-{} is no eigenvalue of the subdivision matrix", *split.missing_eigenvalue);
    return attempt;
  }
  KnotProof proof;
  proof.uniform_leaves = std::move(uniform.leaves);
  RootDominanceOptions options;
  options.methods = {DominanceMethod::rouche, DominanceMethod::circle, DominanceMethod::boundary};
  const Box box = with_ratio(region, {0, 1, true, false});
  for (const auto* factors : {&split.ell, &split.r}) {
    for (const CharacteristicFactor& factor : *factors) {
      RootDominance dominance = prove_root_dominance(factor.polynomial, power(Rational(2), -m), box, options, stop);
      if (!dominance.proved) {
        attempt.reason = fmt::format("the roots of a factor of degree {} are not dominated by 2^-{}: {}", factor.polynomial.degree(),
                                     m, dominance.reason);
        attempt.expanding_point = dominance.counterexample;
        return attempt;
      }
      proof.factors.push_back({factor.polynomial, factor.multiplicity, std::move(dominance.leaves)});
    }
  }
  attempt.proof = std::move(proof);
  return attempt;
}

}  // namespace limes
