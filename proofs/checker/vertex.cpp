// SPDX-License-Identifier: MIT
//
// Certificates of theorems E1 (the spectral condition) and E2 (C^1) about extraordinary vertices and faces of surface schemes.
#include "proofs/checker/vertex.hpp"

#include "proofs/checker/characteristic_map.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/sequence.hpp"
#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

/// "5", "[3, 50]" or "[3, inf)".
Valences read_valences(const Reader& claim) {
  const std::string& text = claim.text(claim.at("valence"), "valence");
  const auto number = [&](std::string_view digits) {
    const bool fits = !digits.empty() && digits.size() <= 4 && digits.front() != '0' &&
                      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    const int n = fits ? std::stoi(std::string(digits)) : 0;
    if (n < 3 || n > max_valence) claim.fail("needs valences from 3 to " + std::to_string(max_valence));
    return n;
  };
  const std::string_view all = text;
  if (!all.starts_with('[')) return {number(all), number(all)};
  const auto comma = all.find(", ");
  const bool closed = all.ends_with(']');
  if (comma == std::string::npos || (!closed && all.substr(comma) != ", inf)"))
    claim.fail("needs a valence n, [n, m] or [n, inf)");
  Valences result{number(all.substr(1, comma - 1)), std::nullopt};
  if (closed) result.last = number(all.substr(comma + 2, all.size() - comma - 3));
  if (result.last && *result.last <= result.first) claim.fail("has valences that are not in order");
  return result;
}

std::string shown(const Valences& valences) {
  const std::string first = std::to_string(valences.first);
  if (!valences.last) return valences.first == 3 ? "all valences" : "all valences from " + first + " on";
  if (*valences.last == valences.first) return "valence " + first;
  return "the valences " + first + " to " + std::to_string(*valences.last);
}

/// The weights of a nonstationary scheme have no pole at mu_k, k < from_level, nor between the other mu_k and 1. There they are Lipschitz
/// continuous in mu, and |mu_k - 1| <= C 4^{-k}: so the sum of 2^k ||M_k - M|| is finite.
void prove_levels(const RingScheme& scheme, const Sequence& curve, const Interval& angles, int from_level, Budget& budget) {
  std::vector<Polynomial> seen;
  const auto require = [&](const Fraction& weight) {
    const Polynomial& d = weight.denominator;
    if (d == constant(1) || std::count(seen.begin(), seen.end(), d) > 0) return;
    seen.push_back(d);
    if (degree(d, 0) == 0) return;  // where the valence makes it 0, that valence is rejected
    if (degree(d, 1) > 0) throw Rejected{"denominator", "a weight's divisor has the level parameter and the valence in it"};
    Sequence own = curve;
    own.mask.denominator = dense(d);
    require_defined(own, angles, from_level, budget);
  };
  for (const Fraction& a : scheme.mask) require(a);
  for (const auto& [point, terms] : scheme.given)
    for (const RingTerm& term : terms) require(term.weight);
}

}  // namespace

std::string check_vertex(const Json& json, Budget& budget) {
  const Reader reader(json, "format", "the certificate",
                      {"format", "version", "scheme", "claim", "verdict", "theorem", "proof"});
  reader.is_first("verdict", "certified", "certified");
  const bool smooth = reader.is_first("theorem", "E2", "E1");
  const RingScheme scheme = read_ring_scheme(json["scheme"], budget);
  const bool has_levels = scheme.has_levels();

  std::vector<std::string> claim_keys{"statement", "valence"};
  if (has_levels) claim_keys.emplace_back("region");
  const Reader claim(json["claim"], "claim", "the claim", claim_keys);
  claim.is_first("statement", smooth ? "C1" : "spectral-condition", smooth ? "C1" : "spectral-condition");
  const Valences valences = read_valences(claim);

  std::vector<std::string> keys{"rings", "level", "valences"};
  if (has_levels) keys.emplace_back("from_level");
  if (!valences.last) keys.emplace_back("all");
  if (smooth) keys.emplace_back("map");
  const Reader proof(json["proof"], "proof", "the proof", keys);
  std::string levels;
  if (has_levels) {
    const Sequence curve{scheme.name, scheme.angle, scheme.hyperbolic, 2, {}, {}};
    const Reader region(claim.at("region"), "claim", "the claimed region", {scheme.angle});
    const Interval angles = read_angles(region.text(region.at(scheme.angle.c_str()), "the interval of the angle"), curve,
                                        "claim", budget);
    if (smooth && (!angles.is_point() || angles.lower.value != 0))
      throw Rejected{"claim", "theorem E2 is about equal rules at all levels, so about the angle 0"};
    prove_levels(scheme, curve, angles, proof.integer(proof.at("from_level"), "from_level", 0, 128), budget);
    levels = shown_angles(curve, angles);
  }

  const RingScheme limit = limit_scheme(scheme, budget);
  const int rings = proof.integer(proof.at("rings"), "rings", 1, 8);
  prove_regular_part(limit, rings, proof.integer(proof.at("level"), "level", 1, 24), budget);
  const std::vector<Separation> separations =
      prove_spectral_condition(limit, rings, valences, proof.list("valences", 0, max_valence),
                               valences.last ? nullptr : &proof.at("all"), budget);
  if (smooth) {
    const auto single = std::count_if(separations.begin(), separations.end(),
                                      [](const Separation& s) { return s.valence != 0; });
    prove_characteristic_maps(limit, rings, separations, valences.first + static_cast<int>(single), proof.at("map"), budget);
  }

  const std::string where = std::string(" at extraordinary ") + (scheme.dual ? "faces" : "vertices") + " of " + shown(valences);
  if (smooth) return "certified: " + scheme.name + " is C1 for almost every net" + where + levels + " (theorem E2)";
  if (!has_levels) return "certified: " + scheme.name + " satisfies the spectral condition" + where + " (theorem E1)";
  return "certified: the limit matrix M of " + scheme.name + (scheme.hyperbolic ? " (hyperbolic)" : " (trigonometric)") +
         " satisfies the spectral condition" + where + ", and the sum of 2^k ||M_k - M|| is finite" + levels +
         " (theorem E1)";
}

}  // namespace limes::checker
