#include "apps/limes/json_output.hpp"

#include "analysis/nonstationary/space_moments.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/stability.hpp"
#include "proofs/number_json_impl.hpp"
#include "schemes/surface/ring_expression.hpp"

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
Json intervals_json(const Scheme& scheme, const Box& region) { return region_to_json(region, scheme.parameter_names()); }

Json claim_json(const Scheme& scheme, const Claim& claim) {
  Json json{{"claim", statement(claim)},
            {"smoothness", claim.space || claim.subject == ClaimSubject::vertex_spectrum ? Json(nullptr) : Json(claim.smoothness)},
            {"region", region_json(scheme, claim.region)},
            {"intervals", intervals_json(scheme, claim.region)},
            {"expected", to_string(claim.expected)},
            {"source", claim.source}};
  if (claim.valences) json["valence"] = to_string(*claim.valences);
  if (scheme.level_sequence()) json["type"] = to_string(claim.type);
  if (!claim.erratum.empty()) json["erratum"] = claim.erratum;
  return json;
}

Json claims_json(const Scheme& scheme) {
  Json claims = Json::array();
  for (const Claim& claim : scheme.claims) claims.push_back(claim_json(scheme, claim));
  return claims;
}

/// Decimals rounded outward.
Json enclosure_json(const Interval& x) { return {to_decimal(x.lower, 17, Rounding::down), to_decimal(x.upper, 17, Rounding::up)}; }

Json symbol_json(const LaurentPolynomial& symbol, const VariableNames& names) {
  Json coefficients = Json::array();
  for (const RationalFunction& c : symbol.coefficients()) coefficients.push_back(to_string(c, names));
  return {{"first_index", symbol.lowest()}, {"coefficients", coefficients}};
}

/// What a nonstationary scheme has beside its limit.
Json sequence_json(const MaskSequence& sequence) {
  const VariableNames names{sequence.level_parameter};
  Json types = Json::object(), spaces = Json::object(), first_levels = Json::array();
  for (const MaskSequence::Range& range : sequence.types) {
    const std::string type = to_string(range.type);
    types[type] = to_string(range.angles);
    Json failures = Json::array();
    for (const auto& [function, defect] : first_failures(sequence, range.type, false)) {
      failures.push_back({{"function", to_string(function)},
                          {"residue", defect.residue},
                          {"moment", defect.moment},
                          {"part", defect.part == MomentPart::even ? "even" : "odd"},
                          {"defect", to_string(defect.value, {"c"})}});
    }
    Json reproduced = Json::array(), generated = Json::array();
    for (const ExponentialFunction& f : reproduced_space(sequence, range.type, false)) reproduced.push_back(to_string(f));
    for (const ExponentialFunction& f : reproduced_space(sequence, range.type, true)) generated.push_back(to_string(f));
    spaces[type] = {{"reproduced", reproduced}, {"generated", generated}, {"not_reproduced", failures}};
  }
  for (const Mask& mask : sequence.first_levels) first_levels.push_back(symbol_json(mask.symbol, names));
  return {{"angle", sequence.angle},     {"level_parameter", sequence.level_parameter},
          {"types", types},              {"mask", symbol_json(sequence.mask.symbol, names)},
          {"first_levels", first_levels}, {"spaces", spaces}};
}

/// {"polynomial": [c_0, .., c_d], "value": in words}; null without one.
Json algebraic_json(const std::optional<AlgebraicNumber>& x) {
  if (!x) return nullptr;
  Json coefficients = Json::array();
  for (const Rational& c : x->polynomial.coefficients()) coefficients.push_back(to_string(c));
  return {{"polynomial", coefficients}, {"value", describe(*x)}};
}

}  // namespace

std::string list_json(const std::vector<Scheme>& schemes) {
  Json list = Json::array();
  for (const Scheme& scheme : schemes) {
    list.push_back({{"name", scheme.name},
                    {"title", scheme.title},
                    {"kind", to_string(scheme.kind)},
                    {"claims", claims_json(scheme)},
                    {"source", scheme.sources}});
  }
  return text({{"schemes", list}});
}

