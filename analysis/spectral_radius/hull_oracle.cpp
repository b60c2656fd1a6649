#include "analysis/spectral_radius/hull_oracle_impl.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <glpk.h>

#include <cmath>
#include <limits>
#include <tuple>

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

Eigen::VectorXd HullOracle::column_vector(const Column& column) const {
  Eigen::VectorXd v = vectors_[std::size_t(column.index)];
  if (column.conjugate) v.tail(dimension_ / 2) *= -1;
  return times(column.direction, v, complex_);
}

void HullOracle::append(const Column& column) {
  const Eigen::VectorXd w = whitening_ * column_vector(column);
  std::vector<int> rows(std::size_t(dimension_) + 1);
  std::vector<double> values(std::size_t(dimension_) + 1);
  int count = 0;
  for (int i = 0; i < dimension_; ++i) {
    if (w(i) == 0) continue;
    rows[std::size_t(++count)] = i + 1;
    values[std::size_t(count)] = w(i);
  }
  const int number = glp_add_cols(program_->lp, 1);
  glp_set_col_bnds(program_->lp, number, GLP_LO, 0, 0);
  glp_set_obj_coef(program_->lp, number, 1);
  glp_set_mat_col(program_->lp, number, count, rows.data(), values.data());
  columns_.push_back(column);
}

/// Complex vectors have infinitely many multiples: append_violated() takes those that a program asks for.
void HullOracle::append_directions(int index) {
  if (complex_) return;
  for (const double sign : {1.0, -1.0}) append({index, false, sign});
}

/// Whether the last solution has slack: the columns, so far, do not represent the right side.
bool HullOracle::leaves_span() const {
  for (int k = 1; k <= 2 * dimension_; ++k) {
    if (glp_get_col_prim(program_->lp, k) > 1e-7) return true;
  }
  return false;
}

/// Programs with few columns are fast: drops those that are not in the last basis, which stays what it is.
void HullOracle::forget_columns() {
  glp_prob* lp = program_->lp;
  std::vector<int> dropped{0};
  std::vector<Column> kept;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const int number = 2 * dimension_ + int(k) + 1;
    if (glp_get_col_stat(lp, number) == GLP_BS)
      kept.push_back(columns_[k]);
    else
      dropped.push_back(number);
  }
  if (dropped.size() > 1) glp_del_cols(lp, int(dropped.size()) - 1, dropped.data());
  columns_ = std::move(kept);
}

void HullOracle::rebuild() {
  if (vectors_.size() >= std::size_t(dimension_)) {
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(dimension_, dimension_);
    for (std::size_t j = 0; j < vectors_.size(); ++j) {
      for (const std::complex<double> direction : {std::complex<double>(1, 0), std::complex<double>(0, 1)}) {
        if (!complex_ && direction.imag() != 0) continue;
        const Eigen::VectorXd v = column_vector({int(j), false, direction});
        spread += v * v.transpose();
      }
    }
    spread /= double(vectors_.size());
    const Eigen::LLT<Eigen::MatrixXd> root(spread);
    const Eigen::MatrixXd candidate = root.matrixL().solve(Eigen::MatrixXd::Identity(dimension_, dimension_));
    if (root.info() == Eigen::Success && candidate.allFinite() && candidate.norm() < 1e6 * spread.norm()) whitening_ = candidate;
  }
  program_ = std::make_unique<Program>();
  columns_.clear();
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
  for (std::size_t j = 0; j < vectors_.size(); ++j) append_directions(int(j));
  glp_std_basis(lp);
}

void HullOracle::add(const Eigen::VectorXd& v) {
  vectors_.push_back(v);
  if (vectors_.size() == next_rebuild_) {
    next_rebuild_ *= 4;
    rebuild();
  } else {
    append_directions(int(vectors_.size()) - 1);
  }
}

/// \param primal after new columns; otherwise after a new right side
bool HullOracle::solve(bool primal) {
  glp_prob* lp = program_->lp;
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = primal ? GLP_PRIMAL : GLP_DUALP;
  options.tol_bnd = 1e-9;
  options.tol_dj = 1e-9;
  options.it_lim = 20000;
  if (glp_simplex(lp, &options) == 0 && glp_get_status(lp) == GLP_OPT) return true;
  glp_std_basis(lp);
  options.meth = GLP_PRIMAL;
  return glp_simplex(lp, &options) == 0 && glp_get_status(lp) == GLP_OPT;
}

