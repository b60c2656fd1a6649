// Theorem E1: separators and cells in floating point, proposed to the checker.

#include "algebra/error.hpp"
#include "analysis/nonstationary/level_range.hpp"
#include "analysis/surface/approx_moduli.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/surface/vertex_proof.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace limes {
namespace {

/// A number of few digits, at most (up: at least) x.
Rational rounded(double x, bool up, int digits = 6) {
  const double scale = std::pow(10.0, digits);
  return Rational(static_cast<long long>(up ? std::ceil(x * scale) : std::floor(x * scale))) / Rational(static_cast<long long>(scale));
}

/// A number of as few digits as possible between two.
Rational between(double low, double high) {
  for (int digits = 1; digits <= 15; ++digits) {
    const Rational x = rounded((low + high) / 2, false, digits);
    const double value = x.convert_to<double>();
    if (value > low + (high - low) / 4 && value < high - (high - low) / 4) return x;
  }
  return rounded((low + high) / 2, false, 15);
}

/// The blocks at mu = 1, in the valence.
struct Blocks {
  VertexBlock zero, first, generic;
  bool has_harmonic;

  Blocks(const RingRule& rule, int rings)
      : zero(harmonic_block(rule, rings, 0)), generic(generic_block(rule, rings)), has_harmonic(harmonics(rule).size() > 1) {
    first = has_harmonic ? harmonic_block(rule, rings, 1) : generic;
  }
  ApproxBlock zero_at(int n) const { return ApproxBlock(zero.at(1, n)); }
  ApproxBlock first_at(int n) const { return ApproxBlock(first.at(1, n)); }
  ApproxBlock generic_at(int n) const { return ApproxBlock(generic.at(1, n)); }
};

/// The second greatest modulus; 0 without one.
double second(const std::vector<double>& moduli) { return moduli.size() > 1 ? moduli[1] : 0; }

class SpectrumProver {
 public:
  SpectrumProver(const RingRule& rule, int rings, const Stop& stop)
      : blocks_(rule, rings), stop_(stop), depends_on_n_(depends(blocks_.generic) || depends(blocks_.first)) {}

  std::optional<std::string> failure() const { return failure_; }

  /// The separator for one valence.
  std::optional<Rational> separator(int n) {
    stop_.check();
    const ApproxBlock generic = blocks_.generic_at(n);
    const auto cosine = [&](int j) { return std::cos(2 * std::numbers::pi * j / n); };
    const std::vector<double> zero = blocks_.zero_at(n).moduli(1), first = blocks_.first_at(n).moduli(cosine(1));
    double others = second(zero);
    std::string where = "block 0";
    const auto note = [&](double modulus, int block) {
      if (modulus <= others) return;
      others = modulus;
      where = fmt::format("block {}", block);
    };
    note(second(first), 1);
    for (int j = 2; j <= n / 2; ++j) note(generic.moduli(cosine(j)).front(), j);
    if (first.front() > others * (1 + 1e-9) && first.front() < 1 - 1e-9) return between(others, first.front());
    failure_ = fmt::format("valence {}: block 1 has the eigenvalue {:.6f}, and {} one of modulus {:.6f}", n, first.front(), where, others);
    return std::nullopt;
  }

  /// Makes proposals for all n >= from until one is accepted. \returns whether one is
  bool for_all(int from, const std::function<bool(const AllValencesProof&)>& accepts) {
    if (depends_on_n_) {
      failure_ = "weights other than those of means and of the vertex depend on the valence";
      return false;
    }
    const ApproxBlock generic = blocks_.generic_at(from), first = blocks_.first_at(from);
    const double least = std::cos(2 * std::numbers::pi / from);
    AllValencesProof proof{.from = from, .start = rounded(least - std::min(0.05, (least + 1) / 4), false), .bound = 0, .touch = {}, .cells = {}};
    const double start = proof.start.convert_to<double>();
    const auto root = [&](double c) { return first.moduli(c).front(); };

    // The greatest modulus of the blocks that no cell knows, and the moduli of block 0.
    double others = 0, zero_second = 0, zero_third = 0, zero_least = 1;
    for (int k = 0; k <= 32; ++k) {
      const double end = blocks_.has_harmonic ? 1 : start;
      others = std::max(others, generic.moduli(-1 + (end + 1) * k / 32).front());
    }
    for (int k = 0; k <= 32; ++k) {
      const int n = k == 32 ? 1000000 : static_cast<int>(std::lround(from * 32.0 / (32 - k)));
      const std::vector<double> zero = blocks_.zero_at(n).moduli(1);
      zero_second = std::max(zero_second, second(zero));
      zero_least = std::min(zero_least, second(zero));
      if (zero.size() > 2) zero_third = std::max(zero_third, zero[2]);
    }
    const double lowest = root(least);
    const bool touches = zero_second > lowest;
    if (!touches) others = std::max(others, zero_second);
    if (others >= lowest || (touches && zero_third >= zero_least)) {
      failure_ = fmt::format("for all valences from {} on: block 1 has eigenvalues from {:.6f} on, and other blocks have one of modulus {:.6f}", from,
                             lowest, touches ? zero_third : others);
      return false;
    }
    for (int cells = 4; cells <= 256; cells *= 4) {
      proof.cells.clear();
      double worst = lowest;
      const double first_end = rounded(least, false).convert_to<double>() - 1e-6;
      double a = start;
      for (int k = 0; k <= cells; ++k) {
        const Rational to = k == cells ? Rational(1) : rounded(first_end + (1 - first_end) * k / cells, false);
        const double b = to.convert_to<double>(), low = std::min(root(a), root(b)), high = std::max(root(a), root(b));
        const double margin = 0.1 * (high - low) + 1e-6;
        const double rest = std::max(second(first.moduli(a)), second(first.moduli(b)));
        proof.cells.push_back({to, between(rest, low - margin), {rounded(low - margin, false, 8), rounded(high + margin, true, 8)}});
        if (k > 0) worst = std::min(worst, low - margin);
        a = b;
      }
      if (others >= worst) continue;
      proof.bound = between(others, worst);
      if (!touches) {
        if (accepts(proof)) return true;
        continue;
      }
      for (const double part : {0.5, 0.25, 0.1}) {
        const double gap = std::min(zero_least, worst) - zero_third;
        proof.touch = rounded(zero_third + part * gap, false);
        if (accepts(proof)) return true;
      }
    }
    return false;
  }

