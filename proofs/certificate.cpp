#include "proofs/certificate.hpp"

#include "algebra/error.hpp"

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
  return json;
}

std::string to_text(Stability stability) {
  return stability == Stability::interpolatory ? "interpolatory" : "linear-independence";
}

}  // namespace

std::string to_string(Theorem theorem) {
  switch (theorem) {
    case Theorem::u1: return "U1";
    case Theorem::u2: return "U2";
  }
  throw InternalError("unknown theorem");
}

std::string to_json(const Certificate& certificate) {
  const LaurentPolynomial& symbol = certificate.mask.symbol;
  // All entries over the one denominator that the proof used, so that the checker forms the same one.
  const MultivariatePolynomial denominator = common_denominator(symbol);
  Json mask = Json::array();
  for (const MultivariatePolynomial& numerator : numerators_over(symbol, denominator)) {
    std::string entry = to_string(numerator, certificate.parameters);
    if (!denominator.is_constant()) entry = "(" + entry + ")/(" + to_string(denominator, certificate.parameters) + ")";
    mask.push_back(std::move(entry));
  }
  Json proof = Json::object();
  if (certificate.stability) proof["stability"] = to_text(*certificate.stability);
  proof["leaves"] = Json::array();
  for (const ProofLeaf& leaf : certificate.leaves) proof["leaves"].push_back(leaf_to_json(leaf, certificate.parameters));
  const Json json{{"format", "limes-certificate"},
                  {"version", 1},
                  {"scheme",
                   {{"kind", "uniform"},
                    {"name", certificate.scheme},
                    {"parameters", certificate.parameters},
                    {"arity", certificate.mask.arity},
                    {"first_index", symbol.lowest()},
                    {"mask", mask}}},
                  {"claim",
                   {{"statement", statement(certificate.claim)},
                    {"region", region_to_json(certificate.claim.region, certificate.parameters)}}},
                  {"verdict", to_string(certificate.verdict)},
                  {"theorem", to_string(certificate.theorem)},
                  {"proof", proof}};
  return json.dump(1) + "\n";
}

}  // namespace limes
