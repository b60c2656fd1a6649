// What the proofs about uniform schemes cost: exact norms of iterated difference schemes, whole proofs, their re-check, and
// the characteristic polynomial of a word of difference sections. Every benchmark checks its result before it measures.
#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/expanding_word.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/prove.hpp"
#include "schemes/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <fstream>

namespace limes {
namespace {

Scheme load(const std::string& name) { return Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name); }

// ---- ||S_b^l|| -----------------------------------------------------------------------------------------------------------

/// The most memory that the process held while `work` ran, in MiB; nothing where the kernel does not tell (Linux only).
template <class Work>
std::optional<double> peak_mebibytes(Work work) {
  if (!(std::ofstream("/proc/self/clear_refs") << 5 << std::flush)) return std::nullopt;
  work();
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;) {
    double kibibytes = 0;
    if (key == "VmHWM:" && status >> kibibytes) return kibibytes / 1024;
  }
  return std::nullopt;
}

/// The definition: a product of dilated Laurent polynomials, and sums over residues.
Rational norm_by_definition(const LaurentPolynomial& b, int level) {
  LaurentPolynomial iterated = b;
  for (int l = 1; l < level; ++l) iterated = iterated * b.dilated(1 << l);
  std::vector<Rational> rows(std::size_t(1) << level);
  const std::vector<Rational> coefficients = iterated.rational_coefficients();
  for (std::size_t i = 0; i < coefficients.size(); ++i) rows[i % rows.size()] += abs(coefficients[i]);
  return *std::max_element(rows.begin(), rows.end());
}

/// The six-point scheme at w, a = (1 + z)^{m+1} 2^{-m} b: ||S_b^l|| for the level l of the benchmark. The label is the exact
/// norm, which bench/peers compares with what the peers compute.
void norm(benchmark::State& state, const char* w, int m) {
  const int level = static_cast<int>(state.range(0));
  const LaurentPolynomial b = difference_symbol(load("six-point").mask, m + 1)->at(std::vector<Rational>{read_rational(w)});
  if (exact_contractivity_norm(b, 2, 5) != norm_by_definition(b, 5)) return state.SkipWithError("a wrong norm");
  Rational result;
  const auto run = [&] { result = exact_contractivity_norm(b, 2, level); };
  const std::optional<double> peak = peak_mebibytes(run);
  for (auto _ : state) run();
  state.SetComplexityN(std::int64_t(1) << level);
  state.SetLabel(to_string(result));
  if (peak) state.counters["peak_MiB"] = *peak;
}

#define LIMES_NORM(name, w, m) \
  BENCHMARK_CAPTURE(norm, name, w, m)->DenseRange(8, 16)->Complexity(benchmark::oN)->Unit(benchmark::kMillisecond)
LIMES_NORM(six_point_c2, "1/96", 2);
LIMES_NORM(six_point_c3, "141/10000", 3);
#undef LIMES_NORM

// ---- proofs and their re-check -------------------------------------------------------------------------------------------

Verdict verdict_of(const Scheme& scheme, const std::string& claimed, const std::string& w) {
  Claim claim = read_statement(claimed);
  claim.region = {read_interval(w)};
  return prove(scheme, claim);
}

void proof(benchmark::State& state, const char* scheme_name, const char* claim, const char* w) {
  const Scheme scheme = load(scheme_name);
  const Verdict first = verdict_of(scheme, claim, w);
  if (first.outcome != Outcome::certified) return state.SkipWithError(first.reason.c_str());
  for (auto _ : state) benchmark::DoNotOptimize(verdict_of(scheme, claim, w));
  state.counters["leaves"] = first.leaf_count();
  state.counters["level"] = first.level();
}

void check(benchmark::State& state, const char* scheme_name, const char* claim, const char* w) {
  const std::string certificate = verdict_of(load(scheme_name), claim, w).certificate_json;
  if (const checker::Result result = checker::check(certificate); !result.valid) return state.SkipWithError(result.reason.c_str());
  for (auto _ : state) benchmark::DoNotOptimize(checker::check(certificate));
  state.counters["certificate_bytes"] = static_cast<double>(certificate.size());
}

// The ranges of Table 1 of Karciauskas & Peters 2013, and the four-point range of Hechler, Moessner & Reif 2009.
#define LIMES_PROOF(name, ...)                                                   \
  BENCHMARK_CAPTURE(proof, name, __VA_ARGS__)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(check, name, __VA_ARGS__)->Unit(benchmark::kMillisecond)
LIMES_PROOF(four_point_c1, "four-point", "C1", "[1/1000, 37/200]");
LIMES_PROOF(six_point_c2, "six-point", "C2", "(0, 21/500]");
LIMES_PROOF(eight_point_c3, "eight-point", "C3", "[1/625, 21/2500]");
LIMES_PROOF(ten_point_c4, "ten-point", "C4", "[1/2000, 1/625]");
#undef LIMES_PROOF

// ---- sections ------------------------------------------------------------------------------------------------------------

/// The characteristic polynomial over Q[w] of a word of length l of the difference sections (0 1 1 0 1 0 0 1 ...) of order m + 1.
void characteristic_polynomial_of_word(benchmark::State& state, const char* scheme_name, int m) {
  const FiniteSections sections(*difference_symbol(load(scheme_name).mask, m + 1), 2);
  std::vector<int> word;
  for (int k = 0; k < state.range(0); ++k) word.push_back(__builtin_parity(k));
  PolynomialMatrix product = PolynomialMatrix::identity(1, sections.size());
  for (const int letter : word) product = product * sections.numerators(letter);

  const std::vector<MultivariatePolynomial> chi = characteristic_polynomial(product);
  const std::vector<Rational> point{Rational(1) / 96};
  const Polynomial at_point = characteristic_polynomial(product.at(point));
  for (int k = 0; k <= sections.size(); ++k) {
    if (chi[k](point) != at_point.coefficient(k)) return state.SkipWithError("a wrong characteristic polynomial");
  }
  for (auto _ : state) benchmark::DoNotOptimize(characteristic_polynomial(product));
  state.counters["size"] = sections.size();
}

BENCHMARK_CAPTURE(characteristic_polynomial_of_word, six_point_c2, "six-point", 2)
    ->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(characteristic_polynomial_of_word, ten_point_c4, "ten-point", 4)
    ->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limes

BENCHMARK_MAIN();
