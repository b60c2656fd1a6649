#include "analysis/spectral_radius/hull_oracle_impl.hpp"

#include "analysis/spectral_radius/ellipse_hull_impl.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <glpk.h>

#include <cmath>
#include <limits>

namespace limes {
namespace {

/// Price of leaving the span of the vectors; what costs more than this counts as outside.
constexpr double penalty = 1e5;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// c z for z in C^m, stored as real and imaginary parts; real vectors only take real c.
Eigen::VectorXd times(std::complex<double> c, const Eigen::VectorXd& z, bool complex) {
  if (!complex) return c.real() * z;
  const Eigen::Index m = z.size() / 2;
  Eigen::VectorXd result(z.size());
  result.head(m) = c.real() * z.head(m) - c.imag() * z.tail(m);
  result.tail(m) = c.imag() * z.head(m) + c.real() * z.tail(m);
  return result;
}

}  // namespace

/// min sum t_k  subject to  sum_k t_k W u_k + (slack columns +- e_i, expensive) = W x,  t >= 0, the u_k being unit multiples of
/// vectors. The right side changes from call to call; the last basis stays dual feasible and the dual simplex method goes on from it.
struct HullOracle::Program {
  Program() : lp(glp_create_prob()) {}
  ~Program() { glp_delete_prob(lp); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  glp_prob* lp;
};

HullOracle::HullOracle(int n, bool complex)
    : dimension_(complex ? 2 * n : n),
      complex_(complex),
      whitening_(Eigen::MatrixXd::Identity(dimension_, dimension_)),
      next_rebuild_(std::size_t(2 * dimension_)) {
  glp_term_out(GLP_OFF);
  rebuild();
}

HullOracle::~HullOracle() = default;

/// c v_j, or c conj(v_j).
Eigen::VectorXd HullOracle::multiple(const ApproxTerm& term) const {
  Eigen::VectorXd v = vectors_[std::size_t(term.index)];
  if (term.conjugate) v.tail(dimension_ / 2) *= -1;
  return times(term.c, v, complex_);
}

void HullOracle::append(int index) {
  if (complex_) {
    const Eigen::Index last = atoms_.cols();
    atoms_.conservativeResize(dimension_, last + 4);
    for (const bool conjugate : {false, true}) {
      for (const bool turned : {false, true})
        atoms_.col(last + 2 * conjugate + turned) = whitening_ * multiple({index, conjugate, turned ? std::complex<double>(0, 1) : 1.0});
    }
    return;
  }
  const Eigen::VectorXd whitened = whitening_ * vectors_[std::size_t(index)];
  for (const double sign : {1.0, -1.0}) {
    std::vector<int> rows(std::size_t(dimension_) + 1);
    std::vector<double> values(std::size_t(dimension_) + 1);
    int count = 0;
    for (int i = 0; i < dimension_; ++i) {
      if (whitened(i) == 0) continue;
      rows[std::size_t(++count)] = i + 1;
      values[std::size_t(count)] = sign * whitened(i);
    }
    const int number = glp_add_cols(program_->lp, 1);
    glp_set_col_bnds(program_->lp, number, GLP_LO, 0, 0);
    glp_set_obj_coef(program_->lp, number, 1);
    glp_set_mat_col(program_->lp, number, count, rows.data(), values.data());
    columns_.emplace_back(index, sign);
  }
}

void HullOracle::whiten() {
  if (vectors_.size() < std::size_t(dimension_)) return;
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(dimension_, dimension_);
  for (std::size_t j = 0; j < vectors_.size(); ++j) {
    for (const std::complex<double> direction : {std::complex<double>(1, 0), std::complex<double>(0, 1)}) {
      if (!complex_ && direction.imag() != 0) continue;
      const Eigen::VectorXd v = multiple({int(j), false, direction});
      spread += v * v.transpose();
    }
  }
  spread /= double(vectors_.size());
  const Eigen::LLT<Eigen::MatrixXd> root(spread);
  const Eigen::MatrixXd candidate = root.matrixL().solve(Eigen::MatrixXd::Identity(dimension_, dimension_));
  if (root.info() == Eigen::Success && candidate.allFinite() && candidate.norm() < 1e6 * spread.norm()) whitening_ = candidate;
}

void HullOracle::rebuild() {
  whiten();
  columns_.clear();
  atoms_.resize(dimension_, 0);
  if (!complex_) {
    program_ = std::make_unique<Program>();
    glp_prob* lp = program_->lp;
    glp_set_obj_dir(lp, GLP_MIN);
    glp_add_rows(lp, dimension_);
    for (int i = 0; i < dimension_; ++i) {
      glp_set_row_bnds(lp, i + 1, GLP_FX, 0, 0);
      for (const double sign : {1.0, -1.0}) {
        const int column = glp_add_cols(lp, 1);
        const int rows[] = {0, i + 1};
        const double values[] = {0, sign};
        glp_set_col_bnds(lp, column, GLP_LO, 0, 0);
        glp_set_obj_coef(lp, column, penalty);
        glp_set_mat_col(lp, column, 1, rows, values);
      }
    }
  }
  for (std::size_t j = 0; j < vectors_.size(); ++j) append(int(j));
  if (!complex_) glp_std_basis(program_->lp);
}

void HullOracle::add(const Eigen::VectorXd& v) {
  vectors_.push_back(v);
  if (vectors_.size() == next_rebuild_) {
    next_rebuild_ *= 4;
    rebuild();
  } else {
    append(int(vectors_.size()) - 1);
  }
}

bool HullOracle::solve() {
  glp_prob* lp = program_->lp;
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = GLP_DUALP;
  options.tol_bnd = 1e-9;
  options.tol_dj = 1e-9;
  options.it_lim = 20000;
  if (glp_simplex(lp, &options) == 0 && glp_get_status(lp) == GLP_OPT) return true;
  glp_std_basis(lp);
  options.meth = GLP_PRIMAL;
  return glp_simplex(lp, &options) == 0 && glp_get_status(lp) == GLP_OPT;
}

/// Whether the sum of terms is x, as well as floating point sees.
bool HullOracle::represents(const ApproxCombination& combination, const Eigen::VectorXd& x) const {
  Eigen::VectorXd rest = whitening_ * x;
  const double scale = rest.cwiseAbs().maxCoeff();
  for (const ApproxTerm& term : combination.terms) rest -= whitening_ * multiple(term);
  return std::isfinite(combination.norm) && rest.cwiseAbs().maxCoeff() <= 1e-9 * scale;
}

ApproxCombination HullOracle::combine(const Eigen::VectorXd& x, double enough, bool best) {
  const double scale = (whitening_ * x).cwiseAbs().maxCoeff();
  if (scale == 0) return {};
  if (!std::isfinite(scale)) return {infinity, {}};
  return complex_ ? combine_complex(x, enough, best) : combine_real(x);
}

ApproxCombination HullOracle::combine_complex(const Eigen::VectorXd& x, double enough, bool best) const {
  const Eigen::VectorXd whitened = whitening_ * x;
  const bool bounded = std::isfinite(enough);
  for (const double tolerance : {1e-3, 1e-9}) {
    if (best && tolerance == 1e-3) continue;
    const EllipseCombination found = approx_ellipse_combination(atoms_, whitened, enough, tolerance);
    if (!std::isfinite(found.upper)) return {infinity, {}};
    if (found.lower > enough) return {found.lower, {}};
    double greatest = 0;
    for (const Eigen::Vector2d& c : found.terms) greatest = std::max(greatest, c.norm());
    // Few terms, as long as the others can make up for those that are left out.
    for (double least = 1e-2; least > 1e-7; least /= 10) {
      ApproxCombination result;
      Eigen::VectorXd rest = x;
      for (std::size_t j = 0; j < found.terms.size(); ++j) {
        if (found.terms[j].norm() <= least * greatest) continue;
        result.terms.push_back({int(j / 2), j % 2 == 1, {found.terms[j](0), found.terms[j](1)}});
        rest -= multiple(result.terms.back());
      }
      if (result.terms.size() > 4 * std::size_t(dimension_)) break;
      correct(result, rest);
      const double most = best ? std::min(enough, found.upper * (1 + 1e-7)) : bounded ? enough : found.upper * 1.25;
      if (result.norm <= most && represents(result, x)) return result;
    }
  }
  return {infinity, {}};
}

ApproxCombination HullOracle::combine_real(const Eigen::VectorXd& x) {
  const Eigen::VectorXd w = whitening_ * x;
  const double scale = w.cwiseAbs().maxCoeff();
  glp_prob* lp = program_->lp;
  for (int i = 0; i < dimension_; ++i) glp_set_row_bnds(lp, i + 1, GLP_FX, w(i) / scale, w(i) / scale);
  if (!solve()) return {infinity, {}};
  std::map<int, double> sums;
  for (int k = 1; k <= dimension_; ++k) {
    const int variable = glp_get_bhead(lp, k) - dimension_;  // rows first, then columns
    if (variable < 1) continue;
    const double t = glp_get_col_prim(lp, variable);
    if (variable <= 2 * dimension_) {
      if (t > 1e-7) return {infinity, {}};
    } else if (t > 1e-12) {
      const auto& [index, sign] = columns_[std::size_t(variable - 2 * dimension_ - 1)];
      sums[index] += t * scale * sign;
    }
  }
  ApproxCombination result;
  Eigen::VectorXd rest = x;
  for (const auto& [index, c] : sums) {
    result.terms.push_back({index, false, c});
    rest -= multiple(result.terms.back());
  }
  correct(result, rest);
  return represents(result, x) ? result : ApproxCombination{infinity, {}};
}

void HullOracle::correct(ApproxCombination& combination, const Eigen::VectorXd& x) const {
  const Eigen::Index parts = complex_ ? 2 : 1;
  if (!combination.terms.empty()) {
    Eigen::MatrixXd columns(dimension_, parts * Eigen::Index(combination.terms.size()));
    for (std::size_t k = 0; k < combination.terms.size(); ++k) {
      const ApproxTerm& term = combination.terms[k];
      for (Eigen::Index part = 0; part < parts; ++part) {
        const std::complex<double> direction = part == 0 ? std::complex<double>(1, 0) : std::complex<double>(0, 1);
        columns.col(parts * Eigen::Index(k) + part) = whitening_ * multiple({term.index, term.conjugate, direction});
      }
    }
    const Eigen::VectorXd c = columns.completeOrthogonalDecomposition().solve(whitening_ * x);
    for (std::size_t k = 0; k < combination.terms.size(); ++k) {
      combination.terms[k].c += c(parts * Eigen::Index(k));
      if (complex_) combination.terms[k].c += std::complex<double>(0, c(2 * Eigen::Index(k) + 1));
    }
  }
  combination.norm = 0;
  for (const ApproxTerm& term : combination.terms) combination.norm += std::abs(term.c);
}

}  // namespace limes
