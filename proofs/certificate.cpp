#include "proofs/certificate.hpp"

#include "algebra/error.hpp"
#include "proofs/mask_json_impl.hpp"

#include <nlohmann/json.hpp>

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json region_to_json(const Box& region, const VariableNames& names) {
  Json json = Json::object();
  for (std::size_t k = 0; k < names.size(); ++k) json[names[k]] = to_string(region[k]);
  return json;
}

Json leaf_to_json(const ProofLeaf& leaf, const VariableNames& names) {
  Json json{{"region", region_to_json(leaf.region, names)}};
  if (const auto* contraction = std::get_if<ContractionWitness>(&leaf.witness)) json["level"] = contraction->level;
  if (std::holds_alternative<MissingFactorWitness>(leaf.witness)) json["missing_factor"] = true;
  if (const auto* word = std::get_if<WordWitness>(&leaf.witness)) json["word"] = word->word;
  if (const auto* ratio = std::get_if<RatioWitness>(&leaf.witness)) json["gamma"] = to_string(ratio->gamma);
  return json;
}

Json leaves_to_json(const std::vector<ProofLeaf>& leaves, const VariableNames& names) {
  Json json = Json::array();
  for (const ProofLeaf& leaf : leaves) json.push_back(leaf_to_json(leaf, names));
  return json;
}

Json dominance_to_json(std::size_t factor, const DominanceLeaf& leaf, const VariableNames& names) {
  Json json{{"factor", factor}, {"region", region_to_json(leaf.box, names)}, {"test", std::string(to_string(leaf.method))}};
  // The cuts of c = cos t inside of [-1, 1].
  if (leaf.method == DominanceMethod::circle && leaf.cuts.size() > 2) {
    json["c"] = Json::array();
    for (std::size_t k = 1; k + 1 < leaf.cuts.size(); ++k) json["c"].push_back(to_string(leaf.cuts[k]));
  }
  return json;
}

std::string to_text(Stability stability) {
  return stability == Stability::interpolatory ? "interpolatory" : "linear-independence";
}

}  // namespace

Json mask_to_json(const Mask& mask, const VariableNames& names) {
  const MultivariatePolynomial denominator = common_denominator(mask.symbol);
  Json entries = Json::array();
  for (const MultivariatePolynomial& numerator : numerators_over(mask.symbol, denominator)) {
    std::string entry = to_string(numerator, names);
    if (!denominator.is_constant()) entry = "(" + entry + ")/(" + to_string(denominator, names) + ")";
    entries.push_back(std::move(entry));
  }
  return entries;
}

namespace {

Json rule_to_json(const InsertionRuleText& rule) {
  Json json = Json::object();
  json["points"] = rule.points;
  if (!rule.coefficients.empty()) {
    json["coefficients"] = Json::array();
    for (const auto& line : rule.coefficients) json["coefficients"].push_back(line.text);
    return json;
  }
  json["let"] = Json::array();
  for (const auto& definition : rule.let) json["let"].push_back(Json::array({definition.name, definition.value.text}));
  json["rule"] = rule.new_point.text;
  return json;
}

Json scheme_to_json(const Certificate& certificate) {
  const auto* mask = std::get_if<Mask>(&certificate.definition);
  Json json{{"kind", mask ? "uniform" : "nonuniform"}, {"name", certificate.scheme}, {"parameters", certificate.parameters}};
  if (mask) {
    json["arity"] = mask->arity;
    json["first_index"] = mask->symbol.lowest();
    json["mask"] = mask_to_json(*mask, certificate.parameters);
  } else {
    json.update(rule_to_json(std::get<InsertionRuleText>(certificate.definition)));
  }
  return json;
}

Json proof_to_json(const Certificate& certificate) {
  const VariableNames& names = certificate.parameters;
  Json json = Json::object();
  if (const auto* leaves = std::get_if<LeafProof>(&certificate.proof)) {
    if (certificate.theorem == Theorem::n3) return leaf_to_json(leaves->leaves.front(), names);
    if (leaves->stability) json["stability"] = to_text(*leaves->stability);
    json["leaves"] = leaves_to_json(leaves->leaves, names);
  } else {
    const KnotProof& knots = std::get<KnotProof>(certificate.proof);
    VariableNames with_ratio = names;
    with_ratio.emplace_back("gamma");
    json["uniform"] = {{"leaves", leaves_to_json(knots.uniform_leaves, names)}};
    json["factors"] = Json::array();
    json["multiplicities"] = Json::array();
    json["dominance"] = Json::array();
    for (std::size_t k = 0; k < knots.factors.size(); ++k) {
      const DominatedFactor& factor = knots.factors[k];
      Json coefficients = Json::array();
      for (const MultivariatePolynomial& d : factor.polynomial.coefficients()) coefficients.push_back(to_string(d, with_ratio));
      json["factors"].push_back(std::move(coefficients));
      json["multiplicities"].push_back(factor.multiplicity);
      for (const DominanceLeaf& leaf : factor.leaves) json["dominance"].push_back(dominance_to_json(k, leaf, with_ratio));
    }
  }
  return json;
}

int highest_level(const std::vector<ProofLeaf>& leaves) {
  int level = 0;
  for (const ProofLeaf& leaf : leaves) {
    if (const auto* contraction = std::get_if<ContractionWitness>(&leaf.witness)) level = std::max(level, contraction->level);
  }
  return level;
}

}  // namespace

std::string to_string(Theorem theorem) {
  switch (theorem) {
    case Theorem::u1: return "U1";
    case Theorem::u2: return "U2";
    case Theorem::n1: return "N1";
    case Theorem::n3: return "N3";
  }
  throw InternalError("unknown theorem");
}

int Certificate::level() const {
  if (const auto* leaves = std::get_if<LeafProof>(&proof)) return highest_level(leaves->leaves);
  return highest_level(std::get<KnotProof>(proof).uniform_leaves);
}

int Certificate::leaf_count() const {
  if (const auto* leaves = std::get_if<LeafProof>(&proof)) return static_cast<int>(leaves->leaves.size());
  const KnotProof& knots = std::get<KnotProof>(proof);
  std::size_t count = knots.uniform_leaves.size();
  for (const DominatedFactor& factor : knots.factors) count += factor.leaves.size();
  return static_cast<int>(count);
}

std::string to_json(const Certificate& certificate) {
  const Json json{{"format", "limes-certificate"},
                  {"version", 1},
                  {"scheme", scheme_to_json(certificate)},
                  {"claim",
                   {{"statement", statement(certificate.claim)},
                    {"region", region_to_json(certificate.claim.region, certificate.parameters)}}},
                  {"verdict", to_string(certificate.verdict)},
                  {"theorem", to_string(certificate.theorem)},
                  {"proof", proof_to_json(certificate)}};
  return json.dump(1) + "\n";
}

}  // namespace limes
