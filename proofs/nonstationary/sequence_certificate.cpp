// The JSON form of certificates about nonstationary schemes (docs/certificate.md).

#include "algebra/error.hpp"
#include "proofs/nonstationary/sequence_proof.hpp"

#include <nlohmann/json.hpp>

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json mask_to_json(const Mask& mask, const std::string& variable) {
  const CommonDenominator common = over_common_denominator(mask.symbol);
  Json entries = Json::array();
  for (const MultivariatePolynomial& a : common.numerators) {
    std::string entry = to_string(a, {variable});
    if (!common.denominator.is_constant())
      entry = "(" + entry + ")/(" + to_string(common.denominator, {variable}) + ")";
    entries.push_back(std::move(entry));
  }
  return {{"first_index", mask.symbol.lowest()}, {"mask", entries}};
}

Json scheme_to_json(const Certificate& certificate) {
  const MaskSequence& sequence = std::get<MaskSequence>(certificate.definition);
  Json json{{"kind", "nonstationary"},
            {"name", certificate.scheme},
            {"parameters", certificate.parameters},
            {"level_parameter", sequence.level_parameter},
            {"type", to_string(certificate.claim.type)},
            {"arity", sequence.mask.arity}};
  json.update(mask_to_json(sequence.mask, sequence.level_parameter));
  json["first_levels"] = Json::array();
  for (const Mask& mask : sequence.first_levels)
    json["first_levels"].push_back(mask_to_json(mask, sequence.level_parameter));
  return json;
}

Json region_to_json(const Certificate& certificate, const Interval& angles) {
  return {{certificate.parameters.front(), to_string(angles)}};
}

Json proof_to_json(const Certificate& certificate) {
  if (const auto* asymptotic = std::get_if<AsymptoticProof>(&certificate.proof)) {
    return {{"from_level", asymptotic->bound.from_level},
            {"factors", asymptotic->bound.factors},
            {"order", asymptotic->bound.order},
            {"constant", to_string(asymptotic->bound.constant)},
            {"limit", Json::parse(asymptotic->limit_certificate)}};
  }
  const SpaceProof& space = std::get<SpaceProof>(certificate.proof);
  Json json{{"from_level", space.from_level}};
  if (space.function) {
    json["function"] = *space.function;
    json["region"] = region_to_json(certificate, space.angles);
  }
  if (space.defects.empty()) return json;
  json["defects"] = Json::array();
  for (const MomentDefect& defect : space.defects) {
    json["defects"].push_back({{"residue", defect.residue},
                               {"moment", defect.moment},
                               {"part", defect.part == MomentPart::even ? "even" : "odd"}});
  }
  return json;
}

}  // namespace

std::string sequence_certificate_json(const Certificate& certificate) {
  const Json json{{"format", "limes-certificate"},
                  {"version", 1},
                  {"scheme", scheme_to_json(certificate)},
                  {"claim",
                   {{"statement", statement(certificate.claim)},
                    {"region", region_to_json(certificate, certificate.claim.region.front())}}},
                  {"verdict", to_string(certificate.verdict)},
                  {"theorem", to_string(certificate.theorem)},
                  {"proof", proof_to_json(certificate)}};
  return json.dump(1) + "\n";
}

}  // namespace limes
