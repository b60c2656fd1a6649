#include "analysis/spectral_radius/hull_oracle_impl.hpp"

#include <glpk.h>

#include <cmath>
#include <limits>

namespace limes {
namespace {

/// Price of leaving the span of the vectors; what costs more than this counts as outside.
constexpr double penalty = 1e5;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

/// min sum t_j  subject to  sum_j (t_{2j} - t_{2j+1}) W v_j + (slack columns +- e_k, expensive) = W x,  t >= 0. The right side changes from call to
/// call, so that the last basis stays dual feasible and the dual simplex method goes on from it.
struct HullOracle::Program {
  Program() : lp(glp_create_prob()) {}
  ~Program() { glp_delete_prob(lp); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  glp_prob* lp;
};

HullOracle::HullOracle(int n) : n_(n), whitening_(Eigen::MatrixXd::Identity(n, n)), next_rebuild_(std::size_t(2 * n)) {
  glp_term_out(GLP_OFF);
  rebuild();
}

HullOracle::~HullOracle() = default;

void HullOracle::append(const Eigen::VectorXd& v) {
  const Eigen::VectorXd w = whitening_ * v;
  std::vector<int> rows(std::size_t(n_) + 1);
  std::vector<double> values(std::size_t(n_) + 1);
  for (const double sign : {1.0, -1.0}) {
    int count = 0;
    for (int i = 0; i < n_; ++i) {
      if (w(i) == 0) continue;
      rows[std::size_t(++count)] = i + 1;
      values[std::size_t(count)] = sign * w(i);
    }
    const int column = glp_add_cols(program_->lp, 1);
    glp_set_col_bnds(program_->lp, column, GLP_LO, 0, 0);
    glp_set_obj_coef(program_->lp, column, 1);
    glp_set_mat_col(program_->lp, column, count, rows.data(), values.data());
  }
}

void HullOracle::rebuild() {
  if (vectors_.size() >= std::size_t(n_)) {
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(n_, n_);
    for (const Eigen::VectorXd& v : vectors_) spread += v * v.transpose();
    spread /= double(vectors_.size());
    const Eigen::LLT<Eigen::MatrixXd> root(spread);
    const Eigen::MatrixXd candidate = root.matrixL().solve(Eigen::MatrixXd::Identity(n_, n_));
    if (root.info() == Eigen::Success && candidate.allFinite() && candidate.norm() < 1e6 * spread.norm()) whitening_ = candidate;
  }
  program_ = std::make_unique<Program>();
  glp_prob* lp = program_->lp;
  glp_set_obj_dir(lp, GLP_MIN);
  glp_add_rows(lp, n_);
  for (int i = 0; i < n_; ++i) {
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
  for (const Eigen::VectorXd& v : vectors_) append(v);
  glp_std_basis(lp);
}

void HullOracle::add(const Eigen::VectorXd& v) {
  vectors_.push_back(v);
  if (vectors_.size() == next_rebuild_) {
    next_rebuild_ *= 4;
    rebuild();
  } else {
    append(v);
  }
}

ApproxCombination HullOracle::combine(const Eigen::VectorXd& x) {
  glp_prob* lp = program_->lp;
  const Eigen::VectorXd w = whitening_ * x;
  const double scale = w.cwiseAbs().maxCoeff();
  if (scale == 0) return {};
  if (!std::isfinite(scale)) return {infinity, {}};
  for (int i = 0; i < n_; ++i) glp_set_row_bnds(lp, i + 1, GLP_FX, w(i) / scale, w(i) / scale);
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = GLP_DUALP;
  options.tol_bnd = 1e-9;
  options.tol_dj = 1e-9;
  options.it_lim = 20000;
  if (glp_simplex(lp, &options) != 0 || glp_get_status(lp) != GLP_OPT) {
    glp_std_basis(lp);
    options.meth = GLP_PRIMAL;
    if (glp_simplex(lp, &options) != 0 || glp_get_status(lp) != GLP_OPT) return {infinity, {}};
  }
  std::vector<int> used;
  for (int k = 1; k <= n_; ++k) {
    // Row k's basic variable: rows first, then columns.
    const int variable = glp_get_bhead(lp, k) - n_;
    if (variable < 1) continue;
    const bool positive = glp_get_col_prim(lp, variable) > 1e-12;
    if (variable <= 2 * n_) {
      if (glp_get_col_prim(lp, variable) > 1e-7) return {infinity, {}};
    } else if (positive) {
      used.push_back((variable - 1) / 2 - n_);
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return solve(used, x);
}

ApproxCombination HullOracle::solve(const std::vector<int>& indices, const Eigen::VectorXd& x) const {
  if (indices.empty()) return {};
  Eigen::MatrixXd columns(n_, Eigen::Index(indices.size()));
  for (std::size_t k = 0; k < indices.size(); ++k) columns.col(Eigen::Index(k)) = whitening_ * vectors_[std::size_t(indices[k])];
  const Eigen::VectorXd c = columns.colPivHouseholderQr().solve(whitening_ * x);
  ApproxCombination result;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    result.norm += std::abs(c(Eigen::Index(k)));
    result.terms.emplace_back(indices[k], c(Eigen::Index(k)));
  }
  const double residual = (columns * c - whitening_ * x).cwiseAbs().maxCoeff();
  if (!std::isfinite(result.norm) || !(residual <= 1e-9 * (whitening_ * x).cwiseAbs().maxCoeff())) return {infinity, {}};
  return result;
}

}  // namespace limes
