// The invariant polytope algorithm for a bound R above the joint spectral radius. Vectors are B_e v / R', rounded to a grid, for
// images B_e v / R' that are not yet in the hull, with R' a little less than R: rounding and floating-point errors are small
// remainders, which multiples of the unit vectors absorb. Termination is not proved, correctness is: by exact_polytope_bound.
#include "analysis/spectral_radius/polytope_norm.hpp"

#include "algebra/error.hpp"
#include "analysis/spectral_radius/hull_oracle_impl.hpp"
#include "analysis/spectral_radius/leading_words.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace limes {
namespace {

using Vector = std::vector<Rational>;

/// The nearest multiple of 2^-bits.
Rational rounded(const Rational& x, int bits) {
  const Integer scaled = (numerator(x) << unsigned(bits + 1)) + denominator(x);
  const Integer twice = 2 * denominator(x);
  Integer quotient = scaled / twice;
  if (scaled < 0 && quotient * twice != scaled) quotient -= 1;
  return Rational(quotient, Integer(1) << unsigned(bits));
}

Rational rounded(double x, int bits) { return rounded(Rational(x), bits); }

/// B x - sum_j c_j v_j.
Vector remainder(const RationalMatrix& b, const Vector& x, const SparseCombination& combination, const std::vector<Vector>& vectors) {
  Vector r = b * x;
  for (const auto& [j, c] : combination) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (vectors[std::size_t(j)][i] != 0) r[i] -= c * vectors[std::size_t(j)][i];
    }
  }
  return r;
}

Rational combination_norm(const RationalMatrix& b, const Vector& x, const SparseCombination& combination,
                          const std::vector<Vector>& vectors, const Rational& unit) {
  Rational rest = 0, sum = 0;
  for (const Rational& entry : remainder(b, x, combination, vectors)) rest += abs(entry);
  for (const auto& [j, c] : combination) sum += abs(c);
  return sum + rest / unit;
}

Vector unit_vector(int n, int k, const Rational& length) {
  Vector result(std::size_t(n), 0);
  result[std::size_t(k)] = length;
  return result;
}

class PolytopeSearch {
 public:
  PolytopeSearch(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits, const Stop& stop)
      : family_(family), bound_(bound), limits_(limits), stop_(stop), n_(family_size(family)), oracle_(n_) {
    // R' = R (1 - 2^-k) leaves room for remainders.
    inner_bound_ = bound * (1 - Rational(1, Integer(1) << unsigned(std::max(limits.precision - 26, 8))));
    for (const RationalMatrix& b : scaled(family, 1 / inner_bound_)) approx_family_.push_back(approx_matrix(b));
    images_.resize(family.size());
  }

  std::optional<Polytope> run() {
    for (const LeadingWord& word : approx_leading_words(family_, {12, 60}, 1e-9, stop_)) add_start(leading_vector(word.word));
    if (vectors_.empty()) add_start(Eigen::VectorXd::Unit(n_, 0));
    if (!close()) return std::nullopt;
    if (const std::optional<double> reach = unit_reach()) return finish(*reach);
    // The orbit does not span the space (over R or C the family is reducible): small unit vectors take part.
    for (int k = 0; k < n_; ++k) add_start(Eigen::VectorXd::Unit(n_, k) / 64);
    if (!close()) return std::nullopt;
    if (const std::optional<double> reach = unit_reach()) return finish(*reach);
    return std::nullopt;
  }

 private:
  /// (Real part of) an eigenvector of the product of the word, of greatest modulus.
  Eigen::VectorXd leading_vector(const Word& word) const {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(approx_product(approx_family_, word));
    Eigen::Index best = 0;
    solver.eigenvalues().cwiseAbs().maxCoeff(&best);
    Eigen::VectorXd v = solver.eigenvectors().col(best).real();
    return v / v.cwiseAbs().maxCoeff();
  }

  void add_start(const Eigen::VectorXd& v) {
    if (!v.allFinite() || v.cwiseAbs().maxCoeff() == 0 || oracle_.combine(v).norm <= 1) return;
    Vector exact;
    for (Eigen::Index i = 0; i < v.size(); ++i) exact.push_back(rounded(v(i), limits_.precision));
    add_vector(std::move(exact));
  }

  void add_vector(Vector exact) {
    oracle_.add(approx_vector(exact));
    vectors_.push_back(std::move(exact));
    for (auto& of_matrix : images_) of_matrix.emplace_back();
  }

  struct Candidate {
    double norm;
    std::size_t matrix, index;
  };

  /// Adds images until all are inside: generation after generation, the farthest first.
  bool close() {
    while (expanded_ < vectors_.size()) {
      std::vector<Candidate> outside;
      for (; expanded_ < vectors_.size(); ++expanded_) {
        for (std::size_t e = 0; e < family_.size(); ++e) {
          if (const double norm = try_inside(e, expanded_); norm > 1) outside.push_back({norm, e, expanded_});
        }
      }
      std::stable_sort(outside.begin(), outside.end(), [](const Candidate& a, const Candidate& b) { return a.norm > b.norm; });
      for (const Candidate& candidate : outside) {
        const auto [norm, e, i] = candidate;
        if (try_inside(e, i) <= 1) continue;
        if (vectors_.size() >= limits_.max_vectors) return false;
        Vector image = family_[e] * vectors_[i];
        for (Rational& x : image) x = rounded(x / inner_bound_, limits_.precision);
        add_vector(std::move(image));
        images_[e][i] = {1, {{int(vectors_.size()) - 1, 1.0}}};
        if (!(oracle_.vector(vectors_.size() - 1).cwiseAbs().maxCoeff() < 1e12)) return false;
      }
    }
    return true;
  }

