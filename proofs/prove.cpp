#include "proofs/prove.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/nonstationary/sequence_proof.hpp"
#include "proofs/nonuniform/knot_proof.hpp"
#include "proofs/surface/vertex_proof.hpp"
#include "proofs/uniform/smoothness_proof.hpp"
#include "proofs/unity/projective_proof.hpp"
#include "schemes/nonuniform/normalized_rule.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limes {
namespace {

/// What became of "C^m" or "not C^m" on a region.
struct Attempt {
  std::optional<Certificate::Proof> proof;
  Theorem theorem = Theorem::u1;
  std::string reason;
  /// Where it got stuck: a candidate for the opposite; for non-uniform schemes with the knot ratio, if one is to blame.
  std::optional<std::vector<Rational>> failing_point;
  std::optional<Rational> failing_ratio;
};

Attempt from_leaves(ProofAttempt leaves, Theorem theorem) {
  Attempt attempt{.proof = {}, .theorem = theorem, .reason = std::move(leaves.reason),
                  .failing_point = std::move(leaves.failing_point), .failing_ratio = {}};
  if (leaves.proved) attempt.proof = LeafProof{leaves.stability, std::move(leaves.leaves)};
  return attempt;
}

Attempt attempt_for_all_knots(const InsertionRule& rule, int m, const Box& region, const ProofLimits& limits, const Stop& stop) {
  KnotProofAttempt knots = prove_smooth_for_all_knots(rule, m, region, limits, stop);
  Attempt attempt{.proof = {}, .theorem = Theorem::n1, .reason = std::move(knots.reason),
                  .failing_point = std::move(knots.failing_point), .failing_ratio = {}};
  if (knots.proof) attempt.proof = std::move(*knots.proof);
  if (knots.expanding_point) {
    attempt.failing_ratio = knots.expanding_point->back();
    knots.expanding_point->pop_back();
    attempt.failing_point = std::move(knots.expanding_point);
  }
  return attempt;
}

Attempt from_mask(MaskProofAttempt mask) {
  Attempt attempt{.proof = {}, .theorem = mask.theorem, .reason = std::move(mask.reason), .failing_point = {}, .failing_ratio = {}};
  if (mask.proof) std::visit([&](auto& proof) { attempt.proof = std::move(proof); }, *mask.proof);
  return attempt;
}

/// Theorems P0, P1 and P2 speak of one mask and nothing else.
bool is_plain_mask(const Scheme& scheme) { return scheme.kind == SchemeKind::uniform && scheme.parameters.empty(); }

/// The projective scheme of a plain mask is C^m (only C^0 can be proved) or, negated, not C^m.
Attempt attempt_projective(const Scheme& scheme, int m, bool negated, const Stop& stop) {
  if (!negated && m == 0) return from_mask(prove_projective_convergence(scheme.mask, stop));
  if (negated && m > 0) return from_mask(prove_projective_roughness(scheme.mask, stop));
  Attempt none;
  none.reason = negated ? "there is no theorem that disproves the convergence of a projective scheme"
                        : "there is no theorem that proves the smoothness of a projective scheme";
  return none;
}

/// "C^m" or, negated, "not C^m" at every point of the region. \param ratio a knot ratio to try first against C^m
Attempt attempt_statement(const Scheme& scheme, const Claim& claim, bool negated, const Box& region, const std::optional<Rational>& ratio,
                          const ProofLimits& limits, const Stop& stop) {
  const int m = claim.smoothness;
  if (claim.subject == ClaimSubject::projective_limits) return attempt_projective(scheme, m, negated, stop);
  if (!negated) {
    return scheme.insertion_rule ? attempt_for_all_knots(*scheme.insertion_rule, m, region, limits, stop)
                       : from_leaves(prove_smooth(scheme.mask, m, region, limits, stop), Theorem::u1);
  }
  if (!scheme.insertion_rule) {
    Attempt attempt = from_leaves(prove_not_smooth(scheme.mask, m, region, limits, stop), Theorem::u2);
    if (attempt.proof || !is_plain_mask(scheme)) return attempt;
    // Without sum rules there is no need of stability.
    Attempt divergence = from_mask(prove_zero_limits(scheme.mask, true, stop));
    return divergence.proof ? divergence : attempt;
  }
  // Equal intervals are a knot sequence: what is not C^m there is not C^m.
  const std::vector<Box> pieces = pieces_without_poles(*scheme.insertion_rule, region);
  const auto on_piece = [&](const Box& piece) { return prove_not_smooth(scheme.mask, m, piece, limits, stop); };
  Attempt attempt = from_leaves(on_pieces(pieces, on_piece), Theorem::u2);
  if (attempt.proof) return attempt;
  Attempt by_ratio = from_leaves(refute_by_ratio(*scheme.insertion_rule, m, region, ratio, limits, stop), Theorem::n3);
  return by_ratio.proof ? by_ratio : attempt;
}

/// "w = 1/16, mu = 2"
std::string describe_point(std::span<const Rational> point, const VariableNames& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) text += fmt::format("{}{} = {}", k ? ", " : "", names[k], to_string(point[k]));
  return text;
}

