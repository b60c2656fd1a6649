#include "algebra/error.hpp"
#include "analysis/surface/spectrum_settings.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/catalogue.hpp"

namespace limes::table_impl {

ComputedResult spectrum_values(const TableCommand& command, const Stop& stop) {
  command.allow({"--param", "--valence", "--level", "--rings"});
  const Scheme scheme = load_scheme(command.operand());
  const SpectrumSettings settings = spectrum_settings(scheme, command.parameters());
  const int n = command.integer_option("--valence", 3, 1000);
  const int level = command.option("--level") ? command.integer_option("--level", 0, 200) : 0;
  const int rings = command.option("--rings") ? command.integer_option("--rings", 1, 8) : 0;
  const bool limit = settings.mu && !command.option("--level");
  const VertexSpectrum spectrum(limit ? scheme.surface->rings : scheme.surface->rings_at_level(level), rings);
  ComputedList modulus, re, im;
  for (const VertexEigenvalue& e : spectrum.eigenvalues(n, settings.at_level(level), 64, stop)) {
    for (int k = 0; k < e.multiplicity; ++k) {
      modulus.values.push_back({e.modulus, {}});
      re.values.push_back({e.re, {}});
      im.values.push_back({e.im, {}});
    }
  }
  return {{"modulus", modulus}, {"re", re}, {"im", im}, {"size", {0, {ComputedValue::count(spectrum.size(n))}}}};
}

}  // namespace limes::table_impl
