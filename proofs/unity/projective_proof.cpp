#include "proofs/unity/projective_proof.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

constexpr int max_mask_length = 65;
constexpr int max_level = 8;
constexpr int max_word_length = 8;

/// The coefficients, or why the theorems do not speak of the mask.
std::optional<std::vector<Rational>> rational_mask(const Mask& mask, std::size_t least, std::string& reason) {
  if (mask.arity != 2) {
    reason = "theorems P0, P1 and P2 are about binary schemes";
    return std::nullopt;
  }
  for (const RationalFunction& c : mask.symbol.coefficients()) {
    if (c.is_constant()) continue;
    reason = "theorems P0, P1 and P2 are about masks without parameters";
    return std::nullopt;
  }
  std::vector<Rational> coefficients = mask.symbol.rational_coefficients();
  if (coefficients.size() < least || coefficients.size() > max_mask_length) {
    reason = fmt::format("the mask has {} coefficients, not {} to {}", coefficients.size(), least, max_mask_length);
    return std::nullopt;
  }
  return coefficients;
}

}  // namespace

MaskProofAttempt prove_zero_limits(const Mask& mask, bool divergent, const Stop& stop) {
  MaskProofAttempt attempt{.proof = {}, .theorem = Theorem::p0, .reason = {}};
  const auto coefficients = rational_mask(mask, 2, attempt.reason);
  if (!coefficients) return attempt;
  Rational even, odd;
  for (std::size_t k = 0; k < coefficients->size(); ++k) (k % 2 ? odd : even) += (*coefficients)[k];
  if (even == 1 && odd == 1) {
    attempt.reason = "the even and the odd coefficients sum to 1";
    return attempt;
  }
  ZeroLimitProof proof;
  if (divergent) {
    proof.word = find_growing_word(*coefficients, max_word_length, stop);
    if (!proof.word) {
      attempt.reason = fmt::format("no limits but zero, but no word of at most {} letters with a real eigenvalue of at least 1", max_word_length);
      return attempt;
    }
  }
  attempt.proof = std::move(proof);
  return attempt;
}

MaskProofAttempt prove_projective_convergence(const Mask& mask, const Stop& stop) {
  MaskProofAttempt attempt{.proof = {}, .theorem = Theorem::p1, .reason = {}};
  const auto coefficients = rational_mask(mask, 3, attempt.reason);
  if (!coefficients) return attempt;
  if (auto found = find_projective_contraction(*coefficients, 1, max_level, stop)) {
    attempt.proof = ConeProof{std::move(*found), std::nullopt};
  } else {
    attempt.reason = fmt::format("no cone of weights with a contraction of the points up to level {}", max_level);
  }
  return attempt;
}

MaskProofAttempt prove_projective_roughness(const Mask& mask, const Stop& stop) {
  MaskProofAttempt attempt = prove_projective_convergence(mask, stop);
  attempt.theorem = Theorem::p2;
  if (!attempt.proof) return attempt;
  const ProjectiveContraction contraction = std::get<ConeProof>(*attempt.proof).contraction;
  attempt.proof.reset();
  const auto coefficients = rational_mask(mask, 3, attempt.reason);
  if (auto found = find_projective_roughness(*coefficients, contraction, max_word_length, max_level, stop)) {
    attempt.proof = ConeProof{found->contraction, std::move(*found)};
  } else {
    attempt.reason = fmt::format("no word of at most {} letters with a visible real eigenvalue above 2^-k times the dominant one", max_word_length);
  }
  return attempt;
}

}  // namespace limes
