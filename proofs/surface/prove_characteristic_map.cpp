// Theorem E2: the spectral condition by Theorem E1, then levels and pieces for the characteristic maps in floating point, proposed to the
// checker.

#include "algebra/error.hpp"
#include "analysis/surface/characteristic_map.hpp"
#include "proofs/surface/vertex_proof.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

namespace limes {
namespace {

/// Levels for the valences that E1 treats one by one, and pieces for the others.
/// \returns them, or for which valences there are none
std::variant<CharacteristicMapProof, std::string> find_maps(const RingRule& rule, const VertexProof& spectrum, int first, const Stop& stop) {
  const auto clear = "the characteristic map is not found to be regular and injective at";
  CharacteristicMapProof proof;
  int n = first;
  for (std::size_t k = 0; k < spectrum.separators.size(); ++k, ++n) {
    stop.check();
    const std::optional<int> level = approx_map_level(rule, spectrum.rings, n);
    if (!level) return fmt::format("{} valence {}", clear, n);
    proof.levels.push_back(*level);
  }
  if (!spectrum.all) return proof;
  // a little below cos(pi/n)
  const double cosine = std::cos(std::numbers::pi / n);
  proof.start = Rational(static_cast<long long>(std::floor(cosine * 4096 - 1e-3))) / Rational(4096);
  for (const MapPiece& piece : approx_map_pieces(rule, spectrum.rings, proof.start, stop)) proof.pieces.push_back({piece.to, piece.level});
  if (proof.pieces.empty()) return fmt::format("{} all valences from {} on", clear, n);
  return proof;
}

}  // namespace

VertexAttempt prove_smooth_at_vertices(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  VertexAttempt attempt;
  const bool stationary = claim.region.empty() || (claim.region.front().is_point() && claim.region.front().lower == 0);
  if (!stationary) {
    attempt.reason = fmt::format(
        "the rules change from step to step for {} != 0: of those only the spectral condition of the limit can be proved, which is not C1",
        scheme.parameter_names().front());
    return attempt;
  }
  Claim spectral = claim;
  spectral.subject = ClaimSubject::vertex_spectrum;
  spectral.smoothness = 0;
  attempt = prove_spectral_condition(scheme, spectral, limits, stop);
  if (!attempt.proof) return attempt;
  try {
    auto maps = find_maps(scheme.surface->rings, *attempt.proof, claim.valences->first, stop);
    auto* map = std::get_if<CharacteristicMapProof>(&maps);
    if (!map) attempt.reason = std::get<std::string>(maps);
    for (int more = 0; map && more < 2; ++more) {
      attempt.proof->map = *map;
      const std::optional<std::string> rejected = vertex_rejection(scheme, claim, *attempt.proof);
      if (!rejected) return attempt;
      attempt.reason = *rejected;
      for (int& level : map->levels) ++level;  // rounding, or a close call
      for (auto& piece : map->pieces) ++piece.level;
    }
  } catch (const InputError& error) {  // a scheme to which the theorem does not apply
    attempt.reason = error.reason();
  } catch (const DomainError& error) {
    attempt.reason = error.what();
  }
  attempt.reason = "the spectral condition holds, but " + attempt.reason;
  attempt.proof.reset();
  return attempt;
}

}  // namespace limes
