#include "proofs/spectral_radius/radius_certificate.hpp"

#include "algebra/error.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/mask_json_impl.hpp"
#include "proofs/number_json_impl.hpp"
#include "proofs/spectral_radius/norm_json_impl.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json exact_polytope_to_json(const ExactPolytope& exact) {
  Json starts = Json::array(), tree = Json::array(), images = Json::array();
  for (const AlgebraicVector& v : exact.starts) {
    Json entries = Json::array();
    for (const Polynomial& entry : v) entries.push_back(numbers_to_json(entry.coefficients()));
    starts.push_back(std::move(entries));
  }
  for (const auto& [parent, letter] : exact.tree) tree.push_back(Json::array({parent, letter}));
  for (const auto& of_matrix : exact.images) {
    Json list = Json::array();
    for (const ExactPolytope::Image& image : of_matrix) {
      if (const auto* same = std::get_if<ExactPolytope::SignedVector>(&image))
        list.push_back(same->sign * (same->index + 1));
      else
        list.push_back(combination_to_json(std::get<SparseCombination>(image), exact.starts.size() + exact.tree.size()));
    }
    images.push_back(std::move(list));
  }
  return {{"polynomial", numbers_to_json(exact.radius.polynomial.coefficients())},
          {"interval", numbers_to_json({exact.radius.lower, exact.radius.upper})},
          {"word", exact.word},
          {"sign", exact.sign},
          {"starts", std::move(starts)},
          {"tree", std::move(tree)},
          {"unit", to_string(exact.unit)},
          {"images", std::move(images)}};
}

Json radius_proof_to_json(const SpectralRadiusBounds& bounds) {
  Json blocks = Json::array();
  for (const BlockProof& proof : bounds.blocks) {
    if (const auto* exact = std::get_if<ExactPolytope>(&proof)) {
      blocks.push_back(exact_polytope_to_json(*exact));
    } else {
      const BoundedPolytope& bounded = std::get<BoundedPolytope>(proof);
      blocks.push_back({{"bound", to_string(bounded.bound)}, {"polytope", polytope_to_json(bounded.polytope)}});
    }
  }
  return {{"word", bounds.word}, {"form", form_to_json(bounds.form)}, {"blocks", std::move(blocks)}};
}

std::string checked(const Json& certificate) {
  std::string text = certificate.dump(1) + "\n";
  const checker::Result result = checker::check(text);
  if (result.valid) return text;
  if (result.step == "limits") throw LimitError(fmt::format("limes-check refuses to check so much: {}", result.reason));
  throw InternalError(fmt::format("limes-check rejects a certificate: {}: {}", result.step, result.reason));
}

}  // namespace

std::string prove_spectral_radius(const MatrixFamily& family, const SpectralRadiusBounds& bounds) {
  Json matrices = Json::array();
  for (const RationalMatrix& b : family) matrices.push_back(matrix_to_json(b));
  Json claim{{"lower", to_string(bounds.lower)}, {"upper", to_string(bounds.upper)}};
  if (bounds.exact) claim["polynomial"] = numbers_to_json(bounds.exact->polynomial.coefficients());
  return checked({{"format", "limes-certificate"},
                  {"version", 1},
                  {"theorem", "JSR"},
                  {"matrices", std::move(matrices)},
                  {"claim", std::move(claim)},
                  {"proof", radius_proof_to_json(bounds)}});
}

std::string prove_hoelder_exponent(const Scheme& scheme, std::span<const Rational> point, const HoelderExponent& exponent) {
  if (!exponent.bounds.lower) throw DomainError("prove_hoelder_exponent: there is no lower bound");
  const VariableNames names = scheme.parameter_names();
  Json region = Json::object();
  for (std::size_t k = 0; k < names.size(); ++k) region[names[k]] = to_string(point[k]);
  Json claim{{"statement", "Hoelder exponent"}, {"region", std::move(region)}, {"lower", to_string(*exponent.bounds.lower)}};
  Json proof{{"order", exponent.order},
             {"radius_lower", to_string(exponent.radius.lower)},
             {"radius_upper", to_string(exponent.radius.upper)},
             {"radius", exponent.level ? Json{{"word", exponent.radius.word}, {"level", *exponent.level}} : radius_proof_to_json(exponent.radius)}};
  if (exponent.bounds.upper) {
    claim["upper"] = to_string(*exponent.bounds.upper);
    if (exponent.radius.exact) claim["polynomial"] = numbers_to_json(exponent.radius.exact->polynomial.coefficients());
    proof["stability"] = *exponent.stability == Stability::interpolatory ? "interpolatory" : "linear-independence";
  }
  return checked({{"format", "limes-certificate"},
                  {"version", 1},
                  {"scheme",
                   {{"kind", "uniform"},
                    {"name", scheme.name},
                    {"parameters", names},
                    {"arity", scheme.mask.arity},
                    {"first_index", scheme.mask.symbol.lowest()},
                    {"mask", mask_to_json(scheme.mask, names)}}},
                  {"claim", std::move(claim)},
                  {"theorem", "U3"},
                  {"proof", std::move(proof)}});
}

ProvedExponent bound_and_prove_hoelder_exponent(const Scheme& scheme, std::span<const Rational> point, int digits, const Stop& stop) {
  const Mask mask = at(scheme.mask, point);
  const auto attempt = [&](const PolytopeLimits& limits) {
    ProvedExponent result{bound_hoelder_exponent(mask, digits, limits, stop), {}};
    if (result.exponent.bounds.lower) result.certificate = prove_hoelder_exponent(scheme, point, result.exponent);
    return result;
  };
  try {
    return attempt({});
  } catch (const LimitError&) {
    return attempt({.max_degree = 1});
  }
}

}  // namespace limes
