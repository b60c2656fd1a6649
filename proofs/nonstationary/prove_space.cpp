// Theorem S2: identities of moments, and moments that are wrong at every angle.

#include "proofs/nonstationary/sequence_proof.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

class SpaceProver {
 public:
  SpaceProver(const MaskSequence& sequence, const Claim& claim)
      : sequence_(sequence), claim_(claim), tau_(parameter_tau(sequence)) {
    if (denominator(tau_) > max_tau_denominator) {
      throw LimitError(
          fmt::format("linear functions are kept with tau = {} only, whose denominator is too large", to_string(tau_)));
    }
  }

  /// Whether every step reproduces (generates) the function at all these angles, as an identity.
  bool holds(const ExponentialFunction& f, const Interval& angles) const {
    for (int k = 0; k <= static_cast<int>(sequence_.first_levels.size()); ++k) {
      if (!defects(sequence_.at_level(k), tau_, f, claim_.space->generates, angles.upper == 0).empty()) return false;
    }
    return true;
  }

  /// A part of a moment that is wrong at all these angles in the first step with the common mask.
  std::optional<MomentDefect> fails(const ExponentialFunction& f, const Interval& angles) const {
    const int level = static_cast<int>(sequence_.first_levels.size());
    const Interval c =
        level_range(sequence_.mask.arity, claim_.type, angles, level, denominator(tau_).convert_to<int>());
    const bool with_zero = angles.lower == 0 && !angles.lower_open;
    for (const MomentDefect& defect : defects(sequence_.mask, tau_, f, claim_.space->generates, angles.upper == 0)) {
      if (defect.part == MomentPart::odd && with_zero) continue;
      if (prove_strict_sign(defect.value.numerator(), {c}) != 0) return defect;
    }
    return std::nullopt;
  }

 private:
  const MaskSequence& sequence_;
  const Claim& claim_;
  Rational tau_;
};

/// A few angles of an interval, as points.
std::vector<Interval> sample_angles(const Interval& angles) {
  std::vector<Interval> samples{Interval::point(angles.midpoint())};
  if (angles.is_point()) return samples;
  if (!angles.lower_open) samples.push_back(Interval::point(angles.lower));
  if (!angles.upper_open) samples.push_back(Interval::point(angles.upper));
  return samples;
}

}  // namespace

SequenceAttempt prove_space_claim(const MaskSequence& sequence, const Claim& claim) {
  const SpaceProver prover(sequence, claim);
  const Interval& angles = claim.region.front();
  const std::vector<ExponentialFunction>& functions = claim.space->functions;
  SequenceAttempt attempt;
  for (const ExponentialFunction& f : functions) {
    if (!fits(f, claim.type))
      throw InputError(fmt::format("{} does not belong to the {} type", to_string(f), to_string(claim.type)));
  }
  const auto defined = [&](const Interval& where) { return uniform_level(sequence, claim.type, where); };
  const std::optional<int> level = defined(angles);
  SpaceProof proof{level.value_or(0), {}, {}, angles};
  std::optional<std::size_t> culprit;
  for (std::size_t i = 0; i < functions.size() && !culprit; ++i) {
    if (claim.negated) {
      const std::optional<MomentDefect> defect = prover.fails(functions[i], angles);
      if (defect) proof.defects.push_back(*defect);
      if (!defect) culprit = i;
    } else if (!prover.holds(functions[i], angles)) {
      culprit = i;
    }
  }
  if (!culprit && level) {
    attempt.outcome = Outcome::certified;
    attempt.proof = std::move(proof);
    return attempt;
  }
  // The opposite for one function, at one angle.
  const char* verb = claim.space->generates ? "generated" : "reproduced";
  for (const Interval& where : culprit ? sample_angles(angles) : std::vector<Interval>{}) {
    const std::optional<int> own_level = defined(where);
    if (!own_level) continue;
    SpaceProof opposite{*own_level, {}, static_cast<int>(*culprit), where};
    if (!claim.negated) {
      const std::optional<MomentDefect> defect = prover.fails(functions[*culprit], where);
      if (!defect) continue;
      opposite.defects.push_back(*defect);
    } else if (!prover.holds(functions[*culprit], where)) {
      continue;
    }
    attempt.outcome = Outcome::refuted;
    attempt.proof = std::move(opposite);
    return attempt;
  }
  attempt.reason = !level ? "a mask may have a pole at some angle"
                          : fmt::format("{} is not proved to be {}{} at every angle", to_string(functions[*culprit]),
                                        claim.negated ? "not " : "", verb);
  return attempt;
}

std::string describe_space_proof(const Certificate& certificate) {
  const SpaceProof& proof = std::get<SpaceProof>(certificate.proof);
  const SpaceStatement& space = *certificate.claim.space;
  if (!proof.function)
    return proof.defects.empty() ? "every step is an identity" : "a moment of the mask is wrong at every angle";
  const std::string function = to_string(space.functions[static_cast<std::size_t>(*proof.function)]);
  const std::string where = fmt::format("at {} = {}", certificate.parameters.front(), to_string(proof.angles));
  const char* verb = space.generates ? "generated" : "reproduced";
  if (proof.defects.empty()) return fmt::format("{}: {} is {}", where, function, verb);
  const MomentDefect& defect = proof.defects.front();
  return fmt::format("{}: {} is not {}: {} moment {} at residue {} is off by {}, c = cos or cosh of the step's angle",
                     where, function, verb, defect.part == MomentPart::even ? "even" : "odd", defect.moment,
                     defect.residue, to_string(defect.value, {"c"}));
}

}  // namespace limes
