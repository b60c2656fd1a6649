// SPDX-License-Identifier: MIT
//
// Theorem E2: with the spectral condition (theorem E1), a characteristic map that is regular and injective makes almost every limit surface
// C^1 at the vertex. This is the part about the maps: one interval of C = cos(pi/n) for each valence, or intervals that cover those of
// all; lambda above the separator is the eigenvalue that the spectral condition speaks of, for 2 C^2 - 1 = cos(2 pi/n).
#include "proofs/checker/characteristic_map.hpp"
#include "proofs/checker/json.hpp"

namespace limes::checker {
namespace {

std::vector<mpq_class> mask_of(const RingScheme& scheme) {
  std::vector<mpq_class> mask;
  const auto number = [](const Polynomial& p) { return p.empty() ? mpq_class(0) : p.begin()->second; };
  for (const Fraction& a : scheme.mask) mask.push_back(number(a.numerator) / number(a.denominator));
  return mask;
}

void require_above(const Enclosure& lambda, const mpq_class& separator) {
  if (!(Enclosure(separator) < lambda))
    throw Rejected{"map", "the eigenvalue of the map is not proved to be the subdominant one"};
}

}  // namespace

void prove_characteristic_maps(const RingScheme& scheme, int rings, const std::vector<Separation>& separations, int first,
                               const Json& json, Budget& budget) {
  const bool has_intervals = std::any_of(separations.begin(), separations.end(),
                                         [](const Separation& s) { return s.valence == 0; });
  std::vector<std::string> keys{"levels"};
  if (has_intervals) keys.insert(keys.end(), {"start", "pieces"});
  const Reader reader(json, "proof", "the map", keys);
  const CurveLimits limits(mask_of(scheme), scheme.dual, budget);
  const auto read_number = [&](const Reader& from, const char* key) {
    const std::string& text = from.text(from.at(key), key);
    budget.work(1000 + 2. * static_cast<double>(text.size() * text.size()));
    return read_rational(text, "proof");
  };

  const Json& levels = reader.list("levels", 0, 1000);
  std::size_t next = 0;
  for (const Separation& s : separations) {
    if (s.valence == 0) continue;
    if (next == levels.size()) reader.fail("lacks a level");
    const int level = reader.integer(levels[next++], "level", 0, 6);
    try {
      budget.work(50 * enclosure_cost);
      const CharacteristicMap map(scheme, limits, rings, s.valence, budget);
      require_above(map.prove(cosine(mpq_class(1, 2 * s.valence)), level, budget), s.separator);
    } catch (const Rejected& rejected) {
      throw Rejected{rejected.step, "valence " + std::to_string(s.valence) + ": " + rejected.reason};
    }
  }
  if (next != levels.size()) reader.fail("has a level too many");
  if (!has_intervals) return;

  mpq_class from = read_number(reader, "start");
  if (from < 0 || cosine(mpq_class(1, 2 * first)).least() < from)
    reader.fail("starts above the cosine of the first valence");
  const CharacteristicMap map(scheme, limits, rings, std::nullopt, budget);
  for (const Json& piece : reader.list("pieces", 1, 2000)) {
    const Reader own(piece, "proof", "a piece of the map", {"to", "level"});
    const mpq_class to = read_number(own, "to");
    if (to <= from || to > 1) own.fail("is not in order");
    const Enclosure lambda = map.prove(Enclosure(from, to), own.integer(own.at("level"), "level", 0, 6), budget);
    // cos(2 pi/n) for the valences of this piece
    const mpq_class low = 2 * from * from - 1, high = 2 * to * to - 1;
    bool covered = false;
    for (const Separation& s : separations) {
      if (s.valence != 0 || s.to < low || high < s.from) continue;
      covered = true;
      require_above(lambda, s.separator);
    }
    if (!covered) throw Rejected{"map", "the spectral condition says nothing about a piece"};
    from = to;
  }
  if (from != 1) reader.fail("has pieces that do not end at 1");
}

}  // namespace limes::checker
