#include "algebra/error.hpp"
#include "analysis/surface/spectrum_settings.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/catalogue.hpp"

#include <algorithm>

namespace limes::table_impl {
namespace {

/// Enclosures of the moduli, each as often as its multiplicity, by falling size: the k-th greatest lies between the k-th greatest lower and the
/// k-th greatest upper end.
std::vector<Interval> moduli(const std::vector<VertexEigenvalue>& eigenvalues) {
  std::vector<Rational> lower, upper;
  for (const VertexEigenvalue& e : eigenvalues) {
    lower.insert(lower.end(), std::size_t(e.multiplicity), e.modulus.lower);
    upper.insert(upper.end(), std::size_t(e.multiplicity), e.modulus.upper);
  }
  std::sort(lower.rbegin(), lower.rend());
  std::sort(upper.rbegin(), upper.rend());
  std::vector<Interval> result;
  for (std::size_t k = 0; k < lower.size(); ++k) result.push_back({lower[k], upper[k]});
  return result;
}

}  // namespace

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
  if (and_later && level < int(scheme.surface->sequence.first_levels.size())) throw InputError("the first levels are of their own: --level K.. begins later");
  const bool limit = settings.mu && !command.option("--level");
  const VertexSpectrum spectrum(limit ? scheme.surface->rings : scheme.surface->rings_at_level(level), rings);
  const std::vector<VertexEigenvalue> eigenvalues = spectrum.eigenvalues(n, settings.at_level(level), 64, stop);
  std::vector<Interval> sizes = moduli(eigenvalues);
  if (and_later) {
    // A few levels one by one, the rest at once: the later, the narrower is the enclosure of what is left.
    constexpr int single_levels = 8;
    for (int k = 1; k <= single_levels; ++k) {
      const LevelParameter mu = k < single_levels ? settings.at_level(level + k) : settings.from_level(level + k);
      const std::vector<Interval> others = moduli(spectrum.eigenvalues(n, mu, 64, stop));
      for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = {std::min(sizes[i].lower, others[i].lower), std::max(sizes[i].upper, others[i].upper)};
    }
  }
  ComputedList modulus, re, im;
  for (Interval& x : sizes) modulus.values.push_back({std::move(x), {}});
  ComputedResult result{{"modulus", modulus}, {"size", {0, {ComputedValue::count(spectrum.size(n))}}}};
  if (and_later) return result;
  for (const VertexEigenvalue& e : eigenvalues) {
    re.values.insert(re.values.end(), std::size_t(e.multiplicity), ComputedValue{e.re, {}});
    im.values.insert(im.values.end(), std::size_t(e.multiplicity), ComputedValue{e.im, {}});
  }
  result.emplace_back("re", re);
  result.emplace_back("im", im);
  return result;
}

}  // namespace limes::table_impl
