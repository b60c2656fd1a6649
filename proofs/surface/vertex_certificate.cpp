// The JSON form of certificates about extraordinary vertices (docs/certificate.md).

#include "proofs/certificate_text_impl.hpp"
#include "proofs/surface/vertex_proof.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json terms_to_json(const std::vector<RingTerm>& terms, const VariableNames& names) {
  Json json = Json::array();
  for (const RingTerm& t : terms) {
    Json own{{"point", {t.point.a, t.point.b}}};
    if (t.harmonic >= 0) own["harmonic"] = t.harmonic;
    else own["sector"] = t.sector;
    own["weight"] = to_string(t.weight, names);
    json.push_back(std::move(own));
  }
  return json;
}

Json scheme_to_json(const Certificate& certificate) {
  const SurfaceRule& surface = std::get<SurfaceRule>(certificate.definition);
  const RingRule& rule = surface.rings;
  const VariableNames names{surface.sequence.level_parameter, "n"};
  Json json{{"kind", "surface"}, {"name", certificate.scheme}, {"dual", rule.dual}};
  if (!certificate.parameters.empty()) {
    json["parameters"] = certificate.parameters;
    json["level_parameter"] = surface.sequence.level_parameter;
    json["type"] = to_string(certificate.claim.type);
  }
  json["first_index"] = rule.curve.symbol.lowest();
  json["mask"] = Json::array();
  for (const RationalFunction& a : rule.curve.symbol.coefficients()) json["mask"].push_back(to_string(a, names));
  json["rules"] = Json::array();
  for (const auto& [point, terms] : rule.given) {
    json["rules"].push_back({{"point", {point.a, point.b}}, {"terms", terms_to_json(terms, names)}});
  }
  return json;
}

Json claim_to_json(const Certificate& certificate) {
  Json json{{"statement", statement(certificate.claim)}, {"valence", to_string(*certificate.claim.valences)}};
  if (!certificate.parameters.empty())
    json["region"] = {{certificate.parameters.front(), to_string(certificate.claim.region.front())}};
  return json;
}

Json all_to_json(const AllValencesProof& all) {
  Json json{{"from", all.from}, {"start", to_string(all.start)}, {"bound", to_string(all.bound)}};
  if (all.touch) json["touch"] = to_string(*all.touch);
  json["cells"] = Json::array();
  for (const CosineCell& cell : all.cells) {
    json["cells"].push_back({{"to", to_string(cell.to)},
                             {"separator", to_string(cell.separator)},
                             {"root", {to_string(cell.root.lower), to_string(cell.root.upper)}}});
  }
  return json;
}

Json map_to_json(const CharacteristicMapProof& map, bool for_all) {
  Json json{{"levels", map.levels}};
  if (!for_all) return json;
  json["start"] = to_string(map.start);
  json["pieces"] = Json::array();
  for (const auto& piece : map.pieces) json["pieces"].push_back({{"to", to_string(piece.to)}, {"level", piece.level}});
  return json;
}

Json proof_to_json(const Certificate& certificate) {
  const VertexProof& proof = std::get<VertexProof>(certificate.proof);
  Json json{{"rings", proof.rings}, {"level", proof.level}};
  if (!certificate.parameters.empty()) json["from_level"] = proof.from_level;
  json["valences"] = Json::array();
  int n = certificate.claim.valences->first;
  for (const Rational& separator : proof.separators) json["valences"].push_back({{"valence", n++}, {"separator", to_string(separator)}});
  if (proof.all) json["all"] = all_to_json(*proof.all);
  if (proof.map) json["map"] = map_to_json(*proof.map, proof.all.has_value());
  return json;
}

}  // namespace

std::string vertex_certificate_json(const Certificate& certificate) {
  return certificate_text(Json{{"format", "limes-certificate"},
                               {"version", 1},
                               {"scheme", scheme_to_json(certificate)},
                               {"claim", claim_to_json(certificate)},
                               {"verdict", to_string(certificate.verdict)},
                               {"theorem", to_string(certificate.theorem)},
                               {"proof", proof_to_json(certificate)}});
}

std::string describe_vertex_proof(const Certificate& certificate) {
  const VertexProof& proof = std::get<VertexProof>(certificate.proof);
  const SurfaceRule& surface = std::get<SurfaceRule>(certificate.definition);
  const bool varies = !certificate.parameters.empty();
  std::string text = fmt::format("{} is a simple eigenvalue, the subdominant one is real and simple in Fourier blocks 1 and n-1, all others are smaller",
                                 varies ? "of the limit matrix M, 1" : "1");
  if (proof.map) text += "; the characteristic map is regular and injective";
  else if (varies) text += ", and the sum of 2^k ||M_k - M|| is finite";
  if (!proof.map) text += fmt::format(" (this alone is not C1: the characteristic map at the {} is not looked at)", surface.rings.dual ? "faces" : "vertices");
  return text;
}

}  // namespace limes