/// Adds, for vectors whose multiples are not well represented by the directions so far, the direction in which the dual solution
/// violates |<y, z v>| <= 1 most. False when there is none, or when the dual bound shows the least norm to be above `enough`.
bool HullOracle::append_violated(double value, double enough) {
  Eigen::VectorXd y(dimension_);
  for (int i = 0; i < dimension_; ++i) y(i) = glp_get_row_dual(program_->lp, i + 1);
  const Eigen::VectorXd functional = whitening_.transpose() * y;
  const Eigen::Index half = dimension_ / 2;
  std::vector<std::pair<double, Column>> violated;
  double greatest = 1;
  for (std::size_t j = 0; j < vectors_.size(); ++j) {
    const Eigen::VectorXd& v = vectors_[j];
    const double a = functional.head(half).dot(v.head(half)), b = functional.tail(half).dot(v.tail(half));
    const double c = functional.head(half).dot(v.tail(half)), d = functional.tail(half).dot(v.head(half));
    // <y, v> and <y, i v>; the same for conj(v).
    for (const auto& [conjugate, along, across] : {std::tuple(false, a + b, d - c), std::tuple(true, a - b, d + c)}) {
      const double size = std::hypot(along, across);
      greatest = std::max(greatest, size);
      if (size > 1 + 1e-8) violated.push_back({size, {int(j), conjugate, std::complex<double>(along, across) / size}});
    }
  }
  if (violated.empty() || value > greatest * enough * (1 + 1e-9)) return false;
  std::stable_sort(violated.begin(), violated.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t k = 0; k < std::min(violated.size(), std::size_t(dimension_)); ++k) append(violated[k].second);
  return true;
}

ApproxCombination HullOracle::combine(const Eigen::VectorXd& x, double enough) {
  const Eigen::VectorXd w = whitening_ * x;
  const double scale = w.cwiseAbs().maxCoeff();
  if (scale == 0) return {};
  if (!std::isfinite(scale)) return {infinity, {}};
  if (complex_ && columns_.size() > 16 * std::size_t(dimension_)) forget_columns();
  glp_prob* lp = program_->lp;
  for (int i = 0; i < dimension_; ++i) glp_set_row_bnds(lp, i + 1, GLP_FX, w(i) / scale, w(i) / scale);
  for (int round = 0;; ++round) {
    if (!solve(round > 0)) return {infinity, {}};
    if (!complex_ || round == 40) break;
    const double value = glp_get_obj_val(lp) * scale;
    if ((value <= enough && !leaves_span()) || !append_violated(value, enough)) break;
  }
  if (leaves_span()) return {infinity, {}};
  std::map<std::pair<int, bool>, std::complex<double>> sums;
  for (int k = 1; k <= dimension_; ++k) {
    const int variable = glp_get_bhead(lp, k) - dimension_;  // rows first, then columns
    if (variable < 1) continue;
    const double t = glp_get_col_prim(lp, variable);
    if (variable > 2 * dimension_ && t > 1e-12) {
      const Column& column = columns_[std::size_t(variable - 2 * dimension_ - 1)];
      sums[{column.index, column.conjugate}] += t * scale * column.direction;
    }
  }
  ApproxCombination result;
  Eigen::VectorXd rest = x;
  for (const auto& [key, c] : sums) {
    result.terms.push_back({key.first, key.second, c});
    rest -= column_vector({key.first, key.second, c});
  }
  correct(result, rest);
  rest = whitening_ * x;
  for (const ApproxTerm& term : result.terms) rest -= whitening_ * column_vector({term.index, term.conjugate, term.c});
  if (!std::isfinite(result.norm) || !(rest.cwiseAbs().maxCoeff() <= 1e-9 * scale)) return {infinity, {}};
  return result;
}

void HullOracle::correct(ApproxCombination& combination, const Eigen::VectorXd& x) const {
  const Eigen::Index parts = complex_ ? 2 : 1;
  if (!combination.terms.empty()) {
    Eigen::MatrixXd columns(dimension_, parts * Eigen::Index(combination.terms.size()));
    for (std::size_t k = 0; k < combination.terms.size(); ++k) {
      const ApproxTerm& term = combination.terms[k];
      for (Eigen::Index part = 0; part < parts; ++part) {
        const std::complex<double> direction = part == 0 ? std::complex<double>(1, 0) : std::complex<double>(0, 1);
        columns.col(parts * Eigen::Index(k) + part) = whitening_ * column_vector({term.index, term.conjugate, direction});
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