 private:
  static bool depends(const VertexBlock& block) {
    return std::any_of(block.entries.begin(), block.entries.end(), [](const LaurentPolynomial& entry) {
      return std::any_of(entry.coefficients().begin(), entry.coefficients().end(), [](const RationalFunction& c) {
        return c.numerator().degree(1) > 0 || c.denominator().degree(1) > 0;
      });
    });
  }

  Blocks blocks_;
  const Stop& stop_;
  bool depends_on_n_;
  std::optional<std::string> failure_;
};

}  // namespace

std::optional<std::string> vertex_rejection(const Scheme& scheme, const Claim& claim, const VertexProof& proof) {
  const Certificate certificate{.scheme = scheme.name,
                                .parameters = scheme.parameter_names(),
                                .definition = *scheme.surface,
                                .claim = claim,
                                .verdict = Outcome::certified,
                                .theorem = proof.map ? Theorem::e2 : Theorem::e1,
                                .proof = proof};
  const checker::Result result = checker::check(to_json(certificate));
  return result.valid ? std::nullopt : std::optional(result.reason);
}

VertexAttempt prove_vertex_claim(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  if (claim.subject == ClaimSubject::vertex_spectrum) return prove_spectral_condition(scheme, claim, limits, stop);
  if (claim.subject == ClaimSubject::limits && claim.smoothness == 1 && !claim.negated)
    return prove_smooth_at_vertices(scheme, claim, limits, stop);
  return {std::nullopt, "of a surface scheme the spectral condition and C1 can be proved, but not this"};
}

VertexAttempt prove_spectral_condition(const Scheme& scheme, const Claim& claim, const ProofLimits& limits, const Stop& stop) {
  VertexAttempt attempt;
  const auto undecided = [&](std::string reason) {
    attempt.reason = std::move(reason);
    return attempt;
  };
  const SurfaceRule& surface = *scheme.surface;
  const RingRule& rule = surface.rings;
  if (!surface.sequence.first_levels.empty()) return undecided("the first levels of the curve scheme have masks of their own");
  if (harmonics(rule).back() > 1) return undecided("a rule has a harmonic above 1");
  const ValenceRange& valences = *claim.valences;

  VertexProof proof;
  const Mask limit = limit_mask(surface.sequence, 0);
  const ProofAttempt smooth = prove_smooth(limit, 1, {}, limits, stop);
  if (!smooth.proved) return undecided(fmt::format("the curve scheme is not proved to be C1 ({})", smooth.reason));
  const auto* contraction = std::get_if<ContractionWitness>(&smooth.leaves.front().witness);
  if (!contraction) return undecided("the curve scheme is proved to be C1 by a polytope norm only");
  proof.level = contraction->level;
  int reach = rule.curve.symbol.highest();
  for (const auto& [point, terms] : rule.given) reach = std::max(reach, ring_of(rule.dual, point));
  proof.rings = rule.invariant_rings(reach);
  constexpr int most_rings = 8;
  if (proof.rings > most_rings) return undecided(fmt::format("certificates are about at most {} rings; this scheme needs {}", most_rings, proof.rings));
  if (!rows_sum_to_one(rule, proof.rings)) return undecided("the weights of a rule do not sum to 1");
  if (!mirror_symmetric(rule, proof.rings)) return undecided("the rules are not symmetric under reflections of the vertex or face");
  if (const MaskSequence* sequence = scheme.level_sequence()) {
    const std::optional<int> level = uniform_level(*sequence, claim.type, claim.region.front());
    if (!level) return undecided("a mask may have a pole at some angle");
    proof.from_level = *level;
  }

  SpectrumProver prover(rule, proof.rings, stop);
  const auto add_separators_before = [&](int end) {
    for (int n = valences.first + static_cast<int>(proof.separators.size()); n < end; ++n) {
      const std::optional<Rational> separator = prover.separator(n);
      if (!separator) return false;
      proof.separators.push_back(*separator);
    }
    return true;
  };
  if (valences.last) {
    if (!add_separators_before(*valences.last + 1)) return undecided(*prover.failure());
    const std::optional<std::string> reason = vertex_rejection(scheme, claim, proof);
    if (reason) return undecided(*reason);
    attempt.proof = std::move(proof);
    return attempt;
  }
  // Where it does not hold for all valences at once, some more are taken out.
  std::string reason;
  for (int from = valences.first; from <= valences.first + 16; ++from) {
    if (!add_separators_before(from)) return undecided(*prover.failure());
    const bool accepted = prover.for_all(from, [&](const AllValencesProof& all) {
      stop.check();
      proof.all = all;
      const std::optional<std::string> rejected = vertex_rejection(scheme, claim, proof);
      if (rejected) reason = *rejected;
      return !rejected;
    });
    if (!accepted) continue;
    attempt.proof = std::move(proof);
    return attempt;
  }
  return undecided(reason.empty() ? prover.failure().value_or("") : fmt::format("no proof for all valences at once was accepted: {}", reason));
}

}  // namespace limes
