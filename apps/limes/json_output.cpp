#include "apps/limes/json_output.hpp"

#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/stability.hpp"

#include <nlohmann/json.hpp>

namespace limes::app {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json region_json(const Scheme& scheme, const Box& region) {
  Json json = Json::object();
  for (std::size_t k = 0; k < region.size(); ++k) {
    json[scheme.parameters[k].name] = {to_string(region[k].lower), to_string(region[k].upper)};
  }
  return json;
}

/// The same with open ends told: "(0, 1/8]".
Json intervals_json(const Scheme& scheme, const Box& region) {
  Json json = Json::object();
  for (std::size_t k = 0; k < region.size(); ++k) json[scheme.parameters[k].name] = to_string(region[k]);
  return json;
}

Json claim_json(const Scheme& scheme, const Claim& claim) {
  Json json{{"claim", statement(claim)},
            {"smoothness", claim.smoothness},
            {"region", region_json(scheme, claim.region)},
            {"intervals", intervals_json(scheme, claim.region)},
            {"expected", to_string(claim.expected)},
            {"source", claim.source}};
  if (!claim.erratum.empty()) json["erratum"] = claim.erratum;
  return json;
}

Json symbol_json(const LaurentPolynomial& symbol, const VariableNames& names) {
  Json coefficients = Json::array();
  for (const RationalFunction& c : symbol.coefficients()) coefficients.push_back(to_string(c, names));
  return {{"first_index", symbol.lowest()}, {"coefficients", coefficients}};
}

/// {"polynomial": [c_0, .., c_d], "lower", "upper"}: the only root in between; null without one.
Json algebraic_json(const std::optional<AlgebraicNumber>& x) {
  if (!x) return nullptr;
  Json coefficients = Json::array();
  for (const Rational& c : x->polynomial.coefficients()) coefficients.push_back(to_string(c));
  const AlgebraicNumber shown{x->polynomial, x->lower, x->upper};
  return {{"polynomial", coefficients}, {"value", describe(shown)}};
}

}  // namespace

std::string list_json(const std::vector<Scheme>& schemes) {
  Json list = Json::array();
  for (const Scheme& scheme : schemes) {
    Json claims = Json::array();
    for (const Claim& claim : scheme.claims) claims.push_back(claim_json(scheme, claim));
    list.push_back({{"name", scheme.name},
                    {"title", scheme.title},
                    {"kind", to_string(scheme.kind)},
                    {"claims", claims},
                    {"source", scheme.sources}});
  }
  return text({{"schemes", list}});
}

std::string show_json(const Scheme& scheme) {
  const Mask& mask = scheme.mask;
  const VariableNames names = scheme.parameter_names();
  const PolynomialDegrees degrees = polynomial_degrees(mask);
  const int order = sum_rule_order(mask);
  Json claims = Json::array();
  for (const Claim& claim : scheme.claims) claims.push_back(claim_json(scheme, claim));
  Json json{{"name", scheme.name},
            {"title", scheme.title},
            {"kind", to_string(scheme.kind)},
            {"source", scheme.sources},
            {"parameters", intervals_json(scheme, scheme.parameter_box())},
            {"arity", mask.arity},
            {"rule", scheme.rule},
            {"mask", symbol_json(mask.symbol, names)},
            {"sum_rule_order", order},
            {"difference_symbol", symbol_json(*difference_symbol(mask, order), names)},
            {"generation_degree", degrees.generation},
            {"reproduction_degree", degrees.reproduction},
            {"parameter_shift", to_string(degrees.parameter_shift, names)},
            {"interpolatory", interpolatory_index(mask).has_value()},
            {"claims", claims}};
  return text(json);
}

std::string verify_json(const std::vector<VerifiedClaim>& results) {
  Json list = Json::array();
  int counts[3] = {0, 0, 0};
  for (const VerifiedClaim& result : results) {
    const Verdict& verdict = result.verdict;
    ++counts[static_cast<int>(verdict.outcome)];
    Json json{{"scheme", result.scheme->name}};
    json.update(claim_json(*result.scheme, result.claim));
    json["verdict"] = to_string(verdict.outcome);
    json["theorem"] = verdict.certificate ? Json(to_string(verdict.certificate->theorem)) : Json(nullptr);
    json["reason"] = verdict.reason;
    json["level"] = verdict.level();
    json["leaves"] = verdict.leaf_count();
    json["seconds"] = result.seconds;
    json["certificate"] = result.certificate.empty() ? Json(nullptr) : Json(result.certificate);
    list.push_back(json);
  }
  return text({{"results", list}, {"summary", {{"certified", counts[0]}, {"refuted", counts[1]}, {"undecided", counts[2]}}}});
}