std::string show_json(const Scheme& scheme) {
  if (scheme.surface) {
    const RingRule& rings = scheme.surface->rings;
    Json rules = Json::object();
    for (const auto& [point, terms] : rings.given) rules[to_string(point)] = to_string(terms, scheme.surface->sequence.level_parameter);
    return text(Json{{"name", scheme.name},
                     {"title", scheme.title},
                     {"kind", to_string(scheme.kind)},
                     {"source", scheme.sources},
                     {"parameters", intervals_json(scheme, scheme.parameter_box())},
                     {"curve", scheme.surface->curve},
                     {"dual", rings.dual},
                     {"virtual_points", scheme.surface->virtual_points},
                     {"rules", rules},
                     {"claims", claims_json(scheme)}});
  }
  const Mask& mask = scheme.mask;
  const VariableNames names = scheme.parameter_names();
  const PolynomialDegrees degrees = polynomial_degrees(mask);
  const int order = sum_rule_order(mask);
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
            {"claims", claims_json(scheme)}};
  if (scheme.insertion_rule) {
    const InsertionRuleText& rule = scheme.insertion_rule->text();
    Json let = Json::array(), coefficients = Json::array();
    for (const auto& [name, value] : rule.let) let.push_back({{"name", name}, {"value", value.text}});
    for (const auto& line : rule.coefficients) coefficients.push_back(line.text);
    json["points"] = scheme.insertion_rule->points();
    json["let"] = let;
    json["coefficients"] = coefficients;
  }
  if (scheme.sequence) json["sequence"] = sequence_json(*scheme.sequence);
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

std::string map_json(const MapReport& report) {
  const auto ends = [](const Interval& interval) { return Json{to_string(interval.lower), to_string(interval.upper)}; };
  // With one parameter that varies its interval, otherwise the list of all that vary.
  const auto extent = [&](const Box& box) {
    Json json = Json::array();
    for (std::size_t k = 0; k < box.size(); ++k) {
      if (!report.claim.region[k].is_point()) json.push_back(ends(box[k]));
    }
    return json.size() == 1 ? json[0] : json;
  };
  Json cells = Json::array();
  for (const MapCell& cell : report.map.cells) {
    cells.push_back({{"region", region_json(report.scheme, cell.region)},
                     {"intervals", intervals_json(report.scheme, cell.region)},
                     {"verdict", to_string(cell.verdict)}});
  }
  Json sets = Json::object();
  for (const Outcome verdict : {Outcome::certified, Outcome::refuted, Outcome::undecided}) sets[to_string(verdict)] = Json::array();
  Json certificates = Json::array();
  for (std::size_t i = 0; i < report.unions.size(); ++i) {
    const MapUnion& one = report.unions[i];
    sets[to_string(one.verdict)].push_back(extent(one.region));
    for (std::size_t k = 0; k < one.parts.size(); ++k) {
      certificates.push_back({{"intervals", intervals_json(report.scheme, one.parts[k].region)},
                              {"verdict", to_string(one.verdict)},
                              {"certificate", report.files[i][k]}});
    }
  }
  Json json{{"scheme", report.scheme.name},
            {"claim", statement(report.claim)},
            {"region", region_json(report.scheme, report.claim.region)},
            {"cells", cells}};
  json.update(sets);
  json["certificates"] = certificates;
  json["unknown_measure"] = to_string(report.map.unknown_measure);
  json["unknown_decimal"] = to_decimal(report.map.unknown_measure, 6, Rounding::up);
  json["complete"] = report.map.complete;
  return text(json);
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
  Json eigenvalues = Json::array();
  for (const ComplexRoot& root : report.eigenvalues) {
    eigenvalues.push_back({{"re", enclosure_json(root.re)},
                           {"im", enclosure_json(root.im)},
                           {"modulus", enclosure_json(root.modulus)},
                           {"multiplicity", root.multiplicity}});
  }
  Json json{{"size", matrix.size()},
               {"matrix", rows},
               {"characteristic_polynomial", to_string(report.split.chi, report.names)},
               {"polynomial_eigenvalues", report.split.smoothness + 1},
               {"ell", factors(report.split.ell)},
               {"r", factors(report.split.r)},
               {"eigenvalues_split", !report.split.missing_eigenvalue.has_value()},
               {"symmetric", report.split.is_symmetric()}};
  if (!report.eigenvalues.empty()) json["eigenvalues"] = eigenvalues;
  return text(json);
}

std::string spectrum_json(const std::vector<VertexSpectrumReport>& reports, bool interrupted) {
  Json results = Json::array();
  const auto ends = [](const Interval& x) { return Json{to_string(x.lower), to_string(x.upper)}; };
  for (const VertexSpectrumReport& report : reports) {
    Json eigenvalues = Json::array();
    for (const VertexEigenvalue& e : report.eigenvalues) {
      eigenvalues.push_back({{"re", ends(e.re)},
                             {"im", ends(e.im)},
                             {"modulus", ends(e.modulus)},
                             {"re_decimal", enclosure_json(e.re)},
                             {"im_decimal", enclosure_json(e.im)},
                             {"modulus_decimal", enclosure_json(e.modulus)},
                             {"exact", e.re.is_point() && e.im == Interval::point(0) ? Json(to_string(e.re.lower)) : Json(nullptr)},
                             {"multiplicity", e.multiplicity},
                             {"fourier", e.fourier},
                             {"cluster", e.is_cluster},
                             {"factor", e.factor}});
    }
    results.push_back({{"scheme", report.scheme},
                       {"valence", report.valence},
                       {"level", report.level ? Json(*report.level) : Json(nullptr)},
                       {"and_later", report.and_later},
                       {"mu", ends(report.mu)},
                       {"mu_decimal", enclosure_json(report.mu)},
                       {"rings", report.rings},
                       {"size", report.size},
                       {"eigenvalues", eigenvalues}});
  }
  return text({{"results", results}, {"complete", !interrupted}});
}

