// The invariant polytope algorithm at R = JSR, over the field Q(alpha). What lies on the boundary of the hull (the cycles of leading
// eigenvectors) is an identity of vectors over the field; everything else is strictly inside, which rational enclosures show.
#include "analysis/spectral_radius/exact_polytope.hpp"

#include "algebra/polynomial/factorisation.hpp"
#include "analysis/spectral_radius/exact_vectors_impl.hpp"
#include "analysis/spectral_radius/generations_impl.hpp"
#include "analysis/spectral_radius/hull_oracle_impl.hpp"
#include "analysis/spectral_radius/leading_words.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace limes {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Images whose norm is less than this, relative to alpha, count as inside; between it and 1 they become vectors.
constexpr double inside = 1 - 1e-6;
/// Vectors are enclosed with this many bits.
constexpr int enclosure_bits = 160;
constexpr int max_coefficient_bits = 16384;

/// A real eigenvalue of greatest modulus, if there is one.
std::optional<double> real_leading_eigenvalue(const Eigen::MatrixXd& a) {
  const Eigen::VectorXcd values = approx_eigenvalues(a);
  Eigen::Index best = 0;
  const double radius = values.cwiseAbs().maxCoeff(&best);
  if (radius == 0 || std::abs(values(best).imag()) > 1e-7 * radius) return std::nullopt;
  return values(best).real();
}

/// f(a) z.
RationalVector evaluate(const Polynomial& f, const RationalMatrix& a, const RationalVector& z) {
  RationalVector result(z.size(), 0);
  for (int k = f.degree(); k >= 0; --k) {
    result = a * result;
    for (std::size_t i = 0; i < z.size(); ++i) result[i] += f.coefficient(k) * z[i];
  }
  return result;
}

/// An eigenvector of the product for the eigenvalue lambda = sign alpha^k, a root of f: with f(product) z = 0 the vector
/// ((f(y) - f(lambda)) / (y - lambda))(product) z, which is zero for no z != 0 unless a smaller polynomial annihilates z.
std::optional<AlgebraicVector> eigenvector(const RationalMatrix& product, const NumberField& field, int sign, int k) {
  const int n = product.rows();
  const Polynomial lambda = field.times_power(Polynomial::constant(sign), k);
  // The minimal polynomial f of lambda is the factor of chi that vanishes there.
  Polynomial chi = characteristic_polynomial(product), f;
  const auto at_lambda = [&](const Polynomial& p) {
    Polynomial value;
    for (int i = p.degree(); i >= 0; --i) value = field.reduced(value * lambda + Polynomial::constant(p.coefficient(i)));
    return value;
  };
  for (const auto& [factor, multiplicity] : irreducible_factors(chi)) {
    if (at_lambda(factor).is_zero()) f = factor;
  }
  if (f.is_zero()) return std::nullopt;
  const Polynomial cofactor = divide(square_free_part(chi), f).first;
  for (int e = 0; e < n; ++e) {
    // Kill the other eigenvalues' parts, then go down to the end of the Jordan chains.
    RationalVector z = unit_vector(n, e, 1);
    for (int repeat = 0; repeat < n; ++repeat) z = evaluate(cofactor, product, z);
    for (RationalVector next = z; std::any_of(next.begin(), next.end(), [](const Rational& x) { return x != 0; });
         next = evaluate(f, product, next))
      z = next;
    AlgebraicVector v(z.size());
    // sum_{i >= 1} f_i sum_{j < i} lambda^{i-1-j} product^j z, by Horner's rule in j from the top: the coefficient of product^j z is
    // sum_{i > j} f_i lambda^{i-1-j}.
    std::vector<Polynomial> weights(std::size_t(f.degree()));
    Polynomial weight;
    for (int j = f.degree() - 1; j >= 0; --j) {
      weight = field.reduced(weight * lambda + Polynomial::constant(f.coefficient(j + 1)));
      weights[std::size_t(j)] = weight;
    }
    for (int j = 0; j < f.degree(); ++j) {
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += z[i] * weights[std::size_t(j)];
      z = product * z;
    }
    if (std::any_of(v.begin(), v.end(), [](const Polynomial& p) { return !p.is_zero(); })) return v;
  }
  return std::nullopt;
}

