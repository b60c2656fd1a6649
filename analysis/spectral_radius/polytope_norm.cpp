// The invariant polytope algorithm for a bound R above the joint spectral radius. Vectors are B_e v / R'', rounded to a grid, for
// images B_e v that are not yet in the hull times R', with R' a little less than R: rounding and floating-point errors are small
// remainders, which multiples of the unit vectors absorb. R'' is R', or less where there is room above the joint spectral radius. Termination is not proved, correctness is: by exact_polytope_bound.
#include "analysis/spectral_radius/polytope_norm.hpp"

#include "algebra/error.hpp"
#include "analysis/spectral_radius/exact_vectors_impl.hpp"
#include "analysis/spectral_radius/generations_impl.hpp"
#include "analysis/spectral_radius/hull_oracle_impl.hpp"
#include "analysis/spectral_radius/leading_words.hpp"

#include <cmath>
#include <limits>

namespace limes {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// An eigenvector of greatest eigenvalue modulus: n entries when it is real, else 2n.
Eigen::VectorXd leading_vector(const Eigen::MatrixXd& a) {
  const ApproxEigenpairs pairs = approx_eigenpairs(a);
  Eigen::Index best = 0;
  const double radius = pairs.values.cwiseAbs().maxCoeff(&best);
  Eigen::VectorXcd v = pairs.vectors.col(best);
  Eigen::Index pivot = 0;
  v.cwiseAbs().maxCoeff(&pivot);
  v /= v(pivot);
  if (std::abs(pairs.values(best).imag()) <= 1e-9 * radius) return v.real();
  Eigen::VectorXd result(2 * v.size());
  result << v.real(), v.imag();
  return result;
}

class PolytopeSearch {
 public:
  PolytopeSearch(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits, const Stop& stop)
      : family_(family), bound_(bound), limits_(limits), stop_(stop), n_(family_size(family)) {
    // R' = R (1 - 2^-k) leaves room for remainders.
    inner_bound_ = bound * (1 - Rational(1, Integer(1) << unsigned(std::max(limits.precision - 26, 8))));
    images_.resize(family.size());
  }

  std::optional<Polytope> run() {
    const std::vector<LeadingWord> words = approx_leading_words(family_, {12, 60}, 1e-9, stop_);
    const double room = approx_double(inner_bound_) / words.front().radius;
    generation_bound_ = inner_bound_;
    if (limits_.eagerness > 0 && room > 1 && std::isfinite(room)) {
      constexpr int bits = 30;
      generation_bound_ = std::min(inner_bound_, round_to_bits(inner_bound_ * Rational(std::pow(room, -limits_.eagerness)), bits));
    }
    tolerated_ = approx_double(inner_bound_ / generation_bound_);
    for (const RationalMatrix& b : scaled(family_, 1 / generation_bound_)) approx_family_.push_back(approx_matrix(b));

    std::vector<Eigen::VectorXd> starts;
    for (const LeadingWord& word : words) {
      Eigen::VectorXd v = leading_vector(approx_product(approx_family_, word.word));
      if (v.size() > n_ && limits_.eagerness > 0 && room > 1 + limits_.real_room) v.conservativeResize(n_);
      if (v.allFinite()) starts.push_back(std::move(v));
      if (starts.size() == 32) break;
    }
    const bool complex = std::any_of(starts.begin(), starts.end(), [&](const auto& v) { return v.size() > n_; });
    length_ = complex ? 2 * n_ : n_;
    oracle_.emplace(n_, complex);
    for (const Eigen::VectorXd& v : starts) add_start(v);
    if (vectors_.empty()) add_start(Eigen::VectorXd::Unit(n_, 0));
    if (!close()) return std::nullopt;
    if (const std::optional<double> reach = unit_reach()) return finish(*reach);
    // The orbits do not span the space (the family may be reducible over R or C): small unit vectors take part.
    for (int k = 0; k < n_; ++k) add_start(Eigen::VectorXd::Unit(n_, k) / 64);
    if (!close()) return std::nullopt;
    if (const std::optional<double> reach = unit_reach()) return finish(*reach);
    return std::nullopt;
  }