  double try_inside(std::size_t e, std::size_t i) {
    if (++programs_ % 16 == 0) stop_.check();
    const Eigen::VectorXd image = approx_family_[e] * oracle_.vector(i);
    if (image.cwiseAbs().maxCoeff() < std::ldexp(1.0, -limits_.precision)) return 0;
    ApproxCombination combination = oracle_.combine(image);
    if (combination.norm <= 1) images_[e][i] = combination;
    return combination.norm;
  }

  /// Some unit with B_e (unit e_k) / R' well inside, if the vectors span the space.
  std::optional<double> unit_reach() {
    double greatest = 0;
    for (const Eigen::MatrixXd& b : approx_family_) {
      for (int k = 0; k < n_; ++k) greatest = std::max(greatest, oracle_.combine(b.col(k)).norm);
    }
    for (int k = 0; k < n_; ++k) {
      if (!std::isfinite(oracle_.combine(Eigen::VectorXd::Unit(n_, k)).norm)) return std::nullopt;
    }
    if (!std::isfinite(greatest)) return std::nullopt;
    return greatest == 0 ? 1 : std::min(1.0, 0.5 / greatest);
  }

  std::optional<Polytope> finish(double reach) {
    Polytope result;
    result.unit = Rational(std::exp2(std::floor(std::log2(reach))));
    result.vectors = vectors_;
    result.images.resize(family_.size());
    for (std::size_t e = 0; e < family_.size(); ++e) {
      for (std::size_t i = 0; i < vectors_.size(); ++i) {
        std::optional<SparseCombination> exact = make_exact(e, vectors_[i], images_[e][i], result.unit);
        if (!exact) return std::nullopt;
        result.images[e].push_back(std::move(*exact));
      }
      for (int k = 0; k < n_; ++k) {
        const ApproxCombination image = oracle_.combine(approx_family_[e].col(k) * approx_double(result.unit));
        std::optional<SparseCombination> exact = make_exact(e, unit_vector(n_, k, result.unit), image, result.unit);
        if (!exact) return std::nullopt;
        result.images[e].push_back(std::move(*exact));
      }
    }
    return result;
  }

  /// Rounds the coefficients as coarsely as the bound allows; a step of exact refinement where double is not enough.
  std::optional<SparseCombination> make_exact(std::size_t e, const Vector& x, const ApproxCombination& approx, const Rational& unit) {
    SparseCombination result;
    for (const int bits : {12, 20, 30, 45}) {
      result.clear();
      for (const auto& [j, c] : approx.terms) {
        // The coefficient 1 of a vector that was made as this image belongs to R' exactly.
        Rational exact = approx.terms.size() == 1 && c == 1 ? inner_bound_ : rounded(Rational(c) * inner_bound_, bits);
        if (exact != 0) result.emplace_back(j, std::move(exact));
      }
      if (combination_norm(family_[e], x, result, vectors_, unit) <= bound_) return result;
    }
    std::vector<int> indices;
    for (const auto& [j, c] : result) indices.push_back(j);
    for (int step = 0; step < 3 && !indices.empty(); ++step) {
      const ApproxCombination correction =
          oracle_.solve(indices, approx_vector(remainder(family_[e], x, result, vectors_)));
      for (std::size_t k = 0; k < correction.terms.size(); ++k)
        result[k].second += rounded(correction.terms[k].second, limits_.precision + 16);
      if (combination_norm(family_[e], x, result, vectors_, unit) <= bound_) return result;
    }
    return std::nullopt;
  }

  const MatrixFamily& family_;
  const Rational bound_;
  Rational inner_bound_;
  const PolytopeLimits& limits_;
  const Stop& stop_;
  int n_;
  std::vector<Eigen::MatrixXd> approx_family_;   // B_e / R'
  HullOracle oracle_;
  std::vector<Vector> vectors_;
  std::vector<std::vector<ApproxCombination>> images_;   // of B_e v_i / R'
  std::size_t expanded_ = 0, programs_ = 0;
};

}  // namespace

Rational exact_polytope_bound(const Polytope& polytope, const MatrixFamily& family) {
  const int n = family_size(family);
  if (polytope.unit <= 0) throw DomainError("a polytope norm needs a positive unit");
  Rational result = 0;
  for (std::size_t e = 0; e < family.size(); ++e) {
    for (std::size_t i = 0; i < polytope.vectors.size() + std::size_t(n); ++i) {
      const bool is_vector = i < polytope.vectors.size();
      const Vector x = is_vector ? polytope.vectors[i] : unit_vector(n, int(i - polytope.vectors.size()), polytope.unit);
      result = std::max(result, combination_norm(family[e], x, polytope.images.at(e).at(i), polytope.vectors, polytope.unit));
    }
  }
  return result;
}

std::optional<PolytopeNorm> find_polytope(const BlockTriangularForm& form, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop) {
  if (bound <= 0) throw DomainError("find_polytope: the bound is not positive");
  PolytopeNorm result{bound, form, {}};
  for (std::size_t k = 0; k < form.sizes.size(); ++k) {
    const MatrixFamily family = form.diagonal_block(k);
    std::optional<Polytope> polytope = PolytopeSearch(family, bound, limits, stop).run();
    if (!polytope) return std::nullopt;
    if (exact_polytope_bound(*polytope, family) > bound) throw InternalError("find_polytope: the bound does not hold");
    result.blocks.push_back(std::move(*polytope));
  }
  return result;
}

std::optional<PolytopeNorm> find_polytope(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop) {
  return find_polytope(block_triangular_form(family), bound, limits, stop);
}

}  // namespace limes
