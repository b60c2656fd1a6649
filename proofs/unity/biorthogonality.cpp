#include "proofs/unity/biorthogonality.hpp"

#include "algebra/error.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/number_json_impl.hpp"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Json bounds_to_json(const RationalBounds& bounds) { return {to_string(bounds.lower), to_string(bounds.upper)}; }

}  // namespace

BiorthogonalityProof prove_biorthogonality(const std::string& scheme, const Mask& mask, const FilterBank& bank) {
  const Rational squared_error = exact_squared_orthogonality_error(bank);
  const RationalBounds error = sqrt_bounds(squared_error);
  const RationalBounds squared_bounds{error.lower * error.lower, error.upper * error.upper};
  const ExtremeValue sigma = squared_singular_values(bank.p).least, a = squared_singular_values(bank.a).greatest,
                     b = squared_singular_values(bank.b).greatest;
  BiorthogonalityProof proof{error, sqrt_bounds(sigma.bounds), sqrt_bounds(a.bounds), sqrt_bounds(b.bounds), {}};
  if (exact_biorthogonality_defect(bank) != 0) return proof;
  const Json certificate{{"format", "limes-certificate"},
                         {"version", 1},
                         {"scheme",
                          {{"kind", "uniform"},
                           {"name", scheme},
                           {"parameters", Json::array()},
                           {"arity", mask.arity},
                           {"first_index", mask.symbol.lowest()},
                           {"mask", numbers_to_json(mask.symbol.rational_coefficients())}}},
                         {"claim",
                          {{"statement", "biorthogonal"},
                           {"filters",
                            {{"p", numbers_to_json(bank.p)},
                             {"a", numbers_to_json(bank.a)},
                             {"b", numbers_to_json(bank.b)},
                             {"q", numbers_to_json(bank.q)},
                             {"shift", bank.shift}}},
                           {"squares",
                            {{"orthogonality_error", bounds_to_json(squared_bounds)},
                             {"sigma_min_p", bounds_to_json(sigma.bounds)},
                             {"norm_a", bounds_to_json(a.bounds)},
                             {"norm_b", bounds_to_json(b.bounds)}}}}},
                         {"verdict", "certified"},
                         {"theorem", "B1"},
                         {"proof",
                          {{"sigma_min_p", to_string(sigma.witness)},
                           {"norm_a", to_string(a.witness)},
                           {"norm_b", to_string(b.witness)}}}};
  proof.certificate_json = certificate.dump(2) + "\n";
  const checker::Result result = checker::check(proof.certificate_json);
  if (!result.valid) throw InternalError("the checker rejects a certificate: " + result.step + ": " + result.reason);
  return proof;
}

}  // namespace limes