/// Why an attempt failed, and where.
std::string describe_failure(const Attempt& attempt, const VariableNames& names) {
  if (!attempt.failing_point || names.empty()) return attempt.reason;
  return fmt::format("{} at {}", attempt.reason, describe_point(*attempt.failing_point, names));
}

std::string describe_leaf(const ProofLeaf& leaf, int m) {
  if (const auto* ratio = std::get_if<RatioWitness>(&leaf.witness)) {
    return fmt::format("at the knot ratio gamma = {} an eigenvalue besides 1, .., 2^-{} has modulus >= 2^-{}, or a power of t is no eigenvector",
                       to_string(ratio->gamma), m, m);
  }
  if (const auto* word = std::get_if<WordWitness>(&leaf.witness)) {
    return fmt::format("the sections B_e along the word {} have a product of spectral radius >= 1", fmt::join(word->word, " "));
  }
  if (const auto* polytope = std::get_if<PolytopeWitness>(&leaf.witness)) {
    return fmt::format("sigma^{} divides the symbol and the difference scheme contracts in the norm of a polytope of {} vectors", m + 1,
                       polytope->vectors());
  }
  if (std::holds_alternative<MissingFactorWitness>(leaf.witness)) return fmt::format("sigma^{} does not divide the symbol", m + 1);
  return fmt::format("sigma^{} divides the symbol and the difference scheme contracts", m + 1);
}

std::string describe_cone(const ConeProof& proof) {
  if (!proof.roughness) {
    return fmt::format("over a cone of weights {} steps multiply the oscillation of the points by at most {}", proof.contraction.level,
                       to_decimal(proof.contraction.factor, 3, Rounding::up));
  }
  const ProjectiveRoughness& rough = *proof.roughness;
  const int length = static_cast<int>(rough.word.size());
  return fmt::format("the word {} has the quotient of eigenvalues {}, above 2^-{}, and it is visible", fmt::join(rough.word, " "),
                     to_decimal(abs(rough.second.value) / rough.dominant.value, 8, Rounding::nearest), length);
}

