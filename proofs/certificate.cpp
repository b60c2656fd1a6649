#include "proofs/certificate.hpp"

#include "algebra/error.hpp"
#include "proofs/certificate_text_impl.hpp"
#include "proofs/mask_json_impl.hpp"
#include "proofs/nonstationary/sequence_proof.hpp"
#include "proofs/number_json_impl.hpp"
#include "proofs/spectral_radius/norm_json_impl.hpp"
#include "proofs/surface/vertex_proof.hpp"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json leaf_to_json(const ProofLeaf& leaf, const VariableNames& names) {
  Json json{{"region", region_to_json(leaf.region, names)}};
  if (const auto* contraction = std::get_if<ContractionWitness>(&leaf.witness)) json["level"] = contraction->level;
  if (const auto* polytope = std::get_if<PolytopeWitness>(&leaf.witness)) {
    json["polytope"] = {{"bound", to_string(polytope->bound())}};
    if (const auto* fixed = std::get_if<PolytopeNorm>(&polytope->norm)) json["polytope"]["norm"] = norm_to_json(*fixed);
    else json["polytope"]["moving"] = norm_to_json(std::get<MovingNorm>(polytope->norm));
  }
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

/// The ends of the intervals between which there is one root each, and lower bounds of the moduli of these roots if a pair of
/// conjugate ones is left.
void add_separation(Json& json, const DominanceLeaf& leaf, int degree) {
  std::vector<Rational> curves;
  Json distances = Json::array();
  for (const Interval& root : leaf.roots) {
    if (curves.empty() || curves.back() != root.lower) curves.push_back(root.lower);
    curves.push_back(root.upper);
    distances.push_back(to_string(std::min(Rational(abs(root.lower)), Rational(abs(root.upper)))));
  }
  json["curves"] = Json::array();
  for (const Rational& curve : curves) json["curves"].push_back(to_string(curve));
  if (static_cast<int>(leaf.roots.size()) < degree) json["distances"] = std::move(distances);
}

Json dominance_to_json(std::size_t factor, int degree, const DominanceLeaf& leaf, const VariableNames& names) {
  Json json{{"factor", factor}, {"region", region_to_json(leaf.box, names)}, {"test", std::string(to_string(leaf.method))}};
  // The cuts of c = cos t inside of [-1, 1].
  if (leaf.method == DominanceMethod::circle && leaf.cuts.size() > 2) {
    json["c"] = Json::array();
    for (std::size_t k = 1; k + 1 < leaf.cuts.size(); ++k) json["c"].push_back(to_string(leaf.cuts[k]));
  }
  if (leaf.method == DominanceMethod::sign_separation) add_separation(json, leaf, degree);
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

Json cone_to_json(const ConeProof& proof) {
  const ProjectiveContraction& contraction = proof.contraction;
  Json json{{"cone", {{"lower", numbers_to_json(contraction.cone.lower)}, {"upper", numbers_to_json(contraction.cone.upper)}}},
            {"level", contraction.level}};
  if (!proof.roughness) return json;
  const ProjectiveRoughness& rough = *proof.roughness;
  json["word"] = rough.word;
  json["dominant"] = {{"value", to_string(rough.dominant.value)}, {"vector", numbers_to_json(rough.dominant.vector)}};
  json["second"] = {{"value", to_string(rough.second.value)}, {"vector", numbers_to_json(rough.second.vector)}};
  json["window"] = rough.window;
  return json;
}

Json proof_to_json(const Certificate& certificate) {
  const VariableNames& names = certificate.parameters;
  if (const auto* cone = std::get_if<ConeProof>(&certificate.proof)) return cone_to_json(*cone);
  Json json = Json::object();
  if (const auto* zero = std::get_if<ZeroLimitProof>(&certificate.proof)) {
    if (zero->word) json["word"] = *zero->word;
  } else if (const auto* leaves = std::get_if<LeafProof>(&certificate.proof)) {
    if (certificate.theorem == Theorem::n3 && leaves->leaves.size() == 1) return leaf_to_json(leaves->leaves.front(), names);
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
    if (knots.both_sides) json["mirrored"] = Json::array();
    for (std::size_t k = 0; k < knots.factors.size(); ++k) {
      const DominatedFactor& factor = knots.factors[k];
      Json coefficients = Json::array();
      for (const MultivariatePolynomial& d : factor.polynomial.coefficients()) coefficients.push_back(to_string(d, with_ratio));
      json["factors"].push_back(std::move(coefficients));
      json["multiplicities"].push_back(factor.multiplicity);
      const auto add = [&](const char* key, const std::vector<DominanceLeaf>& boxes) {
        for (const DominanceLeaf& leaf : boxes) {
          json[key].push_back(dominance_to_json(k, factor.polynomial.degree(), leaf, with_ratio));
        }
      };
      add("dominance", factor.leaves);
      add("mirrored", factor.mirrored_leaves);
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
    case Theorem::s1: return "S1";
    case Theorem::s2: return "S2";
    case Theorem::p0: return "P0";
    case Theorem::p1: return "P1";
    case Theorem::p2: return "P2";
    case Theorem::e1: return "E1";
    case Theorem::e2: return "E2";
  }
  throw InternalError("unknown theorem");
}

const Rational& PolytopeWitness::bound() const {
  return std::visit([](const auto& polytopes) -> const Rational& { return polytopes.bound; }, norm);
}

std::size_t PolytopeWitness::vectors() const {
  return std::visit(
      [](const auto& polytopes) {
        std::size_t count = 0;
        for (const auto& block : polytopes.blocks) count += block.vectors.size();
        return count;
      },
      norm);
}

int Certificate::level() const {
  if (const auto* leaves = std::get_if<LeafProof>(&proof)) return highest_level(leaves->leaves);
  if (const auto* asymptotic = std::get_if<AsymptoticProof>(&proof)) return asymptotic->limit_level;
  if (const auto* cone = std::get_if<ConeProof>(&proof)) return cone->contraction.level;
  if (const auto* vertex = std::get_if<VertexProof>(&proof)) return vertex->level;
  const auto* knots = std::get_if<KnotProof>(&proof);
  return knots ? highest_level(knots->uniform_leaves) : 0;
}

int Certificate::leaf_count() const {
  if (const auto* leaves = std::get_if<LeafProof>(&proof)) return static_cast<int>(leaves->leaves.size());
  if (const auto* vertex = std::get_if<VertexProof>(&proof))
    return static_cast<int>(vertex->separators.size() + (vertex->all ? vertex->all->cells.size() : 0));
  const auto* knots = std::get_if<KnotProof>(&proof);
  if (!knots) return 1;
  std::size_t count = knots->uniform_leaves.size();
  for (const DominatedFactor& factor : knots->factors) count += factor.leaves.size() + factor.mirrored_leaves.size();
  return static_cast<int>(count);
}

std::string to_json(const Certificate& certificate) {
  if (std::holds_alternative<MaskSequence>(certificate.definition)) return sequence_certificate_json(certificate);
  if (std::holds_alternative<SurfaceRule>(certificate.definition)) return vertex_certificate_json(certificate);
  const Json json{{"format", "limes-certificate"},
                  {"version", 1},
                  {"scheme", scheme_to_json(certificate)},
                  {"claim",
                   {{"statement", statement(certificate.claim)},
                    {"region", region_to_json(certificate.claim.region, certificate.parameters)}}},
                  {"verdict", to_string(certificate.verdict)},
                  {"theorem", to_string(certificate.theorem)},
                  {"proof", proof_to_json(certificate)}};
  return certificate_text(json);
}

}  // namespace limes
