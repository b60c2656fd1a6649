#include "algebra/error.hpp"
#include "analysis/surface/spectrum_settings.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/catalogue.hpp"

#include <algorithm>

namespace limes::table_impl {

ComputedResult spectrum_values(const TableCommand& command, const Stop& stop) {
  command.allow({"--param", "--valence", "--level", "--rings"});
  const Scheme scheme = load_scheme(command.operand());
  const SpectrumSettings settings = spectrum_settings(scheme, command.parameters());
  const int n = command.integer_option("--valence", 3, 1000);
  // "4..": level 4 and all later ones.
  TableCommand plain = command;
  const std::string level_text = command.option("--level").value_or("0");
  const bool and_later = level_text.ends_with("..");
  plain.options["--level"] = {and_later ? level_text.substr(0, level_text.size() - 2) : level_text};
  const int level = plain.integer_option("--level", 0, 200);
  const int rings = command.option("--rings") ? command.integer_option("--rings", 1, 8) : 0;
  const bool limit = settings.mu && !command.option("--level");
  const VertexSpectrum spectrum(limit ? scheme.surface->rings : scheme.surface->rings_at_level(level), rings);
  ComputedList modulus, re, im;
  std::vector<Rational> lower, upper;
  for (const VertexEigenvalue& e : spectrum.eigenvalues(n, and_later ? settings.from_level(level) : settings.at_level(level), 64, stop)) {
    for (int k = 0; k < e.multiplicity; ++k) {
      lower.push_back(e.modulus.lower);
      upper.push_back(e.modulus.upper);
      re.values.push_back({e.re, {}});
      im.values.push_back({e.im, {}});
    }
  }
  // The k-th greatest modulus lies between the k-th greatest lower and the k-th greatest upper end.
  std::sort(lower.rbegin(), lower.rend());
  std::sort(upper.rbegin(), upper.rend());
  for (std::size_t k = 0; k < lower.size(); ++k) modulus.values.push_back({Interval{lower[k], upper[k]}, {}});
  if (and_later) return {{"modulus", modulus}, {"size", {0, {ComputedValue::count(spectrum.size(n))}}}};
  return {{"modulus", modulus}, {"re", re}, {"im", im}, {"size", {0, {ComputedValue::count(spectrum.size(n))}}}};
}

}  // namespace limes::table_impl
