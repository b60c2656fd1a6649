// The invariant polytope algorithm for matrices B(s) between B(0) and B(1): orbits at both ends under the same words. Whether an image is inside is
// asked at s = 1/2; the combination found there is corrected at both ends, and its middle coefficient by what the ends leave open.
#include "analysis/spectral_radius/moving_polytope.hpp"

#include "algebra/error.hpp"
#include "analysis/spectral_radius/exact_vectors_impl.hpp"
#include "analysis/spectral_radius/generations_impl.hpp"
#include "analysis/spectral_radius/hull_oracle_impl.hpp"
#include "analysis/spectral_radius/leading_words.hpp"
#include "analysis/spectral_radius/moving_norm_impl.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace limes {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Ends = std::array<Eigen::VectorXd, 2>;

/// One term of a combination: Bernstein coefficients.
struct ApproxMovingTerm {
  int index = 0;
  bool conjugate = false;
  std::array<std::complex<double>, 3> c;
};

struct ApproxMoving {
  double norm = 0;
  std::vector<ApproxMovingTerm> terms;
};

/// Eigenvectors of greatest modulus at both ends, in one scale: an entry is 1. Real ones have n entries, complex ones 2n.
std::optional<Ends> leading_vectors(const std::array<Eigen::MatrixXd, 2>& products) {
  std::array<Eigen::VectorXcd, 2> v;
  bool real = true;
  std::complex<double> first = 0;
  for (std::size_t k : {0, 1}) {
    const ApproxEigenpairs pairs = approx_eigenpairs(products[k]);
    if (!pairs.values.allFinite()) return std::nullopt;
    Eigen::Index best = 0;
    const double radius = pairs.values.cwiseAbs().maxCoeff(&best);
    // Of a conjugate pair the one nearer to that at the other end.
    for (Eigen::Index j = 0; k == 1 && j < pairs.values.size(); ++j) {
      const std::complex<double> mu = pairs.values(j);
      if (std::abs(mu) >= radius * (1 - 1e-9) && std::abs(mu - first) < std::abs(pairs.values(best) - first)) best = j;
    }
    first = pairs.values(best);
    real = real && std::abs(first.imag()) <= 1e-9 * radius;
    v[k] = pairs.vectors.col(best);
  }
  Eigen::Index pivot = 0;
  v[0].cwiseAbs().maxCoeff(&pivot);
  Ends result;
  for (std::size_t k : {0, 1}) {
    v[k] /= v[k](pivot);
    if (!v[k].allFinite()) return std::nullopt;
    result[k] = v[k].real();
    if (!real) {
      result[k].conservativeResize(2 * v[k].size());
      result[k].tail(v[k].size()) = v[k].imag();
    }
  }
  return result;
}

class MovingSearch {
 public:
  MovingSearch(const MatrixFamily& ends, const Rational& bound, const PolytopeLimits& limits, const Stop& stop)
      : ends_(ends), basis_(RationalMatrix::identity(family_size(ends))), inverse_(basis_), letters_(ends.size() / 2), bound_(bound), limits_(limits), stop_(stop), n_(family_size(ends)) {
    inner_bound_ = bound * (1 - Rational(1, Integer(1) << unsigned(std::max(limits.precision - 26, 8))));
    tolerated_ = approx_double(inner_bound_);
    images_.resize(letters_);
  }