 private:
  /// A real vector as a complex one, where the hull is complex.
  Eigen::VectorXd lifted(const Eigen::VectorXd& v) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(length_);
    result.head(v.size()) = v;
    return result;
  }

  Eigen::VectorXd approx_image(std::size_t e, const Eigen::VectorXd& v) const {
    Eigen::VectorXd result(length_);
    for (int first = 0; first < length_; first += n_) result.segment(first, n_) = approx_family_[e] * v.segment(first, n_);
    return result;
  }

  void add_start(const Eigen::VectorXd& start) {
    const Eigen::VectorXd v = lifted(start);
    if (v.cwiseAbs().maxCoeff() == 0 || oracle_->combine(v, 1).norm <= 1) return;
    RationalVector exact;
    for (Eigen::Index i = 0; i < v.size(); ++i) exact.push_back(round_to_bits(Rational(v(i)), limits_.precision));
    add_vector(std::move(exact));
  }

  void add_vector(RationalVector exact) {
    oracle_->add(approx_vector(exact));
    vectors_.push_back(std::move(exact));
    for (auto& of_matrix : images_) of_matrix.emplace_back();
  }

  bool close() {
    return close_generations(family_.size(), vectors_, expanded_, tolerated_, [&](std::size_t e, std::size_t i) { return try_inside(e, i); },
                             [&](std::size_t e, std::size_t i) { return add_image(e, i); });
  }

  bool add_image(std::size_t e, std::size_t i) {
    if (vectors_.size() >= limits_.max_vectors) return false;
    RationalVector image = image_of(family_[e], vectors_[i]);
    for (Rational& x : image) x = round_to_bits(x / generation_bound_, limits_.precision);
    add_vector(std::move(image));
    images_[e][i] = {1, {{int(vectors_.size()) - 1, false, 1}}};
    return oracle_->vector(vectors_.size() - 1).cwiseAbs().maxCoeff() < 1e12;
  }

  double try_inside(std::size_t e, std::size_t i) {
    if (++programs_ % 16 == 0) stop_.check();
    const Eigen::VectorXd image = approx_image(e, oracle_->vector(i));
    if (image.cwiseAbs().maxCoeff() < std::ldexp(1.0, -limits_.precision)) return 0;
    ApproxCombination combination = oracle_->combine(image, tolerated_);
    if (combination.norm <= tolerated_) images_[e][i] = combination;
    return combination.norm;
  }

  /// Some unit with B_e (unit e_k) / R' well inside, if the vectors span the space.
  std::optional<double> unit_reach() {
    double greatest = 0;
    for (int k = 0; k < n_; ++k) {
      const Eigen::VectorXd unit = lifted(Eigen::VectorXd::Unit(n_, k));
      if (!std::isfinite(oracle_->combine(unit, infinity).norm)) return std::nullopt;
      for (std::size_t e = 0; e < family_.size(); ++e)
        greatest = std::max(greatest, oracle_->combine(approx_image(e, unit), infinity).norm);
    }
    if (!std::isfinite(greatest)) return std::nullopt;
    return greatest == 0 ? 1 : std::min(1.0, 0.5 / greatest);
  }

  std::optional<Polytope> finish(double reach) {
    Polytope result;
    result.unit = Rational(std::exp2(std::floor(std::log2(reach))));
    result.vectors = vectors_;
    result.images.resize(family_.size());
    const auto append = [&](std::size_t e, const RationalVector& x, const ApproxCombination& image) {
      std::optional<SparseCombination> exact = make_exact(image_of(family_[e], x), image, result.unit);
      if (exact) result.images[e].push_back(std::move(*exact));
      return exact.has_value();
    };
    for (std::size_t e = 0; e < family_.size(); ++e) {
      for (std::size_t i = 0; i < vectors_.size(); ++i) {
        if (!append(e, vectors_[i], images_[e][i])) return std::nullopt;
      }
      for (int k = 0; k < n_; ++k) {
        const RationalVector unit = unit_vector(n_, k, result.unit);
        const ApproxCombination image = oracle_->combine(approx_image(e, lifted(approx_vector(unit))), infinity);
        if (!append(e, unit, image)) return std::nullopt;
      }
    }
    return result;
  }

