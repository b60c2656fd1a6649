#include "analysis/spectral_radius/spectral_radius_bounds.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/schur_cohn.hpp"
#include "analysis/eigen_impl.hpp"
#include "analysis/spectral_radius/exact_vectors_impl.hpp"
#include "analysis/spectral_radius/leading_words.hpp"

#include <cmath>

namespace limes {
namespace {

/// The hull of the +-e_k alone: its norm of a matrix is the greatest absolute column sum.
BoundedPolytope column_sum_polytope(const MatrixFamily& family) {
  const int n = family_size(family);
  BoundedPolytope result;
  result.polytope.images.assign(family.size(), std::vector<SparseCombination>(std::size_t(n)));
  result.bound = exact_polytope_bound(result.polytope, family);
  return result;
}

const Rational& upper_end(const BlockProof& proof) {
  if (const auto* exact = std::get_if<ExactPolytope>(&proof)) return exact->radius.upper;
  return std::get<BoundedPolytope>(proof).bound;
}

/// 10^-digits.
Rational tolerance(int digits) { return power(Rational(1, 10), digits); }

class RadiusSearch {
 public:
  RadiusSearch(const MatrixFamily& family, const SpectralRadiusOptions& options, const Stop& stop)
      : options_(options), stop_(stop), family_(family) {}

  SpectralRadiusBounds run() {
    result_.form = block_triangular_form(family_);
    for (std::size_t k = 0; k < result_.form.sizes.size(); ++k) {
      blocks_.push_back(result_.form.diagonal_block(k));
      result_.blocks.emplace_back(column_sum_polytope(blocks_[k]));
    }
    try {
      search();
    } catch (const Interrupted&) {
      result_.interrupted = true;
    }
    result_.upper = 0;
    for (const BlockProof& proof : result_.blocks) result_.upper = std::max(result_.upper, upper_end(proof));
    // An exact radius is no use when another block's bound is above it.
    if (result_.exact && upper_end(result_.blocks[leading_]) < result_.upper) result_.exact.reset();
    if (result_.lower > result_.upper) throw InternalError("bounds of a joint spectral radius contradict each other");
    return std::move(result_);
  }

 private:
  void search() {
    std::vector<LeadingWord> words;
    for (const MatrixFamily& block : blocks_) words.push_back(approx_leading_words(block, {}, 1e-9, stop_).front());
    for (std::size_t k = 1; k < blocks_.size(); ++k) {
      if (words[k].radius > words[leading_].radius * (1 + 1e-12)) leading_ = k;
    }
    raise_lower(words[leading_]);
    if (result_.lower == 0) return bound_from_above(Rational(0));
    // Something to fall back on, before the long work.
    for (std::size_t k = 0; k < blocks_.size(); ++k) improve(k, result_.lower * Rational(3, 2));
    std::optional<ExactPolytope> exact = find_exact_polytope(blocks_[leading_], exact_limits(), stop_);
    if (exact && exact->radius.upper >= result_.lower) return finish_exactly(std::move(*exact));
    if (options_.known_upper && is_narrow(*options_.known_upper)) return;
    bound_from_above(result_.lower);
    if (result_.blocks.size() > 0 && !narrow()) {
      // The word may not be the leading one: look farther.
      for (std::size_t k = 0; k < blocks_.size(); ++k) {
        const LeadingWord word = approx_leading_words(blocks_[k], {40, 800}, 1e-9, stop_).front();
        if (word.radius > words[leading_].radius * (1 + 1e-9)) {
          leading_ = k;
          words[leading_] = word;
          raise_lower(word);
        }
      }
      if (!narrow()) bound_from_above(result_.lower);
    }
  }

  /// Exact polytopes close with few vectors or not at all.
  PolytopeLimits exact_limits() const {
    PolytopeLimits limits = options_.polytopes;
    limits.max_vectors = std::min(limits.max_vectors, std::size_t{400});
    return limits;
  }

  bool is_narrow(const Rational& upper) const { return upper <= result_.lower * (1 + tolerance(options_.digits)); }

  bool narrow() const {
    return std::all_of(result_.blocks.begin(), result_.blocks.end(), [&](const BlockProof& proof) { return is_narrow(upper_end(proof)); });
  }