/// What a proof says, in one sentence; for a refutation with the parameter value.
std::string describe_proof(const Certificate& certificate) {
  const int m = certificate.claim.smoothness;
  if (const auto* cone = std::get_if<ConeProof>(&certificate.proof)) return describe_cone(*cone);
  if (const auto* zero = std::get_if<ZeroLimitProof>(&certificate.proof)) {
    const std::string sums = "the even or the odd coefficients do not sum to 1: no limits but zero";
    return zero->word ? fmt::format("{}; and data grow along the word {}", sums, fmt::join(*zero->word, " ")) : sums;
  }
  if (const auto* leaves = std::get_if<LeafProof>(&certificate.proof)) {
    const ProofLeaf& leaf = leaves->leaves.front();
    // Of a rule for all knots, U2 looks at equal intervals only.
    const bool equal_intervals =
        certificate.theorem == Theorem::u2 && std::holds_alternative<InsertionRuleText>(certificate.definition);
    const std::string text = (equal_intervals ? "equal intervals: " : "") + describe_leaf(leaf, m);
    if (certificate.verdict != Outcome::refuted || certificate.parameters.empty()) return text;
    return fmt::format("at {}: {}", describe_point(midpoint(leaf.region), certificate.parameters), text);
  }
  if (const auto* asymptotic = std::get_if<AsymptoticProof>(&certificate.proof)) {
    return fmt::format("the limit scheme is C{} and the masks tend to it like x^{}, x = {} p^-(k+1)", m, asymptotic->bound.order,
                       certificate.parameters.front());
  }
  if (std::holds_alternative<SpaceProof>(certificate.proof)) return describe_space_proof(certificate);
  if (std::holds_alternative<VertexProof>(certificate.proof)) return describe_vertex_proof(certificate);
  return fmt::format("equal intervals: contraction; all other eigenvalues at an isolated knot ratio are below 2^-{}", m);
}

Verdict conclude(const Scheme& scheme, const Claim& claim, Outcome outcome, Attempt attempt) {
  Verdict verdict;
  verdict.outcome = outcome;
  Certificate certificate{.scheme = scheme.name,
                          .parameters = scheme.parameter_names(),
                          .definition = scheme.mask,
                          .claim = claim,
                          .verdict = outcome,
                          .theorem = attempt.theorem,
                          .proof = std::move(*attempt.proof)};
  if (scheme.insertion_rule) certificate.definition = normalized_text(*scheme.insertion_rule);
  if (scheme.sequence) certificate.definition = *scheme.sequence;
  if (scheme.surface) certificate.definition = *scheme.surface;
  verdict.reason = describe_proof(certificate);
  verdict.certificate_json = to_json(certificate);
  verdict.certificate = std::move(certificate);
  const checker::Result result = checker::check(verdict.certificate_json);
  if (!result.valid && result.step == "limits") {
    Verdict undecided;
    undecided.reason = fmt::format("proved, but limes-check refuses to check so much: {}", result.reason);
    return undecided;
  }
  if (!result.valid) {
    throw InternalError(fmt::format("limes-check rejects the certificate of {} {}: {}: {}", scheme.name, statement(claim),
                                    result.step, result.reason));
  }
  return verdict;
}

/// A denominator of the definition that is not proved to have a strict sign on the region.
std::optional<MultivariatePolynomial> possible_pole(const Scheme& scheme, const Box& region) {
  std::vector<MultivariatePolynomial> denominators;
  for (const RationalFunction& c : scheme.mask.symbol.coefficients()) denominators.push_back(c.denominator());
  if (scheme.insertion_rule) {
    for (const MultivariatePolynomial& d : scheme.insertion_rule->parameter_denominators()) denominators.push_back(d);
  }
  for (const MultivariatePolynomial& d : denominators) {
    if (!d.is_constant() && prove_strict_sign(d, region) == 0) return d;
  }
  return std::nullopt;
}

/// What is found here is found in floating point: it is undecided what the checker does not accept.
Verdict prove_for_surface(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  VertexAttempt attempt;
  try {
    attempt = prove_vertex_claim(scheme, claim, limits, stop);
  } catch (const DomainError& error) {  // a pole of a weight at some valence
    attempt.reason = error.what();
  }
  if (attempt.proof) {
    const Theorem theorem = attempt.proof->map ? Theorem::e2 : Theorem::e1;
    return conclude(scheme, claim, Outcome::certified,
                    {.proof = std::move(*attempt.proof), .theorem = theorem, .reason = {}, .failing_point = {}, .failing_ratio = {}});
  }
  Verdict undecided;
  undecided.reason = attempt.reason;
  return undecided;
}

Verdict prove_for_sequence(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  SequenceAttempt attempt = prove_sequence_claim(*scheme.sequence, claim, limits, stop);
  if (attempt.outcome != Outcome::undecided) {
    return conclude(scheme, claim, attempt.outcome,
                    {.proof = std::move(attempt.proof), .theorem = claim.space ? Theorem::s2 : Theorem::s1, .reason = {},
                     .failing_point = {}, .failing_ratio = {}});
  }
  Verdict undecided;
  undecided.reason = attempt.reason;
  return undecided;
}

