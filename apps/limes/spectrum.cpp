#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "analysis/surface/spectrum_settings.hpp"
#include "reports/tables/table_command.hpp"
#include "reports/text_table.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>

#include <charconv>
#include <iostream>

namespace limes::app {
namespace {

constexpr int largest_valence = 1000, largest_level = 200;

/// "5" or "3..20".
std::pair<int, int> read_range(const std::string& option, const std::string& text, int lower, int upper) {
  int first = 0, last = 0;
  const char* end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, first);
  last = first;
  if (read.ec == std::errc() && std::string_view(read.ptr, std::size_t(end - read.ptr)).starts_with("..")) read = std::from_chars(read.ptr + 2, end, last);
  if (read.ec != std::errc() || read.ptr != end || first < lower || last > upper || first > last)
    throw InputError(fmt::format("{} {}: expected N or N..M from {} to {}", option, text, lower, upper));
  return {first, last};
}

std::string number(const Interval& x) { return to_string(ComputedValue{x, {}}); }

void print(const VertexSpectrumReport& report) {
  std::string place = report.level ? fmt::format("level {}, ", *report.level) : "";
  std::cout << fmt::format("{}, valence {}: {}mu = {}, {} eigenvalues on {} ring{}\n", report.scheme, report.valence, place, number(report.mu),
                           report.size, report.rings, report.rings == 1 ? "" : "s");
  TextTable table({{"eigenvalue", 32}, {"modulus", 16}, {"times", 5, TextTable::Align::right}, {"Fourier index", 14}, {"root of", 0}});
  std::cout << table.header();
  for (const VertexEigenvalue& e : report.eigenvalues) {
    const bool is_real = e.im.is_point() && e.im.lower == 0;
    const std::string value = is_real ? number(e.re) : fmt::format("{} {} {} i", number(e.re), e.im.lower < 0 ? "-" : "+",
                                                                   number(e.im.lower < 0 ? Interval{-e.im.upper, -e.im.lower} : e.im));
    const std::string index = e.fourier == 0 || 2 * e.fourier == report.valence ? std::to_string(e.fourier) : fmt::format("{}, {}", e.fourier, report.valence - e.fourier);
    const std::string factor = e.factor.size() > 60 ? "" : e.factor;
    std::cout << table.row({e.is_cluster ? value + " (cluster)" : value, number(e.modulus), std::to_string(e.multiplicity), index, factor});
  }
}

}  // namespace

int run_spectrum(const SpectrumOptions& options) {
  const Session session(options);
  const Scheme scheme = load_scheme(options.scheme);
  const SpectrumSettings settings = spectrum_settings(scheme, options.parameters);
  const auto [first, last] = read_range("--valence", options.valence, 3, largest_valence);
  const bool one_level = settings.mu && scheme.surface->sequence.first_levels.empty();
  if (settings.mu && !options.level.empty() && *settings.mu != 1)
    throw InputError("--level belongs to an angle: at a given level parameter there are no levels");
  const auto [first_level, last_level] = options.level.empty() ? std::pair{0, 0} : read_range("--level", options.level, 0, largest_level);
  std::vector<VertexSpectrumReport> reports;
  std::optional<VertexSpectrum> spectrum;
  int status = all_as_expected;
  try {
    for (int level = first_level; level <= last_level; ++level) {
      // The first levels may have rules of their own.
      const int special = int(scheme.surface->sequence.first_levels.size());
      if (!spectrum || level <= special) {
        const bool limit = settings.mu && options.level.empty();
        spectrum.emplace(limit ? scheme.surface->rings : scheme.surface->rings_at_level(level), options.rings);
      }
      const LevelParameter mu = settings.at_level(level);
      for (int n = first; n <= last; ++n) {
        VertexSpectrumReport report{scheme.name, n, {}, mu.exact ? Interval::point(*mu.exact) : mu.enclosure(72), spectrum->rings(), spectrum->size(n), {}};
        if (!(one_level && options.level.empty())) report.level = level;
        report.eigenvalues = spectrum->eigenvalues(n, mu, 64, session.stop());
        if (!options.json && !reports.empty()) std::cout << "\n";
        if (!options.json) print(report);
        reports.push_back(std::move(report));
      }
    }
  } catch (const DomainError& error) {
    throw InputError(fmt::format("{}: {}", scheme.name, error.what()));
  } catch (const Interrupted&) {
    status = undecided_or_interrupted;
    if (!options.json) std::cerr << "limes: interrupted\n";
  }
  if (options.json) std::cout << spectrum_json(reports, status == undecided_or_interrupted);
  return status;
}

}  // namespace limes::app
