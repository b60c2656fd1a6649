#include "proofs/prove.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limes {
namespace {

Box point_box(const std::vector<Rational>& point) {
  Box box;
  for (const Rational& x : point) box.push_back(Interval::point(x));
  return box;
}

ProofAttempt attempt_statement(const Scheme& scheme, int m, bool negated, const Box& region, const ProofLimits& limits,
                               const Stop& stop) {
  return negated ? prove_not_smooth(scheme.mask, m, region, limits, stop)
                 : prove_smooth(scheme.mask, m, region, limits, stop);
}

/// "w = 1/16, mu = 2"
std::string describe_point(std::span<const Rational> point, const VariableNames& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) text += fmt::format("{}{} = {}", k ? ", " : "", names[k], to_string(point[k]));
  return text;
}

/// Why an attempt failed, and where.
std::string describe_failure(const ProofAttempt& attempt, const VariableNames& names) {
  if (!attempt.failing_point || names.empty()) return attempt.reason;
  return fmt::format("{} at {}", attempt.reason, describe_point(*attempt.failing_point, names));
}

/// What a proof of "C^m" or "not C^m" says, in one sentence.
std::string describe_proof(const ProofAttempt& attempt, int m, bool negated, bool refutes, const VariableNames& names) {
  const ProofLeaf& leaf = attempt.leaves.front();
  const std::string where = refutes && !names.empty() ? "at " + describe_point(midpoint(leaf.region), names) + ": " : "";
  if (!negated) return fmt::format("{}sigma^{} divides the symbol and the difference scheme contracts", where, m + 1);
  if (const auto* word = std::get_if<WordWitness>(&leaf.witness)) {
    return fmt::format("{}the sections B_e along the word {} have a product of spectral radius >= 1", where,
                       fmt::join(word->word, " "));
  }
  return fmt::format("{}sigma^{} does not divide the symbol", where, m + 1);
}

Verdict conclude(const Scheme& scheme, const Claim& claim, Outcome outcome, ProofAttempt attempt) {
  const bool negated = claim.negated == (outcome == Outcome::certified);
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.reason = describe_proof(attempt, claim.smoothness, negated, outcome == Outcome::refuted, scheme.parameter_names());
  verdict.certificate = Certificate{.scheme = scheme.name,
                                    .parameters = scheme.parameter_names(),
                                    .mask = scheme.mask,
                                    .claim = claim,
                                    .verdict = outcome,
                                    .theorem = negated ? Theorem::u2 : Theorem::u1,
                                    .stability = attempt.stability,
                                    .leaves = std::move(attempt.leaves)};
  verdict.certificate_json = to_json(*verdict.certificate);
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

}  // namespace

Verdict prove(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  if (claim.region.size() != scheme.parameters.size()) throw DomainError("prove: the region has the wrong number of parameters");
  for (const RationalFunction& c : scheme.mask.symbol.coefficients()) {
    if (c.is_polynomial() || prove_strict_sign(c.denominator(), claim.region) != 0) continue;
    Verdict verdict;
    verdict.reason = fmt::format("the mask may have a pole in the region: a zero of {}",
                                 to_string(c.denominator(), scheme.parameter_names()));
    return verdict;
  }
  try {
    ProofAttempt direct = attempt_statement(scheme, claim.smoothness, claim.negated, claim.region, limits, stop);
    if (direct.proved) return conclude(scheme, claim, Outcome::certified, std::move(direct));

    std::vector<std::vector<Rational>> points = sample_points(claim.region);
    if (direct.failing_point) points.insert(points.begin(), *direct.failing_point);
    std::string opposite_reason;
    for (const std::vector<Rational>& point : points) {
      ProofAttempt opposite = attempt_statement(scheme, claim.smoothness, !claim.negated, point_box(point), limits, stop);
      if (opposite.proved) return conclude(scheme, claim, Outcome::refuted, std::move(opposite));
      if (opposite_reason.empty()) opposite_reason = describe_failure(opposite, scheme.parameter_names());
    }
    Verdict verdict;
    verdict.reason = fmt::format("{}; {}", describe_failure(direct, scheme.parameter_names()), opposite_reason);
    return verdict;
  } catch (const LimitError& error) {
    Verdict verdict;
    verdict.reason = error.reason();
    return verdict;
  } catch (const Interrupted& interrupted) {
    Verdict verdict;
    verdict.reason = interrupted.what();
    verdict.interrupted = true;
    return verdict;
  }
}

}  // namespace limes
