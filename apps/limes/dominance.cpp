#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "reports/text_table.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

std::vector<Scheme> load_schemes(const DominanceOptions& options) {
  std::vector<Scheme> schemes;
  for (const std::string& name : options.schemes.empty() ? Catalogue::find().names() : options.schemes) {
    Scheme scheme = load_scheme(name);
    if (scheme.insertion_rule) {
      schemes.push_back(std::move(scheme));
    } else if (!options.schemes.empty()) {
      throw InputError(fmt::format("{} is a {} scheme; root dominance belongs to a non-uniform one", scheme.name, to_string(scheme.kind)));
    }
  }
  return schemes;
}

/// The file's claims "C^m" that are expected to be true, or the one that is asked for.
std::vector<Claim> claims_of(const Scheme& scheme, const DominanceOptions& options) {
  std::vector<Claim> claims;
  if (options.claim) {
    claims.push_back(read_statement(*options.claim));
    if (claims.back().negated || !is_about_smoothness(claims.back())) throw InputError("--claim: root dominance belongs to C<m> alone");
    claims.back().region = region_from_settings(scheme, options.parameters);
    return claims;
  }
  for (const Claim& claim : scheme.claims) {
    if (!claim.negated && is_about_smoothness(claim) && claim.expected == Outcome::certified) claims.push_back(claim);
  }
  return claims;
}

DominanceReport report_on(const Scheme& scheme, const Claim& claim, const DominanceOptions& options, const Stop& stop) {
  DominanceReport report{.scheme = scheme.name, .claim = claim, .region = region_text(scheme, claim.region), .names = scheme.parameter_names(),
                         .reason = "", .factors = {}};
  report.names.emplace_back("gamma");
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*scheme.insertion_rule, claim.region));
  const SplitCharacteristicPolynomial split = split_characteristic_polynomial(matrix, claim.smoothness, stop);
  if (split.missing_eigenvalue) {
    report.reason = fmt::format("2^-{} is no eigenvalue", *split.missing_eigenvalue);
  } else {
    report.factors = compare_dominance_methods(split, claim.region, options.boxes, stop);
  }
  return report;
}

std::string point_text(const std::vector<Rational>& point, const VariableNames& names, const Box& region) {
  std::string text;
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (k < region.size() && region[k].is_point()) continue;
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", names[k], to_string(point[k]));
  }
  return text;
}

std::string cell(const MethodResult& result, const DominanceReport& report) {
  if (result.proved) return result.leaves == 1 ? "1 box" : fmt::format("{} boxes", result.leaves);
  if (result.counterexample) return "false at " + point_text(*result.counterexample, report.names, report.claim.region);
  if (result.hopeless_point) return "never: " + point_text(*result.hopeless_point, report.names, report.claim.region);
  return "not yet";
}

/// A short factor as a whole, a long one by its degrees.
std::string factor_text(const FactorComparison& comparison, const VariableNames& names) {
  std::string text = to_string(comparison.factor.polynomial, names);
  if (text.size() > 40) {
    text = fmt::format("degree {} in lambda", comparison.factor.polynomial.degree());
    const std::vector<int> degrees = comparison.factor.polynomial.degrees();
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (degrees[k] > 0) text += fmt::format(", {} in {}", degrees[k], names[k]);
    }
  }
  return fmt::format("{}: {}{}", comparison.in_ell ? "ell" : "r", text, comparison.is_mirrored ? " (gamma >= 1)" : "");
}

void print_text(const DominanceReport& report) {
  std::cout << fmt::format("{} {}, {}\n", report.scheme, statement(report.claim), report.region);
  if (!report.reason.empty()) std::cout << "  " << report.reason << "\n\n";
  if (report.factors.empty()) return;
  std::vector<std::vector<std::string>> rows;
  for (const FactorComparison& comparison : report.factors) {
    std::vector<std::string>& row = rows.emplace_back(std::vector<std::string>{factor_text(comparison, report.names)});
    for (const MethodResult& result : comparison.methods) row.push_back(cell(result, report));
  }
  TextTable table({{"  factor"}, {"rouche"}, {"circle"}, {"boundary"}, {"separation"}});
  for (std::vector<std::string>& row : rows) {
    row.front() = "  " + row.front();
    for (std::size_t k = 0; k < row.size(); ++k) table.fit(k, row[k]);
  }
  std::cout << table.header();
  for (const std::vector<std::string>& row : rows) std::cout << table.row(row);
  std::cout << "\n";
}

}  // namespace

int run_dominance(const DominanceOptions& options) {
  const Session session(options);
  std::vector<DominanceReport> reports;
  int status = all_as_expected;
  Progress progress(!options.quiet);
  try {
    for (const Scheme& scheme : load_schemes(options)) {
      for (const Claim& claim : claims_of(scheme, options)) {
        progress.show(fmt::format("{} {}", scheme.name, statement(claim)));
        reports.push_back(report_on(scheme, claim, options, session.stop()));
        progress.clear();
        if (!options.json) print_text(reports.back());
        for (const FactorComparison& comparison : reports.back().factors) {
          const auto proves = [](const MethodResult& result) { return result.proved; };
          if (std::none_of(comparison.methods.begin(), comparison.methods.end(), proves)) status = undecided_or_interrupted;
        }
        if (!reports.back().reason.empty()) status = undecided_or_interrupted;
      }
    }
  } catch (const Interrupted& interrupted) {
    std::cerr << "limes: " << interrupted.what() << "\n";
    status = undecided_or_interrupted;
  }
  if (options.json) std::cout << dominance_json(reports);
  return status;
}

}  // namespace limes::app