std::string dominance_json(const std::vector<DominanceReport>& reports) {
  Json results = Json::array();
  for (const DominanceReport& report : reports) {
    const auto point = [&](const std::vector<Rational>& values) {
      Json json = Json::object();
      for (std::size_t k = 0; k < values.size(); ++k) json[report.names[k]] = to_string(values[k]);
      return json;
    };
    Json factors = Json::array();
    for (const FactorComparison& comparison : report.factors) {
      Json tests = Json::array();
      for (const MethodResult& result : comparison.methods) {
        Json test{{"test", to_string(result.method)}, {"proved", result.proved}, {"boxes", result.leaves}};
        if (result.hopeless_point) test["fails_at"] = point(*result.hopeless_point);
        if (result.counterexample) test["counterexample"] = point(*result.counterexample);
        tests.push_back(std::move(test));
      }
      factors.push_back({{"factor", to_string(comparison.factor.polynomial, report.names)},
                         {"part", comparison.in_ell ? "ell" : "r"},
                         {"multiplicity", comparison.factor.multiplicity},
                         {"degree", comparison.factor.polynomial.degree()},
                         {"mirrored", comparison.is_mirrored},
                         {"tests", tests}});
    }
    Json result{{"scheme", report.scheme}, {"claim", statement(report.claim)}, {"region", report.region}, {"factors", factors}};
    if (!report.reason.empty()) result["reason"] = report.reason;
    results.push_back(std::move(result));
  }
  return text({{"results", results}});
}

std::string derive_json(const DeriveReport& report) {
  const DerivedMask& derived = report.derived;
  const RefinementEquation& equation = derived.equation;
  Json json{{"weight", report.weight},
            {"mask", numbers_to_json(derived.mask)},
            {"first_index", equation.first_index()},
            {"first_shift", to_string(equation.first_shift)},
            {"domain", {to_string(equation.domain.lower), to_string(equation.domain.upper)}},
            {"error", derived.error},
            {"least_error", derived.least_error},
            {"exact", derived.exact},
            {"even_sum", to_string(report.even_sum)},
            {"odd_sum", to_string(report.odd_sum)},
            {"alternating_sum", to_string(Rational(report.even_sum - report.odd_sum))},
            {"sum_rule_order", report.sum_rule_order},
            {"condition", derived.condition},
            {"rank", derived.rank},
            {"unknowns", derived.unknowns}};
  if (report.optimum) {
    json["optimum"] = {{"parameter", report.parameter},
                       {"value", to_string(report.optimum->parameter)},
                       {"local_minima", report.optimum->local_minima}};
  }
  if (report.rounded) json["rounded"] = {{"to", report.rounding}, {"mask", numbers_to_json(*report.rounded)}, {"error", report.rounded_error}};
  if (!report.costs.empty()) {
    json["costs"] = Json::array();
    for (const SmoothnessCost& cost : report.costs) {
      Json claims = Json::array();
      for (const Claim& claim : cost.claims) claims.push_back(statement(claim));
      Json row{{"sum_rules", cost.sum_rules}, {"error", cost.error}, {"claims", claims}};
      if (cost.exponent.lower) row["exponent"] = to_string(*cost.exponent.lower);
      if (cost.exponent.upper) row["exponent_upper"] = to_string(*cost.exponent.upper);
      json["costs"].push_back(row);
    }
  }
  return text(json);
}

std::string norm_json(const Rational& norm, int order, int level) {
  return text({{"norm", to_string(norm)},
               {"decimal", to_decimal(norm, 17, Rounding::up)},
               {"order", order},
               {"level", level}});
}

std::string tables_json(const std::vector<ComparedTable>& tables) {
  Json list = Json::array();
  for (const ComparedTable& table : tables) {
    Json rows = Json::array();
    for (const TableRow& row : table.rows) {
      rows.push_back({{"entry", row.entry},
                      {"published", row.published},
                      {"computed", row.computed},
                      {"digits", row.agreement.digits ? Json(*row.agreement.digits) : Json(nullptr)},
                      {"status", to_string(row.status)},
                      {"reason", row.reason}});
    }
    list.push_back({{"name", table.name}, {"title", table.title}, {"source", table.source}, {"rows", rows}, {"complete", !table.interrupted}});
  }
  return text({{"tables", list}});
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