/// Factors a_i > 0 with a_i q_ij < a_j for all i != j, with as much room as a coarse search finds; all 1 when there are none.
std::vector<double> balancing_factors(const std::vector<std::vector<double>>& q) {
  const std::size_t count = q.size();
  for (const double room : {1.0, 0.5, 0.2, 0.1, 0.03, 0.01, 0.001}) {
    std::vector<double> log_a(count, 0);
    bool settled = false;
    for (std::size_t round = 0; round <= count && !settled; ++round) {
      settled = true;
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
          const double least = log_a[i] + std::log(std::max(q[i][j], 1e-9)) + room;
          if (i == j || log_a[j] >= least - 1e-12) continue;
          log_a[j] = least;
          settled = false;
        }
      }
    }
    if (!settled) continue;
    for (double& x : log_a) x = std::exp(x);
    return log_a;
  }
  return std::vector<double>(count, 1);
}

class ExactSearch {
 public:
  /// \param units whether small multiples of the unit vectors are starts too, so that the vectors span the space
  ExactSearch(const MatrixFamily& family, bool units, const PolytopeLimits& limits, const Stop& stop)
      : family_(family), units_(units), limits_(limits), stop_(stop), n_(family_size(family)), oracle_(n_, false) {
    for (const RationalMatrix& b : family) approx_family_.push_back(approx_matrix(b));
    images_.resize(family.size());
  }

  enum class Outcome { proved, not_closed, not_spanning };

  Outcome run() {
    if (!find_starts() || !close()) return Outcome::not_closed;
    const std::optional<double> reach = unit_reach();
    if (!reach) return Outcome::not_spanning;
    return finish(*reach) ? Outcome::proved : Outcome::not_closed;
  }
  ExactPolytope take_result() { return std::move(result_); }

 private:
  struct Start {
    Word word;
    int sign;
    AlgebraicVector vector;
    Eigen::VectorXd approx, functional;   // right and left eigenvector, <functional, approx> = 1
  };

