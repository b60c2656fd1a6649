// SPDX-License-Identifier: MIT
//
// Theorem E1: the spectral condition at an isolated extraordinary vertex or face of valence n (Reif 1995; Peters & Reif 2008). What is
// shown, and that it implies the condition, is in docs/theory.md and docs/certificate.md.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/enclosure.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/ring.hpp"
#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

constexpr int max_valence = 1000;

/// The valences first, first + 1, .., last; without a last one all from the first on.
struct Valences {
  int first = 3;
  std::optional<int> last;
};

mpq_class read_number(const Reader& reader, const char* key, Budget& budget) {
  const std::string& text = reader.text(reader.at(key), key);
  budget.work(1000 + 2. * static_cast<double>(text.size() * text.size()));
  return read_rational(text, "proof");
}

/// "5", "[3, 50]" or "[3, inf)".
Valences read_valences(const Reader& claim) {
  const std::string& text = claim.text(claim.at("valence"), "valence");
  const auto number = [&](std::string_view digits) {
    const bool fits = !digits.empty() && digits.size() <= 4 &&
                      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    const int n = fits ? std::stoi(std::string(digits)) : 0;
    if (n < 3 || n > max_valence) claim.fail("needs valences from 3 to " + std::to_string(max_valence));
    return n;
  };
  if (!text.starts_with('[')) return {number(text), number(text)};
  const auto comma = text.find(", ");
  const std::string_view all = text;
  if (comma == std::string::npos) claim.fail("needs a valence n, [n, m] or [n, inf)");
  const int first = number(all.substr(1, comma - 1));
  if (all.substr(comma) == ", inf)") return {first, std::nullopt};
  if (!text.ends_with(']')) claim.fail("needs a valence n, [n, m] or [n, inf)");
  const int last = number(all.substr(comma + 2, all.size() - comma - 3));
  if (first >= last) claim.fail("has valences that are not in order");
  return {first, last};
}

}  // namespace

std::string check_e1(const Json& json, Budget& budget) {
  const Reader reader(json, "format", "the certificate",
                      {"format", "version", "scheme", "claim", "verdict", "theorem", "proof"});
  reader.is_first("verdict", "certified", "certified");
  const RingScheme scheme = read_ring_scheme(json["scheme"], budget);
  const Reader claim(json["claim"], "claim", "the claim", {"statement", "valence"});
  claim.is_first("statement", "spectral-condition", "spectral-condition");
  const Valences valences = read_valences(claim);
  (void)read_number;
  const RingBlocks blocks = ring_blocks(scheme, 3, valences.last ? std::optional(valences.first) : std::nullopt, budget);
  for (const auto* block : {&blocks.zero, &blocks.first, &blocks.generic})
    for (const auto& factor : characteristic_factors(*block, budget)) {
      std::string text;
      for (const auto& c : factor) {
        text += "{";
        for (const auto& [e, w] : c) text += std::to_string(e) + ":" + w.get_str() + " ";
        text += "} ";
      }
      printf("%s\n", text.c_str());
    }
  return "certified: nothing";
}

}  // namespace limes::checker
