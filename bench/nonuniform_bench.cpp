// What the proofs about non-uniform schemes cost: from a scheme file to the split characteristic polynomial, root dominance on the
// boxes of Karciauskas & Peters 2013, and whole proofs with their re-check.
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/spectrum_screen.hpp"
#include "analysis/nonuniform/root_dominance.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "proofs/prove.hpp"
#include "schemes/catalogue.hpp"

#include <benchmark/benchmark.h>

namespace limes {
namespace {

Scheme load(const std::string& name) { return Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name); }

SplitCharacteristicPolynomial split(const Scheme& scheme, const Box& region, int m) {
  return split_characteristic_polynomial(SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*scheme.insertion_rule, region)), m);
}

/// From the file to chi = (lambda - 1) .. (lambda - 2^{-m}) ell r, in gamma and the parameters.
void characteristic_polynomial_from_file(benchmark::State& state, const char* name, int m) {
  for (auto _ : state) {
    const Scheme scheme = load(name);
    const SplitCharacteristicPolynomial result = split(scheme, scheme.parameter_box(), m);
    if (result.missing_eigenvalue || !result.is_symmetric()) return state.SkipWithError("a wrong characteristic polynomial");
    benchmark::DoNotOptimize(result);
  }
}

/// All factors of ell and r are dominated, the polynomial being there.
void dominance(benchmark::State& state, const char* name, int m, const char* w) {
  const Scheme scheme = load(name);
  Box box{read_interval(w)};
  const SplitCharacteristicPolynomial factors = split(scheme, box, m);
  box.push_back(read_interval("(0, 1]"));
  for (auto _ : state) {
    for (const auto* list : {&factors.ell, &factors.r}) {
      for (const CharacteristicFactor& factor : *list) {
        if (!prove_root_dominance(factor.polynomial, power(Rational(2), -m), box).proved) return state.SkipWithError("not dominated");
      }
    }
  }
}

/// limes verify for one claim: proof, certificate, re-check.
void proof(benchmark::State& state, const char* name, std::size_t claim) {
  const Scheme scheme = load(name);
  for (auto _ : state) {
    if (prove(scheme, scheme.claims[claim]).outcome != Outcome::certified) return state.SkipWithError("not certified");
  }
}

/// One look of limes search at a parameter value of the 10-point scheme.
void screen(benchmark::State& state) {
  const SpectrumScreen radii(*load("ten-point-nonuniform").insertion_rule, 4);
  const std::vector<double> w{0.001};
  for (auto _ : state) {
    for (const double radius : radii.approx_radii(w)) {
      if (!(radius < 1)) return state.SkipWithError("a radius of 1 or more");
    }
  }
}

BENCHMARK_CAPTURE(characteristic_polynomial_from_file, cu2_4, "cu2-4", 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(characteristic_polynomial_from_file, a2_5_3, "a2-5-3", 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(characteristic_polynomial_from_file, ten_point, "ten-point-nonuniform", 4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dominance, cu2_4, "cu2-4", 2, "1/288")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dominance, a2_5_3, "a2-5-3", 2, "[1/1000, 1/50]")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dominance, ten_point, "ten-point-nonuniform", 4, "[183/200000, 523/500000]")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proof, cr2, "cr2", 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proof, a2_5_3, "a2-5-3", 0)->Unit(benchmark::kMillisecond);
BENCHMARK(screen)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limes

BENCHMARK_MAIN();