/// Why no certificate of this scheme could be checked.
std::optional<std::string> beyond_checker(const Scheme& scheme) {
  constexpr int max_points = 16;
  constexpr std::size_t max_variables = 16;
  if (!scheme.insertion_rule) return std::nullopt;
  const int points = scheme.insertion_rule->points();
  if (points > max_points) {
    return fmt::format("certificates are about rules of at most {} points; this one has {}", max_points, points);
  }
  const std::size_t variables = scheme.parameters.size() + static_cast<std::size_t>(points) - 2;
  if (!scheme.insertion_rule->text().coefficients.empty() && variables > max_variables) {
    return fmt::format("certificates are about coefficients in at most {} parameters and ratios; here are {}", max_variables,
                       variables);
  }
  return std::nullopt;
}

Verdict prove(const Scheme& scheme, const Claim& claim, bool try_opposite, const ProofLimits& limits, const Stop& stop) {
  if (claim.region.size() != scheme.parameters.size()) throw DomainError("prove: the region has the wrong number of parameters");
  if (!scheme.surface && claim.subject != ClaimSubject::limits && !is_plain_mask(scheme)) {
    Verdict verdict;
    verdict.reason = "projective schemes and zero limits are decided for uniform schemes without parameters only";
    return verdict;
  }
  if (!scheme.sequence && claim.space) throw DomainError("prove: reproduction and generation are claims about nonstationary schemes");
  Verdict undecided;
  try {
    if (scheme.surface) return prove_for_surface(scheme, claim, limits, stop);
    if (scheme.sequence) return prove_for_sequence(scheme, claim, limits, stop);
    if (auto reason = beyond_checker(scheme)) {
      undecided.reason = std::move(*reason);
      return undecided;
    }
    if (const auto pole = possible_pole(scheme, claim.region)) {
      undecided.reason = fmt::format("the definition may have a pole in the region: a zero of {}",
                                     to_string(*pole, scheme.parameter_names()));
      return undecided;
    }
    if (claim.subject == ClaimSubject::zero_limits) {
      Attempt zero = from_mask(prove_zero_limits(scheme.mask, false, stop));
      if (zero.proof) return conclude(scheme, claim, Outcome::certified, std::move(zero));
      undecided.reason = zero.reason;
      return undecided;
    }
    Attempt direct = attempt_statement(scheme, claim, claim.negated, claim.region, std::nullopt, limits, stop);
    if (direct.proof) return conclude(scheme, claim, Outcome::certified, std::move(direct));

    undecided.reason = describe_failure(direct, scheme.parameter_names());
    // N1 certifies only: one knot sequence that is smooth refutes nothing.
    if (!try_opposite || (claim.negated && scheme.insertion_rule)) return undecided;
    std::vector<std::vector<Rational>> points = sample_points(claim.region);
    if (direct.failing_point) points.insert(points.begin(), *direct.failing_point);
    std::string opposite_reason;
    for (const std::vector<Rational>& point : points) {
      Box box;
      for (const Rational& x : point) box.push_back(Interval::point(x));
      Attempt opposite = attempt_statement(scheme, claim, !claim.negated, box, direct.failing_ratio, limits, stop);
      if (opposite.proof) return conclude(scheme, claim, Outcome::refuted, std::move(opposite));
      if (opposite_reason.empty()) opposite_reason = describe_failure(opposite, scheme.parameter_names());
    }
    undecided.reason += "; " + opposite_reason;
  } catch (const LimitError& error) {
    undecided.reason = error.reason();
  } catch (const Interrupted& interrupted) {
    undecided.reason = interrupted.what();
    undecided.interrupted = true;
  }
  return undecided;
}

}  // namespace

Verdict prove(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  return prove(scheme, claim, true, limits, stop);
}

Verdict prove_as_stated(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  return prove(scheme, claim, false, limits, stop);
}

}  // namespace limes