  /// A rational close below rho(product)^{1/k} of the leading block, exactly that where it is rational.
  void raise_lower(const LeadingWord& leading) {
    if (leading.radius == 0 || !std::isfinite(leading.radius)) return;
    const RationalMatrix a = product(blocks_[leading_], leading.word);
    const int k = int(leading.word.size());
    const double signed_value = leading_real_eigenvalue(a);
    if (signed_value != 0) {
      if (const std::optional<AlgebraicNumber> alpha = algebraic_root(characteristic_polynomial(a), signed_value, k)) {
        const int bits = 4 * options_.digits + 24;
        const AlgebraicNumber narrow_alpha = refined(*alpha, bits);
        const Rational lower = alpha->is_rational() ? narrow_alpha.lower : short_below(narrow_alpha.lower, bits);
        if (accept_lower(a, k, lower, leading.word)) return;
      }
    }
    for (double slack = 1e-13; slack < 1e-3; slack *= 10) {
      if (accept_lower(a, k, short_below(Rational(leading.radius * (1 - slack)), 60), leading.word)) return;
    }
  }

  /// A multiple of 2^-bits, at the scale of x, just below x.
  static Rational short_below(const Rational& x, int bits) {
    const int scale = bits - int(std::floor(std::log2(approx_double(x))));
    return round_to_bits(x, std::max(scale, 1)) - Rational(1, Integer(1) << unsigned(std::max(scale, 1)));
  }

  bool accept_lower(const RationalMatrix& a, int k, const Rational& lower, const Word& word) {
    if (lower <= result_.lower || !exact_radius_at_least(a, k, lower)) return lower <= result_.lower;
    result_.lower = lower;
    result_.word = word;
    return true;
  }

  static double leading_real_eigenvalue(const RationalMatrix& a) {
    const Eigen::VectorXcd values = approx_eigenvalues(approx_matrix(a));
    Eigen::Index best = 0;
    const double radius = values.cwiseAbs().maxCoeff(&best);
    return std::abs(values(best).imag()) > 1e-9 * radius ? 0 : values(best).real();
  }

  /// Replaces a block's proof by one of the bound, if there is one and it is better.
  bool improve(std::size_t k, const Rational& bound) {
    if (upper_end(result_.blocks[k]) <= bound) return true;
    std::optional<Polytope> polytope = find_block_polytope(blocks_[k], bound, options_.polytopes, stop_);
    if (polytope) result_.blocks[k] = BoundedPolytope{bound, std::move(*polytope)};
    return polytope.has_value();
  }

  void finish_exactly(ExactPolytope exact) {
    const AlgebraicNumber alpha = exact.radius;
    result_.blocks[leading_] = std::move(exact);
    if (accept_exact_lower(alpha)) result_.exact = alpha;
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      if (k == leading_ || improve(k, alpha.lower)) continue;
      // A block with the same radius.
      std::optional<ExactPolytope> other = find_exact_polytope(blocks_[k], exact_limits(), stop_);
      if (other && other->radius.upper <= alpha.upper) result_.blocks[k] = std::move(*other);
      else improve_towards(k, alpha.upper);
    }
  }

  bool accept_exact_lower(const AlgebraicNumber& alpha) const { return result_.lower <= alpha.lower; }

  /// Bounds close above `radius`, as close as succeeds; with radius 0: halving what is known.
  void bound_from_above(const Rational& radius) {
    for (std::size_t k = 0; k < blocks_.size(); ++k) improve_towards(k, radius);
  }

  void improve_towards(std::size_t k, const Rational& radius) {
    if (radius == 0) {
      for (int step = 0; step < 40 && upper_end(result_.blocks[k]) > 0; ++step) {
        if (!improve(k, upper_end(result_.blocks[k]) / 2)) return;
      }
      return;
    }
    // From coarse to fine: what is known when the search is stopped, or stops at its limit of vectors, is worth something then.
    const Rational finest = tolerance(options_.digits) * Rational(9, 10);
    for (Rational excess = std::max(Rational(1, 4), finest); improve(k, radius * (1 + excess)) && excess > finest;)
      excess = std::max(Rational(excess / 6), finest);
  }

  const SpectralRadiusOptions& options_;
  const Stop& stop_;
  const MatrixFamily& family_;
  std::vector<MatrixFamily> blocks_;
  std::size_t leading_ = 0;
  SpectralRadiusBounds result_;
};

}  // namespace

bool exact_radius_at_least(const RationalMatrix& a, int k, const Rational& bound) {
  if (bound < 0 || k < 1) throw DomainError("exact_radius_at_least: a negative bound or an empty word");
  return bound == 0 || !roots_inside_circle(characteristic_polynomial(a), power(bound, k));
}

SpectralRadiusBounds bound_spectral_radius(const MatrixFamily& family, const SpectralRadiusOptions& options, const Stop& stop) {
  family_size(family);
  return RadiusSearch(family, options, stop).run();
}

}  // namespace limes