  bool find_starts() {
    std::vector<Start> starts;
    for (const LeadingWord& leading : approx_leading_words(family_, {}, 1e-9, stop_)) {
      const RationalMatrix exact = product(family_, leading.word);
      const Eigen::MatrixXd approx = approx_product(approx_family_, leading.word);
      const std::optional<double> lambda = real_leading_eigenvalue(approx);
      if (!lambda) return false;
      const int k = int(leading.word.size());
      if (!field_) {
        std::optional<AlgebraicNumber> alpha = algebraic_root(characteristic_polynomial(exact), *lambda, k);
        if (!alpha || alpha->polynomial.degree() > limits_.max_degree) return false;
        field_.emplace(std::move(*alpha));
        const double radius = approx_double(field_->alpha().lower);
        for (Eigen::MatrixXd& b : approx_family_) b /= radius;
      }
      const int sign = *lambda > 0 ? 1 : -1;
      std::optional<AlgebraicVector> v = eigenvector(exact, *field_, sign, k);
      if (!v) continue;  // a slightly smaller radius after all
      if (!add_start(starts, {leading.word, sign, std::move(*v), {}, {}}, approx.transpose(), *lambda)) return false;
      if (starts.size() == 24) break;
    }
    if (starts.empty()) return false;
    const std::vector<double> factors = balancing_factors(reach_of(starts));
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Rational factor = round_to_bits(Rational(factors[i] / *std::max_element(factors.begin(), factors.end())), 24);
      for (Polynomial& entry : starts[i].vector) entry *= factor;
      // A start may be +- a vector that is there already, up to a factor, or inside: then it adds nothing.
      if (oracle_.combine(approx_of(starts[i].vector), 1).norm <= 1 + 1e-9) continue;
      result_.starts.push_back(starts[i].vector);
      if (result_.word.empty()) result_.word = starts[i].word, result_.sign = starts[i].sign;
      add_vector(starts[i].vector);
    }
    for (int k = 0; units_ && k < n_; ++k) {
      AlgebraicVector unit(result_.starts.front().size());
      unit[std::size_t(k)] = Polynomial::constant(Rational(1, 64));
      result_.starts.push_back(unit);
      add_vector(std::move(unit));
    }
    return !result_.starts.empty();
  }

  /// Scales the vector to greatest entry about 1 and finds the functional; false when the eigenvalue has a Jordan block.
  bool add_start(std::vector<Start>& starts, Start start, const Eigen::MatrixXd& transposed, double lambda) {
    const ApproxEigenpairs pairs = approx_eigenpairs(transposed);
    Eigen::Index best = 0;
    (pairs.values.array() - lambda).cwiseAbs().minCoeff(&best);
    start.functional = pairs.vectors.col(best).real();
    Rational greatest = 0;
    for (const Polynomial& entry : start.vector) greatest = std::max(greatest, abs(field_->enclose(entry, enclosure_bits).value));
    if (greatest == 0) return false;
    const Rational factor = simplest_between(Rational(999, 1000) / greatest, Rational(1001, 1000) / greatest);
    for (Polynomial& entry : start.vector) entry *= factor;
    start.approx = approx_of(start.vector);
    const double pairing = start.functional.dot(start.approx);
    if (std::abs(pairing) < 1e-9) return false;
    start.functional /= pairing;
    starts.push_back(std::move(start));
    return true;
  }

  /// q_ij = greatest |<functional_j, x>| over images x of start i under short products, all at scale alpha = 1.
  std::vector<std::vector<double>> reach_of(const std::vector<Start>& starts) const {
    std::vector<std::vector<double>> q(starts.size(), std::vector<double>(starts.size(), 0));
    for (std::size_t i = 0; i < starts.size(); ++i) {
      std::vector<Eigen::VectorXd> level{starts[i].approx};
      for (int depth = 0; depth < 8 && level.size() < 512; ++depth) {
        std::vector<Eigen::VectorXd> next;
        for (const Eigen::VectorXd& x : level) {
          for (std::size_t j = 0; j < starts.size(); ++j) q[i][j] = std::max(q[i][j], std::abs(starts[j].functional.dot(x)));
          for (const Eigen::MatrixXd& b : approx_family_) next.push_back(b * x);
        }
        level = std::move(next);
      }
    }
    return q;
  }

  Eigen::VectorXd approx_of(const AlgebraicVector& v) const {
    Eigen::VectorXd result{Eigen::Index(v.size())};
    for (std::size_t i = 0; i < v.size(); ++i) result(Eigen::Index(i)) = approx_double(field_->enclose(v[i], enclosure_bits).value);
    return result;
  }

  void add_vector(AlgebraicVector v) {
    Enclosure enclosure{RationalVector(v.size()), 0};
    for (std::size_t i = 0; i < v.size(); ++i) {
      const NumberField::Enclosure entry = field_->enclose(v[i], enclosure_bits);
      enclosure.center[i] = entry.value;
      enclosure.error = std::max(enclosure.error, entry.error);
    }
    oracle_.add(approx_vector(enclosure.center));
    enclosures_.push_back(std::move(enclosure.center));
    errors_.push_back(round_to_bits(enclosure.error, enclosure_bits + 64) + Rational(1, Integer(1) << unsigned(enclosure_bits)));
    vectors_.push_back(std::move(v));
    for (auto& of_matrix : images_) of_matrix.emplace_back();
  }

  AlgebraicVector exact_image(std::size_t e, const AlgebraicVector& v) const {
    AlgebraicVector result(v.size());
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) {
        if (family_[e](i, j) != 0) result[std::size_t(i)] += family_[e](i, j) * v[std::size_t(j)];
      }
    }
    return result;
  }

  bool close() {
    return close_generations(family_.size(), vectors_, expanded_, inside, [&](std::size_t e, std::size_t i) { return try_inside(e, i); },
                             [&](std::size_t e, std::size_t i) { return add_image(e, i); });
  }

  bool add_image(std::size_t e, std::size_t i) {
    if (vectors_.size() >= limits_.max_vectors || !(oracle_.vector(i).cwiseAbs().maxCoeff() < 1e9)) return false;
    AlgebraicVector image = exact_image(e, vectors_[i]);
    std::size_t bits = 0;
    for (Polynomial& entry : image) {
      entry = field_->times_power(entry, -1);
      for (const Rational& c : entry.coefficients()) bits = std::max(bits, c == 0 ? 0 : std::size_t(msb(denominator(c))));
    }
    if (bits > max_coefficient_bits) return false;
    add_vector(std::move(image));
    result_.tree.emplace_back(int(i), int(e));
    images_[e][i] = ExactPolytope::SignedVector{int(vectors_.size()) - 1, 1};
    return true;
  }

  /// The norm of B_e v_i / alpha, as far as the polytope goes; 0 when it is a known vector exactly.
  double try_inside(std::size_t e, std::size_t i) {
    if (++programs_ % 16 == 0) stop_.check();
    const Eigen::VectorXd image = approx_family_[e] * oracle_.vector(i);
    for (std::size_t j = 0; j < vectors_.size(); ++j) {
      for (const int sign : {1, -1}) {
        if ((image - sign * oracle_.vector(j)).cwiseAbs().maxCoeff() > 1e-9) continue;
        AlgebraicVector difference = exact_image(e, vectors_[i]);
        bool same = true;
        for (std::size_t k = 0; k < difference.size() && same; ++k)
          same = (difference[k] - Rational(sign) * field_->times_power(vectors_[j][k], 1)).is_zero();
        if (!same) continue;
        images_[e][i] = ExactPolytope::SignedVector{int(j), sign};
        return 0;
      }
    }
    if (image.cwiseAbs().maxCoeff() < 1e-12) return 0;
    ApproxCombination combination = oracle_.combine(image, inside);
    const double norm = combination.norm;
    if (norm <= inside) images_[e][i] = std::move(combination);
    return norm;
  }

  std::optional<double> unit_reach() {
    double greatest = 0;
    for (int k = 0; k < n_; ++k) {
      if (!std::isfinite(oracle_.combine(Eigen::VectorXd::Unit(n_, k), infinity).norm)) return std::nullopt;
      for (const Eigen::MatrixXd& b : approx_family_) greatest = std::max(greatest, oracle_.combine(b.col(k), infinity).norm);
    }
    if (!std::isfinite(greatest)) return std::nullopt;
    return greatest == 0 ? 1 : std::min(1.0, 0.5 / greatest);
  }

  bool finish(double reach) {
    constexpr int radius_bits = 256;
    result_.radius = refined(field_->alpha(), radius_bits);
    result_.unit = Rational(std::exp2(std::floor(std::log2(reach))));
    result_.images.resize(family_.size());
    for (std::size_t e = 0; e < family_.size(); ++e) {
      Rational row_sum = 0;
      for (int i = 0; i < n_; ++i) {
        Rational sum = 0;
        for (int j = 0; j < n_; ++j) sum += abs(family_[e](i, j));
        row_sum = std::max(row_sum, sum);
      }
      const auto append = [&](const RationalVector& x, const Rational& error, const ApproxCombination& approx) {
        std::optional<SparseCombination> exact = make_exact(image_of(family_[e], x), row_sum * error, approx);
        if (exact) result_.images[e].push_back(std::move(*exact));
        return exact.has_value();
      };
      for (std::size_t i = 0; i < vectors_.size(); ++i) {
        if (const auto* same = std::get_if<ExactPolytope::SignedVector>(&images_[e][i]))
          result_.images[e].push_back(*same);
        else if (!append(enclosures_[i], errors_[i], std::get<ApproxCombination>(images_[e][i])))
          return false;
      }
      for (int k = 0; k < n_; ++k) {
        const ApproxCombination approx = oracle_.combine(approx_family_[e].col(k) * approx_double(result_.unit), infinity);
        if (!append(unit_vector(n_, k, result_.unit), 0, approx)) return false;
      }
    }
    return true;
  }

  /// sum |c_j| + ||r||_1 / unit <= alpha for every vector within `error` of the image, in each coordinate.
  std::optional<SparseCombination> make_exact(const RationalVector& image, const Rational& error, const ApproxCombination& approx) const {
    const double radius = approx_double(field_->alpha().lower);
    for (const int bits : {12, 20, 30, 45}) {
      SparseCombination result;
      Rational uncertainty = error;
      for (const ApproxTerm& term : approx.terms) {
        Rational c = round_to_bits(Rational(term.c.real() * radius), bits);
        if (c == 0) continue;
        uncertainty += abs(c) * errors_[std::size_t(term.index)];
        result.push_back({term.index, false, std::move(c), 0});
      }
      const Rational norm = combination_norm(image, result, enclosures_, result_.unit) + n_ * uncertainty / result_.unit;
      if (norm <= field_->alpha().lower) return result;
    }
    return std::nullopt;
  }

  struct Enclosure {
    RationalVector center;
    Rational error;
  };

  const MatrixFamily& family_;
  const bool units_;
  const PolytopeLimits& limits_;
  const Stop& stop_;
  int n_;
  std::vector<Eigen::MatrixXd> approx_family_;   // B_e / alpha, once alpha is known
  std::optional<NumberField> field_;
  HullOracle oracle_;
  std::vector<AlgebraicVector> vectors_;
  std::vector<RationalVector> enclosures_;       // centres, with errors_ in each coordinate
  std::vector<Rational> errors_;
  std::vector<std::vector<std::variant<ApproxCombination, ExactPolytope::SignedVector>>> images_;   // of B_e v_i / alpha
  ExactPolytope result_;
  std::size_t expanded_ = 0, programs_ = 0;
};

}  // namespace

std::optional<ExactPolytope> find_exact_polytope(const MatrixFamily& family, const PolytopeLimits& limits, const Stop& stop) {
  for (const bool units : {false, true}) {
    ExactSearch search(family, units, limits, stop);
    const ExactSearch::Outcome outcome = search.run();
    if (outcome == ExactSearch::Outcome::proved) return search.take_result();
    if (outcome == ExactSearch::Outcome::not_closed) break;
  }
  return std::nullopt;
}

}  // namespace limes
