// What joint spectral radii, Hoelder exponents and parameter maps cost. Every benchmark checks its result before it measures; the
// counter peak_MiB is the most memory that the process held by then (Linux only).
#include "algebra/error.hpp"
#include "analysis/uniform/hoelder_exponent.hpp"
#include "proofs/map/parameter_map.hpp"
#include "proofs/spectral_radius/radius_certificate.hpp"
#include "schemes/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <fstream>

namespace limes {
namespace {

Scheme load(const std::string& name) { return Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name); }

void record_peak(benchmark::State& state) {
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;) {
    double kibibytes = 0;
    if (key == "VmHWM:" && status >> kibibytes) state.counters["peak_MiB"] = kibibytes / 1024;
  }
}

// ---- Pairs of matrices --------------------------------------------------------------------------------------------------------

RationalMatrix matrix(const std::vector<std::vector<Rational>>& rows) {
  RationalMatrix result(int(rows.size()), int(rows.front().size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) result(int(i), int(j)) = rows[i][j];
  }
  return result;
}

struct Example {
  const char* name;
  MatrixFamily family;
  /// What is known about the radius.
  Rational lower, upper;
};

/// (B_e)_ij = c_{e+2j-i} with c_0 = .. = c_{d-1} = 1: they count the partitions of integers into powers of 2, each less than d times.
MatrixFamily binary_partitions(int d) {
  MatrixFamily family(2, RationalMatrix(d - 1, d - 1));
  for (int e = 0; e < 2; ++e) {
    for (int i = 0; i < d - 1; ++i) {
      for (int j = 0; j < d - 1; ++j) family[std::size_t(e)](i, j) = e + 2 * j - i >= 0 && e + 2 * j - i < d ? 1 : 0;
    }
  }
  return family;
}

std::vector<Example> examples() {
  const Rational fifth(1, 5);
  return {{"golden ratio", {matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})}, Rational(161803, 100000), Rational(161804, 100000)},
          {"Gripenberg 1996", {matrix({{3 * fifth, 0}, {fifth, 3 * fifth}}), matrix({{3 * fifth, -3 * fifth}, {0, -fifth}})},
           Rational(6596789, 10000000), Rational(6596924, 10000000)},
          // The greatest root of x^3 - 4 x^2 + 2 x - 1.
          {"binary partitions, d = 7", binary_partitions(7), Rational(35115, 10000), Rational(35116, 10000)}};
}

void radius(benchmark::State& state) {
  const Example example = examples()[std::size_t(state.range(0))];
  SpectralRadiusBounds bounds;
  const auto run = [&] { bounds = bound_spectral_radius(example.family, {}, {}); };
  run();
  if (bounds.upper < example.lower || bounds.lower > example.upper || bounds.lower > bounds.upper) return state.SkipWithError("a wrong radius");
  for (auto _ : state) run();
  state.SetLabel(std::string(example.name) + (bounds.exact ? ", exact: " : ": ") + to_decimal(bounds.lower, 8, Rounding::down));
  record_peak(state);
}
BENCHMARK(radius)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

// ---- Hoelder exponents -------------------------------------------------------------------------------------------------------

/// To 6 digits; with 1 as the argument the certificate is made and checked, too.
void exponent(benchmark::State& state, const char* name, std::vector<Rational> point) {
  const Scheme scheme = load(name);
  HoelderExponent result;
  const auto run = [&] {
    result = bound_hoelder_exponent(at(scheme.mask, point), 6, {}, {});
    if (state.range(0) == 1) benchmark::DoNotOptimize(prove_hoelder_exponent(scheme, point, result));
  };
  run();
  if (!result.bounds.lower || !result.bounds.upper || *result.bounds.upper - *result.bounds.lower > power(Rational(1, 10), 6))
    return state.SkipWithError("a wide enclosure");
  for (auto _ : state) run();
  state.SetLabel(to_decimal(*result.bounds.lower, 8, Rounding::down));
  record_peak(state);
}
BENCHMARK_CAPTURE(exponent, four_point, "four-point", {Rational(1, 16)})->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exponent, deslauriers_dubuc_10, "deslauriers-dubuc-10", {})->DenseRange(0, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exponent, twelve_point, "twelve-point", {})->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

// ---- Maps --------------------------------------------------------------------------------------------------------------------

void map(benchmark::State& state, const char* name, int smoothness, Interval region, Rational tolerance) {
  const Scheme scheme = load(name);
  ParameterMap result;
  const auto run = [&] { result = map_parameters(scheme, smoothness, {region}, {.tolerance = tolerance}); };
  run();
  if (!result.complete) return state.SkipWithError("the map is not complete");
  for (auto _ : state) run();
  state.counters["cells"] = double(result.cells.size());
  record_peak(state);
}
BENCHMARK_CAPTURE(map, four_point_c1, "four-point", 1, Interval{0, Rational(1, 4), false, false}, Rational(1, 10000))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map, cr1_c1, "cr1", 1, Interval{0, Rational(1, 4), false, false}, Rational(1, 10000))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map, a3_5_c3, "a3-5", 3, Interval{0, Rational(1, 10), false, false}, Rational(1, 1000000))->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limes

BENCHMARK_MAIN();