  std::optional<MovingPolytope> run() {
    std::array<std::vector<LeadingWord>, 2> words;
    double least_room = infinity;
    for (std::size_t k : {0, 1}) {
      const MatrixFamily family(ends_.begin() + std::ptrdiff_t(k * letters_), ends_.begin() + std::ptrdiff_t((k + 1) * letters_));
      for (const RationalMatrix& b : family) approx_ends_[k].push_back(approx_matrix(b));
      words[k] = approx_leading_words(family, {12, 60}, 1e-9, stop_);
      const double room = tolerated_ / words[k].front().radius;
      if (!(room > 1)) return std::nullopt;
      least_room = std::min(least_room, room);
      constexpr int bits = 30;
      generation_[k] = inner_bound_;
      if (std::isfinite(room)) generation_[k] = round_to_bits(inner_bound_ * Rational(std::pow(room, -limits_.eagerness)), bits);
    }
    const bool tighter = words[1].front().radius > words[0].front().radius;
    std::vector<Ends> starts;
    bool complex = false;
    for (const LeadingWord& word : words[tighter ? 1 : 0]) {
      std::optional<Ends> v = leading_vectors({approx_product(approx_ends_[0], word.word), approx_product(approx_ends_[1], word.word)});
      if (!v) continue;
      if (limits_.eagerness > 0 && least_room > 1 + limits_.real_room) {
        for (Eigen::VectorXd& x : *v) x.conservativeResize(n_);
      }
      complex = complex || (*v)[0].size() > n_;
      starts.push_back(std::move(*v));
      if (starts.size() == 32) break;
    }
    length_ = complex ? 2 * n_ : n_;
    oracle_.emplace(n_, complex);
    for (const Ends& v : starts) add_start(v);
    if (vectors_.empty()) add_start({Eigen::VectorXd::Unit(n_, 0), Eigen::VectorXd::Unit(n_, 0)});
    if (!close()) return std::nullopt;
    make_round();
    if (const std::optional<double> reach = unit_reach()) return finish(*reach);
    for (int k = 0; k < n_; ++k) add_start({Eigen::VectorXd::Unit(n_, k) / 64, Eigen::VectorXd::Unit(n_, k) / 64});
    if (!close()) return std::nullopt;
    if (const std::optional<double> reach = unit_reach()) return finish(*reach);
    return std::nullopt;
  }

  /// The coordinates T in which the polytope is written, and T^{-1}; set by run().
  const RationalMatrix& basis() const { return basis_; }
  const RationalMatrix& inverse() const { return inverse_; }

