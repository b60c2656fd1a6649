// Nonstationary schemes: refinement of a circle, and proofs for whole intervals of angles.

#include "algebra/number/elementary.hpp"
#include "geometry/refine_polygon.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/prove.hpp"
#include "schemes/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace limes {
namespace {

Scheme load(const char* name) { return Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name); }

/// A regular heptagon to its circle; the argument is the number of levels.
void refine_circle(benchmark::State& state, const char* name) {
  const int levels = static_cast<int>(state.range(0));
  std::vector<double> corners;
  const double angle = 2 * approx_double(pi_enclosure().lower) / 7;
  for (int k = 0; k < 7; ++k) corners.insert(corners.end(), {std::cos(angle * k), std::sin(angle * k)});
  const Polygon heptagon(2, corners, true);
  const NonstationaryRule rule =
      approx_nonstationary_rule(*load(name).sequence, AngleType::trigonometric, pi_enclosure().lower * 2 / 7, levels);
  const Polygon circle = refine_polygon(heptagon, rule, {levels});
  for (std::size_t i = 0; i < circle.size(); ++i) {
    if (std::abs(std::hypot(circle[i][0], circle[i][1]) - 1) > 1e-13) return state.SkipWithError("not on the circle");
  }
  for (auto _ : state) benchmark::DoNotOptimize(refine_polygon(heptagon, rule, {levels}));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(circle.size()));
}

BENCHMARK_CAPTURE(refine_circle, unified_curve, "unified-curve")->Arg(10)->Arg(18)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(refine_circle, six_point, "six-point-nonstationary")->Arg(10)->Arg(18)->Unit(benchmark::kMillisecond);

/// The file's first claim, with its re-check, or the re-check alone.
void proof(benchmark::State& state, const char* name, bool check_only) {
  const Scheme scheme = load(name);
  const Verdict verdict = prove(scheme, scheme.claims.front());
  if (verdict.outcome != Outcome::certified) return state.SkipWithError("not certified");
  for (auto _ : state) {
    if (check_only) {
      benchmark::DoNotOptimize(checker::check(verdict.certificate_json));
    } else {
      benchmark::DoNotOptimize(prove(scheme, scheme.claims.front()));
    }
  }
}

BENCHMARK_CAPTURE(proof, unified_curve_c1, "unified-curve", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proof, unified_curve_c1_check, "unified-curve", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proof, six_point_c2, "six-point-nonstationary", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(proof, six_point_c2_check, "six-point-nonstationary", true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limes

BENCHMARK_MAIN();
