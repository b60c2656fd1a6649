#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/outputs.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "proofs/map/map_journal.hpp"
#include "proofs/map/map_unions.hpp"
#include "reports/plot/map_plot.hpp"
#include "reports/text_table.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

namespace fs = std::filesystem;

Rational tolerance_from(const std::string& text, const Box& region) {
  if (text.empty()) {
    const Rational whole = measure(region);
    return whole > 0 ? whole / 1000 : Rational(1);  // a point is refused later
  }
  try {
    const Rational tolerance = read_rational(text);
    if (tolerance > 0) return tolerance;
  } catch (const InputError& error) {
    throw InputError(fmt::format("--tolerance {}: {}", text, error.reason()));
  }
  throw InputError(fmt::format("--tolerance {}: it must be positive", text));
}

/// Writes the certificates of all parts and removes those of an earlier run.
std::vector<std::vector<std::string>> write_certificates(const fs::path& directory, const std::string& stem,
                                                         const std::vector<MapUnion>& unions) {
  make_directory(directory);
  std::error_code error;
  for (int number = 1; fs::remove(directory / fmt::format("{}.{}.json", stem, number), error); ++number) {
  }
  int number = 0;
  std::vector<std::vector<std::string>> files;
  for (const MapUnion& one : unions) {
    files.emplace_back();
    for (const MapCell& part : one.parts) {
      const fs::path file = directory / fmt::format("{}.{}.json", stem, ++number);
      write_file(file, part.certificate);
      files.back().push_back(file.string());
    }
  }
  return files;
}

void print_map(const MapReport& report, const Rational& tolerance, bool quiet) {
  TextTable table({{"verdict"}, {"region"}, {"certificates"}});
  const auto files_text = [&](std::size_t k) { return fmt::format("{}", fmt::join(report.files[k], " ")); };
  for (const MapUnion& one : report.unions) {
    table.fit(0, to_string(one.verdict));
    table.fit(1, region_text(report.scheme, one.region));
  }
  if (!quiet) std::cout << table.header();
  for (std::size_t k = 0; k < report.unions.size(); ++k) {
    const MapUnion& one = report.unions[k];
    std::cout << table.row({to_string(one.verdict), region_text(report.scheme, one.region), files_text(k)});
  }
  if (quiet) return;
  std::cout << fmt::format("\n{} for {}: {} cells, unknown measure {} ({} the tolerance {})\n", statement(report.claim),
                           report.scheme.name, report.map.cells.size(),
                           report.map.unknown_measure == 0 ? "0" : to_decimal(report.map.unknown_measure, 4, Rounding::up),
                           report.map.unknown_measure <= tolerance ? "within" : "above", to_string(tolerance));
}

}  // namespace

int run_map(const MapVerbOptions& options) {
  const Session session(options);
  const std::vector<OutputFile> outputs = outputs_by_ending(options.outputs, {"svg", "pgf", "png"});
  const Scheme scheme = load_scheme(options.scheme);
  require_one_mask(scheme, "map");
  Claim claim = read_statement(options.claim);
  if (claim.negated) throw InputError("--claim: a map is made of C<m>; it shows where that is refuted, too");
  if (!is_about_smoothness(claim)) throw InputError(fmt::format("--claim '{}': a map is made of C<m> of the scheme itself", statement(claim)));
  claim.region = region_from_settings(scheme, options.parameters);
  MapOptions search{.tolerance = tolerance_from(options.tolerance, claim.region)};

  std::optional<MapJournal> journal;
  MapObserver observer;
  Progress progress(!options.quiet);
  if (!options.journal.empty()) {
    journal.emplace(options.journal, scheme, claim.smoothness, claim.region, search);
    observer.find = [&](const Box& cell) { return journal->find(cell); };
    observer.record = [&](const MapRecord& record) { journal->append(record); };
  }
  observer.progress = [&](const MapProgress& now) {
    progress.show(fmt::format("{} cells, unknown measure {:.3g}", now.cells, approx_double(now.unknown_measure)));
  };
  const ParameterMap map = map_parameters(scheme, claim.smoothness, claim.region, search, observer, session.stop());
  progress.clear();

  const std::vector<MapUnion> unions = map_unions(map.cells, scheme.parameter_names());
  const std::string stem = fmt::format("{}.map.{}", scheme.name, statement(claim));
  const MapReport report{scheme, claim, map, unions, write_certificates(options.certificates, stem, unions)};
  for (const OutputFile& output : outputs) {
    const Plot plot = map_plot(unions, claim.region, scheme.parameter_names(), fmt::format("{}: {}", scheme.name, statement(claim)));
    write_file(output.file, picture(output.kind, plot));
  }
  if (options.json) {
    std::cout << map_json(report);
  } else {
    print_map(report, search.tolerance, options.quiet);
  }
  return map.complete ? all_as_expected : undecided_or_interrupted;
}

}  // namespace limes::app
