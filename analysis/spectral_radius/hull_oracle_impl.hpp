// A floating-point oracle for symmetric hulls, on GLPK. Included by sources only.
#pragma once

#include "analysis/spectral_radius/eigen_impl.hpp"

#include <memory>

namespace limes {

/// x = sum_j c_j v_j, approximately.
struct ApproxCombination {
  double norm = 0;                             // sum |c_j|; infinity when no combination was found
  std::vector<std::pair<int, double>> terms;   // (j, c_j)
};

/// The hull of +-v_1 .. +-v_M in R^n, growing. Answers are hints: whoever uses them checks them exactly.
class HullOracle {
 public:
  explicit HullOracle(int n);
  ~HullOracle();
  HullOracle(const HullOracle&) = delete;
  HullOracle& operator=(const HullOracle&) = delete;

  std::size_t size() const { return vectors_.size(); }
  const Eigen::VectorXd& vector(std::size_t j) const { return vectors_[j]; }
  void add(const Eigen::VectorXd& v);
  /// A combination of about the least sum |c_j|.
  ApproxCombination combine(const Eigen::VectorXd& x);
  /// The coefficients of x for given indices j, by least squares.
  ApproxCombination solve(const std::vector<int>& indices, const Eigen::VectorXd& x) const;

 private:
  struct Program;
  void rebuild();
  void append(const Eigen::VectorXd& v);

  int n_;
  std::vector<Eigen::VectorXd> vectors_;
  Eigen::MatrixXd whitening_;      // coordinates in which the hull is round: the program's tolerances are absolute
  std::size_t next_rebuild_;
  std::unique_ptr<Program> program_;
};

}  // namespace limes