  /// Rounds the coefficients as coarsely as the bound allows; a few steps of exact refinement where double is not enough.
  std::optional<SparseCombination> make_exact(const RationalVector& image, const ApproxCombination& approx, const Rational& unit) {
    const bool is_new_vector = approx.terms.size() == 1 && approx.terms.front().c == 1.0;
    SparseCombination result;
    for (const int bits : {12, 20, 30, 45}) {
      result.clear();
      for (const ApproxTerm& term : approx.terms) {
        // A vector that was made as this image has the coefficient R''.
        const Rational re = is_new_vector ? generation_bound_ : round_to_bits(Rational(term.c.real()) * generation_bound_, bits);
        const Rational im = round_to_bits(Rational(term.c.imag()) * generation_bound_, bits);
        result.push_back({term.index, term.conjugate, re, im});
      }
      if (combination_norm(image, result, vectors_, unit) <= bound_) return without_zeros(std::move(result));
    }
    for (int step = 0; step < 3 && !result.empty(); ++step) {
      ApproxCombination correction = approx;
      for (ApproxTerm& term : correction.terms) term.c = 0;
      oracle_->correct(correction, lifted(approx_vector(remainder(image, result, vectors_))));
      for (std::size_t k = 0; k < result.size(); ++k) {
        result[k].re += round_to_bits(Rational(correction.terms[k].c.real()), limits_.precision + 16);
        result[k].im += round_to_bits(Rational(correction.terms[k].c.imag()), limits_.precision + 16);
      }
      if (combination_norm(image, result, vectors_, unit) <= bound_) return without_zeros(std::move(result));
    }
    return std::nullopt;
  }

  static SparseCombination without_zeros(SparseCombination combination) {
    std::erase_if(combination, [](const HullTerm& term) { return term.re == 0 && term.im == 0; });
    return combination;
  }

  const MatrixFamily& family_;
  const Rational bound_;
  Rational inner_bound_;
  Rational generation_bound_;                    // R'': what new vectors are divided by
  double tolerated_ = 1;                         // R' / R''
  const PolytopeLimits& limits_;
  const Stop& stop_;
  int n_;
  int length_ = 0;                               // of vectors: n, or 2n when they are complex
  std::vector<Eigen::MatrixXd> approx_family_;   // B_e / R''
  std::optional<HullOracle> oracle_;
  std::vector<RationalVector> vectors_;
  std::vector<std::vector<ApproxCombination>> images_;   // of B_e v_i / R''
  std::size_t expanded_ = 0, programs_ = 0;
};

}  // namespace

std::optional<Polytope> find_block_polytope(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits,
                                            const Stop& stop) {
  if (bound <= 0) throw DomainError("find_polytope: the bound is not positive");
  std::optional<Polytope> polytope = PolytopeSearch(family, bound, limits, stop).run();
  if (polytope && exact_polytope_bound(*polytope, family) > bound) throw InternalError("find_polytope: the bound does not hold");
  return polytope;
}

std::optional<PolytopeNorm> find_polytope(const BlockTriangularForm& form, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop) {
  PolytopeNorm result{bound, form, {}};
  for (std::size_t k = 0; k < form.sizes.size(); ++k) {
    std::optional<Polytope> polytope = find_block_polytope(form.diagonal_block(k), bound, limits, stop);
    if (!polytope) return std::nullopt;
    result.blocks.push_back(std::move(*polytope));
  }
  return result;
}

std::optional<PolytopeNorm> find_polytope(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop) {
  return find_polytope(block_triangular_form(family), bound, limits, stop);
}

}  // namespace limes
