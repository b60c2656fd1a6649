// Three levels of the CDF 9/7 wavelet on a 4096 x 4096 grid, and back: what bench/peers/pyramid_pywavelets does with
// PyWavelets. Every benchmark checks its result before it measures.
#include "geometry/pyramid.hpp"
#include "schemes/unity/filter_file.hpp"
#include "schemes/unity/multiresolution.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>

namespace limes {
namespace {

constexpr std::size_t size = 4096;
constexpr int levels = 3;

/// An image that the peer makes by the same formula.
Grid picture() {
  Grid grid{size, size, 1, {}};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < size; ++k)
      grid.values.push_back(static_cast<double>((i * 73 + k * 151 + i * k / 97 % 1013 * 17) % 256));
  }
  return grid;
}

FilterBank filters(const std::string& name) {
  if (name == "cdf-9-7") return read_filter_file(LIMES_SOURCE_DIR "/examples/multiresolution/cdf-9-7.json");
  MultiresolutionOptions options;
  options.extension = 32;
  return find_multiresolution({Rational(-1) / 16, 0, Rational(9) / 16, 1, Rational(9) / 16, 0, Rational(-1) / 16},
                              options)
      .bank;
}

double squares(const Grid& grid) {
  double sum = 0;
  for (const double x : grid.values) sum += x * x;
  return sum;
}

void pyramid(benchmark::State& state, const std::string& name, Boundary boundary, bool back) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(0)));
  const PyramidTransform transform(filters(name), boundary);
  const Grid data = picture();
  const Pyramid whole = transform.decompose(data, levels);
  if (difference(transform.reconstruct(whole, levels).grid, data, 255).maximum > 1e-9)
    return state.SkipWithError("a wrong result");
  for (auto _ : state) {
    state.PauseTiming();
    Grid input = back ? Grid{} : data;
    Pyramid decomposed = back ? whole : Pyramid{};
    state.ResumeTiming();
    if (back)
      benchmark::DoNotOptimize(transform.reconstruct(std::move(decomposed), levels));
    else
      benchmark::DoNotOptimize(transform.decompose(std::move(input), levels));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(size * size) * state.iterations());
  // The peer compares: sum of squares of the coarse grid, of everything.
  state.SetLabel(fmt::format("{:.17g} {:.17g}", squares(coarse_grid(whole)), squares(whole.grid)));
}

void add(const std::string& name, Boundary boundary, const std::string& ends) {
  for (const bool back : {false, true}) {
    benchmark::RegisterBenchmark(fmt::format("{}/{}/{}", back ? "reconstruct" : "decompose", name, ends).c_str(),
                                 [=](benchmark::State& state) { pyramid(state, name, boundary, back); })
        ->Arg(1)
        ->Arg(2)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  }
}

const bool added = [] {
  add("cdf-9-7", Boundary::periodic, "periodic");
  add("cdf-9-7", Boundary::half_sample, "half-sample");
  add("four-point-extended", Boundary::half_sample, "half-sample");
  return true;
}();

}  // namespace
}  // namespace limes

BENCHMARK_MAIN();