std::string check_json(const std::vector<CheckedFile>& results) {
  Json list = Json::array();
  for (const CheckedFile& checked : results) {
    list.push_back({{"file", checked.file},
                    {"valid", checked.result.valid},
                    {"step", checked.result.step},
                    {"reason", checked.result.reason},
                    {"statement", checked.result.statement}});
  }
  return text({{"results", list}});
}

std::string matrix_json(const MatrixReport& report) {
  const SubdivisionMatrix& matrix = report.matrix;
  const auto factors = [&](const std::vector<CharacteristicFactor>& list) {
    Json json = Json::array();
    for (const CharacteristicFactor& factor : list) {
      json.push_back({{"polynomial", to_string(factor.polynomial, report.names)}, {"multiplicity", factor.multiplicity}});
    }
    return json;
  };
  const int last = matrix.points() - 1;
  Json rows = Json::array();
  for (int row = -last; row <= last; ++row) {
    Json entries = Json::array();
    for (int column = -last; column <= last; ++column) entries.push_back(to_string(matrix.entry(row, column), report.names));
    rows.push_back(std::move(entries));
  }
  return text({{"size", matrix.size()},
               {"matrix", rows},
               {"characteristic_polynomial", to_string(report.split.chi, report.names)},
               {"polynomial_eigenvalues", report.split.smoothness + 1},
               {"ell", factors(report.split.ell)},
               {"r", factors(report.split.r)},
               {"eigenvalues_split", !report.split.missing_eigenvalue.has_value()},
               {"symmetric", report.split.is_symmetric()}});
}

std::string norm_json(const Rational& norm, int order, int level) {
  return text({{"norm", to_string(norm)},
               {"decimal", to_decimal(norm, 17, Rounding::up)},
               {"order", order},
               {"level", level}});
}

std::string describe(const AlgebraicNumber& x) {
  if (x.is_rational()) return to_string(x.lower);
  return "the root " + to_decimal(x.lower, 12, Rounding::down) + ".. of " + to_string(x.polynomial, "x");
}

std::string jsr_json(const RadiusReport& report, int digits) {
  const SpectralRadiusBounds& bounds = report.bounds;
  return text({{"lower", to_string(bounds.lower)},
               {"upper", to_string(bounds.upper)},
               {"lower_decimal", to_decimal(bounds.lower, digits, Rounding::down)},
               {"upper_decimal", to_decimal(bounds.upper, digits, Rounding::up)},
               {"word", bounds.word},
               {"exact", algebraic_json(bounds.exact)},
               {"blocks", bounds.form.sizes},
               {"certificate", report.certificate}});
}

std::string holder_json(const HolderReport& report, int digits) {
  const HoelderExponent& exponent = report.exponent;
  const auto end = [](const std::optional<Rational>& x) { return x ? Json(to_string(*x)) : Json(nullptr); };
  const auto decimal = [&](const std::optional<Rational>& x, Rounding rounding) {
    return x ? Json(to_decimal(*x, digits, rounding)) : Json(nullptr);
  };
  Json json{{"lower", end(exponent.bounds.lower)},
            {"upper", end(exponent.bounds.upper)},
            {"lower_decimal", decimal(exponent.bounds.lower, Rounding::down)},
            {"upper_decimal", decimal(exponent.bounds.upper, Rounding::up)},
            {"exact", exponent.exact || (exponent.radius.exact && exponent.stability && exponent.bounds.lower)},
            {"exact_exponent", end(exponent.exact)},
            {"order", exponent.order},
            {"radius", nullptr},
            {"stability", nullptr},
            {"sobolev", {{"lower", end(exponent.sobolev.lower)},
                         {"upper", end(exponent.sobolev.upper)},
                         {"lower_decimal", decimal(exponent.sobolev.lower, Rounding::down)},
                         {"upper_decimal", decimal(exponent.sobolev.upper, Rounding::up)}}},
            {"reason", exponent.reason},
            {"certificate", report.certificate}};
  if (exponent.stability)
    json["stability"] = *exponent.stability == Stability::interpolatory ? "interpolatory" : "linear-independence";
  if (exponent.order > 0) {
    json["radius"] = {{"lower", to_string(exponent.radius.lower)},
                      {"upper", to_string(exponent.radius.upper)},
                      {"lower_decimal", to_decimal(exponent.radius.lower, digits, Rounding::down)},
                      {"upper_decimal", to_decimal(exponent.radius.upper, digits, Rounding::up)},
                      {"word", exponent.radius.word},
                      {"exact", algebraic_json(exponent.radius.exact)}};
  }
  return text(json);
}

std::string outputs_json(const std::vector<OutputFile>& outputs) {
  Json list = Json::array();
  for (const OutputFile& output : outputs) list.push_back({{"file", output.file}, {"kind", output.kind}});
  return text({{"outputs", list}});
}

}  // namespace limes::app