 private:
  /// Coordinates in which the vectors spread alike in all directions: what remains is measured by unit vectors. T = L D, where L has ones on its diagonal
  /// and D powers of 2, so that T^{-1} is dyadic as well.
  void make_round() {
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(n_, n_);
    for (const Ends& v : approx_vectors_) {
      const Eigen::VectorXd middle = (v[0] + v[1]) / 2;
      for (int first = 0; first < length_; first += n_) spread += middle.segment(first, n_) * middle.segment(first, n_).transpose();
    }
    const Eigen::LLT<Eigen::MatrixXd> root(spread / double(approx_vectors_.size()));
    if (n_ == 1 || root.info() != Eigen::Success) return;
    const Eigen::MatrixXd lower = root.matrixL();
    constexpr int bits = 10;
    RationalMatrix t(n_, n_), inverse = RationalMatrix::identity(n_);
    for (int j = 0; j < n_; ++j) {
      if (!(lower(j, j) > 0)) return;
      for (int i = j; i < n_; ++i) t(i, j) = i == j ? Rational(1) : round_to_bits(Rational(lower(i, j) / lower(j, j)), bits);
    }
    for (int i = 0; i < n_; ++i) {
      for (int k = 0; k < i; ++k) {
        for (int j = 0; j <= k; ++j) inverse(i, j) -= t(i, k) * inverse(k, j);
      }
    }
    for (int k = 0; k < n_; ++k) {
      const Rational scale(std::exp2(std::round(std::log2(lower(k, k)))));
      for (int i = 0; i < n_; ++i) {
        t(i, k) *= scale;
        inverse(k, i) /= scale;
      }
    }
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      ends_[e] = inverse * ends_[e] * t;
      approx_ends_[e / letters_][e % letters_] = approx_matrix(ends_[e]);
    }
    oracle_.emplace(n_, length_ > n_);
    for (std::size_t j = 0; j < vectors_.size(); ++j) {
      for (std::size_t k : {0, 1}) {
        vectors_[j][k] = image_of(inverse, vectors_[j][k]);
        for (Rational& x : vectors_[j][k]) x = round_to_bits(x, limits_.precision);
        approx_vectors_[j][k] = approx_vector(vectors_[j][k]);
      }
      oracle_->add((approx_vectors_[j][0] + approx_vectors_[j][1]) / 2);
    }
    basis_ = std::move(t);
    inverse_ = std::move(inverse);
  }

  Eigen::VectorXd lifted(const Eigen::VectorXd& v) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(length_);
    result.head(v.size()) = v;
    return result;
  }

  Eigen::VectorXd image(std::size_t k, std::size_t e, const Eigen::VectorXd& v) const {
    Eigen::VectorXd result(length_);
    for (int first = 0; first < length_; first += n_) result.segment(first, n_) = approx_ends_[k][e] * v.segment(first, n_);
    return result;
  }

  void add_start(const Ends& start) {
    const Eigen::VectorXd middle = lifted((start[0] + start[1]) / 2);
    if (middle.cwiseAbs().maxCoeff() == 0 || oracle_->combine(middle, 1).norm <= 1) return;
    std::array<RationalVector, 2> exact;
    for (std::size_t k : {0, 1})
      for (const double x : lifted(start[k])) exact[k].push_back(round_to_bits(Rational(x), limits_.precision));
    add_vector(std::move(exact));
  }

  void add_vector(std::array<RationalVector, 2> exact) {
    approx_vectors_.push_back({approx_vector(exact[0]), approx_vector(exact[1])});
    oracle_->add((approx_vectors_.back()[0] + approx_vectors_.back()[1]) / 2);
    vectors_.push_back(std::move(exact));
    for (auto& of_matrix : images_) of_matrix.emplace_back();
  }

  bool close() {
    return close_generations(letters_, vectors_, expanded_, tolerated_, [&](std::size_t e, std::size_t i) { return try_inside(e, i); },
                             [&](std::size_t e, std::size_t i) { return add_image(e, i); });
  }

  double try_inside(std::size_t e, std::size_t i) {
    if (++programs_ % 16 == 0) stop_.check();
    ApproxMoving found = combine(e, approx_vectors_[i], tolerated_);
    if (found.norm <= tolerated_) images_[e][i] = found;
    return found.norm;
  }

  bool add_image(std::size_t e, std::size_t i) {
    if (vectors_.size() >= limits_.max_vectors) return false;
    std::array<RationalVector, 2> exact;
    for (std::size_t k : {0, 1}) {
      exact[k] = image_of(ends_[k * letters_ + e], vectors_[i][k]);
      for (Rational& x : exact[k]) x = round_to_bits(x / generation_[k], limits_.precision);
    }
    add_vector(std::move(exact));
    const double lower = approx_double(generation_[0]), upper = approx_double(generation_[1]);
    images_[e][i] = {0, {{int(vectors_.size()) - 1, false, {lower, (lower + upper) / 2, upper}}}};
    return approx_vectors_.back()[0].cwiseAbs().maxCoeff() < 1e12;
  }

  Eigen::VectorXd column(int index, bool conjugate, std::size_t k, bool times_i) const {
    const bool complex = length_ > n_;
    Eigen::VectorXd v = k == 2 ? Eigen::VectorXd((approx_vectors_[std::size_t(index)][0] + approx_vectors_[std::size_t(index)][1]) / 2)
                               : approx_vectors_[std::size_t(index)][k];
    if (conjugate && complex) v.tail(n_) *= -1;
    if (!times_i) return v;
    Eigen::VectorXd result(v.size());
    result << -v.tail(n_), v.head(n_);
    return result;
  }

  /// c v_j at end k, or at the middle (k = 2).
  Eigen::VectorXd multiple(const ApproxMovingTerm& term, std::complex<double> c, std::size_t k) const {
    Eigen::VectorXd result = c.real() * column(term.index, term.conjugate, k, false);
    if (c.imag() != 0) result += c.imag() * column(term.index, term.conjugate, k, true);
    return result;
  }

  /// What c_j,1 have to represent at the middle: Q_1 + (c_2 - c_0)(v(1) - v(0)) / 4, for Q the image.
  Eigen::VectorXd middle_target(const ApproxMoving& combination, std::size_t e, const Ends& x) const {
    Eigen::VectorXd result = (image(0, e, x[1]) + image(1, e, x[0])) / 2;
    for (const ApproxMovingTerm& term : combination.terms) {
      const std::complex<double> difference = (term.c[2] - term.c[0]) / 4.0;
      result += multiple(term, difference, 1) - multiple(term, difference, 0);
    }
    return result;
  }

  void set_norm(ApproxMoving& combination) const {
    std::array<double, 3> sums{0, 0, 0};
    for (const ApproxMovingTerm& term : combination.terms)
      for (std::size_t k = 0; k < 3; ++k) sums[k] += std::abs(term.c[k]);
    const std::array<double, 4> all = elevated(sums);
    combination.norm = *std::max_element(all.begin(), all.end());
  }

  /// Adds what is missing at the middle as a combination of its own.
  void append_middle(ApproxMoving& combination, std::size_t e, const Ends& x) {
    Eigen::VectorXd rest = middle_target(combination, e, x);
    for (const ApproxMovingTerm& term : combination.terms) rest -= multiple(term, term.c[1], 2);
    const ApproxCombination extra = oracle_->combine(rest, infinity);
    for (const ApproxTerm& term : extra.terms) {
      const auto same = std::find_if(combination.terms.begin(), combination.terms.end(),
                                     [&](const auto& t) { return t.index == term.index && t.conjugate == term.conjugate; });
      if (same != combination.terms.end()) same->c[1] += term.c;
      else combination.terms.push_back({term.index, term.conjugate, {0, term.c, 0}});
    }
    set_norm(combination);
    if (!std::isfinite(extra.norm)) combination.norm = infinity;
  }

  /// Coefficients number k, corrected so that they represent the target at end k or the middle.
  bool correct(ApproxMoving& combination, std::size_t coefficient, std::size_t place, const Eigen::VectorXd& target) const {
    const Eigen::Index parts = length_ > n_ ? 2 : 1, count = Eigen::Index(combination.terms.size());
    Eigen::MatrixXd columns(length_, parts * count);
    Eigen::VectorXd rest = target;
    for (Eigen::Index j = 0; j < count; ++j) {
      const ApproxMovingTerm& term = combination.terms[std::size_t(j)];
      for (Eigen::Index part = 0; part < parts; ++part) columns.col(parts * j + part) = column(term.index, term.conjugate, place, part == 1);
      rest -= multiple(term, term.c[coefficient], place);
    }
    const Eigen::VectorXd c = columns.completeOrthogonalDecomposition().solve(rest);
    for (Eigen::Index j = 0; j < count; ++j)
      combination.terms[std::size_t(j)].c[coefficient] += std::complex<double>(c(parts * j), parts == 2 ? c(parts * j + 1) : 0);
    return (columns * c - rest).cwiseAbs().maxCoeff() <= 1e-10 * (1 + target.cwiseAbs().maxCoeff());
  }

  /// A combination for B_e(s) x(s), with a norm of about the least at s = 1/2.
  ApproxMoving combine(std::size_t e, const Ends& x, double enough) {
    const Ends images{image(0, e, x[0]), image(1, e, x[1])};
    const Eigen::VectorXd middle = ((image(0, e, x[1]) + image(1, e, x[0])) / 2 + (images[0] + images[1]) / 2) / 2;
    if (std::max(images[0].cwiseAbs().maxCoeff(), images[1].cwiseAbs().maxCoeff()) < std::ldexp(1.0, -limits_.precision)) return {};
    ApproxMoving result;
    // A hasty combination may do at the middle and not at the ends.
    for (const bool best : {false, true}) {
      const ApproxCombination approx = oracle_->combine(middle, enough, best);
      result = {approx.norm, {}};
      if (!(approx.norm <= enough)) return result;
      for (const ApproxTerm& term : approx.terms) result.terms.push_back({term.index, term.conjugate, {term.c, term.c, term.c}});
      bool spans = correct(result, 0, 0, images[0]) && correct(result, 2, 1, images[1]);
      spans = spans && correct(result, 1, 2, middle_target(result, e, x));
      set_norm(result);
      if (!spans) result.norm = infinity;
      if (result.norm <= enough || length_ == n_) break;
    }
    return result;
  }

  std::optional<double> unit_reach() {
    double greatest = 0;
    for (int k = 0; k < n_; ++k) {
      const Eigen::VectorXd unit = lifted(Eigen::VectorXd::Unit(n_, k));
      if (!std::isfinite(oracle_->combine(unit, infinity).norm)) return std::nullopt;
      for (std::size_t e = 0; e < letters_; ++e) greatest = std::max(greatest, combine(e, {unit, unit}, infinity).norm);
    }
    if (!std::isfinite(greatest)) return std::nullopt;
    return greatest == 0 ? 1 : std::min(1.0, 0.5 / greatest);
  }

  std::optional<MovingPolytope> finish(double reach) {
    MovingPolytope result;
    result.unit = Rational(std::exp2(std::floor(std::log2(reach))));
    result.vectors = vectors_;
    result.images.resize(letters_);
    for (std::size_t e = 0; e < letters_; ++e) {
      for (std::size_t i = 0; i < vectors_.size() + std::size_t(n_); ++i) {
        std::array<RationalVector, 2> x;
        ApproxMoving approx;
        if (i < vectors_.size()) {
          x = vectors_[i];
          approx = images_[e][i];
          append_middle(approx, e, approx_vectors_[i]);
        } else {
          x[0] = x[1] = unit_vector(n_, int(i - vectors_.size()), result.unit);
          const Eigen::VectorXd unit = lifted(approx_vector(x[0]));
          approx = combine(e, {unit, unit}, infinity);
        }
        std::optional<MovingCombination> exact = make_exact(e, x, approx, result.unit);
        if (!exact) return std::nullopt;
        result.images[e].push_back(std::move(*exact));
      }
    }
    return result;
  }

  std::optional<MovingCombination> make_exact(std::size_t e, const std::array<RationalVector, 2>& x, const ApproxMoving& approx,
                                              const Rational& unit) const {
    for (const int bits : {14, 20, 30, 45}) {
      MovingCombination result;
      for (const ApproxMovingTerm& term : approx.terms) {
        MovingTerm& exact = result.emplace_back(MovingTerm{term.index, term.conjugate, {}, {}});
        bool zero = true;
        for (std::size_t k = 0; k < 3; ++k) {
          // The generation bounds have 30 bits: coefficients of new vectors stay exact.
          exact.re[k] = round_to_bits(Rational(term.c[k].real()), bits);
          exact.im[k] = round_to_bits(Rational(term.c[k].imag()), bits);
          zero = zero && exact.re[k] == 0 && exact.im[k] == 0;
        }
        if (zero) result.pop_back();
      }
      if (exact_moving_norm(result, {&ends_[e], &ends_[letters_ + e]}, x, vectors_, unit) <= bound_) return result;
    }
    return std::nullopt;
  }

  MatrixFamily ends_;
  RationalMatrix basis_, inverse_;
  std::size_t letters_;
  const Rational bound_;
  Rational inner_bound_;
  std::array<Rational, 2> generation_;   // what new vectors are divided by, at each end
  double tolerated_ = 1;
  const PolytopeLimits& limits_;
  const Stop& stop_;
  int n_;
  int length_ = 0;
  std::array<std::vector<Eigen::MatrixXd>, 2> approx_ends_;
  std::optional<HullOracle> oracle_;   // at s = 1/2
  std::vector<std::array<RationalVector, 2>> vectors_;
  std::vector<Ends> approx_vectors_;
  std::vector<std::vector<ApproxMoving>> images_;
  std::size_t expanded_ = 0, programs_ = 0;
};

}  // namespace

std::optional<MovingNorm> find_moving_polytope(const MatrixFamily& ends, const Rational& bound, const PolytopeLimits& limits, const Stop& stop) {
  if (bound <= 0 || ends.empty() || ends.size() % 2 != 0) throw DomainError("find_moving_polytope: no positive bound, or an odd number of matrices");
  MovingNorm result{bound, block_triangular_form(ends), {}};
  RationalMatrix change = RationalMatrix::identity(family_size(ends)), back = change;
  for (std::size_t k = 0, first = 0; k < result.form.sizes.size(); first += std::size_t(result.form.sizes[k++])) {
    const MatrixFamily block = result.form.diagonal_block(k);
    MovingSearch search(block, bound, limits, stop);
    std::optional<MovingPolytope> polytope = search.run();
    if (!polytope) return std::nullopt;
    result.blocks.push_back(std::move(*polytope));
    for (int i = 0; i < result.form.sizes[k]; ++i) {
      for (int j = 0; j < result.form.sizes[k]; ++j) {
        change(int(first) + i, int(first) + j) = search.basis()(i, j);
        back(int(first) + i, int(first) + j) = search.inverse()(i, j);
      }
    }
  }
  BlockTriangularForm& form = result.form;
  form.basis = form.basis * change;
  form.inverse = back * form.inverse;
  for (RationalMatrix& b : form.matrices) b = back * b * change;
  return result;
}

}  // namespace limes
