// A floating-point oracle for symmetric hulls: linear programs by GLPK, hulls of ellipses by an interior-point method. Included by sources only.
#pragma once

#include "analysis/eigen_impl.hpp"

#include <complex>
#include <memory>

namespace limes {

/// c v_j, or c conj(v_j).
struct ApproxTerm {
  int index = 0;
  bool conjugate = false;
  std::complex<double> c;
};

/// x = sum of terms, approximately.
struct ApproxCombination {
  double norm = 0;  // sum |c_j|; infinity when no combination was found
  std::vector<ApproxTerm> terms;
};

/// The hull of +-v_1 .. +-v_M in R^n, growing; or, complex, that of all z v_j and z conj(v_j), |z| = 1, in C^n, where vectors are real
/// ones of length 2n: real parts, then imaginary parts. Answers are hints: whoever uses them checks them exactly.
class HullOracle {
 public:
  HullOracle(int n, bool complex);
  ~HullOracle();
  HullOracle(const HullOracle&) = delete;
  HullOracle& operator=(const HullOracle&) = delete;

  std::size_t size() const { return vectors_.size(); }
  const Eigen::VectorXd& vector(std::size_t j) const { return vectors_[j]; }
  void add(const Eigen::VectorXd& v);
  /// A combination of about the least norm; the search ends with a norm <= `enough`, or once it is seen to be above. With `best`, a combination
  /// of the least norm also where it is below.
  ApproxCombination combine(const Eigen::VectorXd& x, double enough, bool best = false);
  /// Adds to the coefficients what represents x, by least squares.
  void correct(ApproxCombination& combination, const Eigen::VectorXd& x) const;

 private:
  struct Program;
  void rebuild();
  void whiten();
  void append(int index);
  bool solve();
  ApproxCombination combine_real(const Eigen::VectorXd& x);
  ApproxCombination combine_complex(const Eigen::VectorXd& x, double enough, bool best) const;
  Eigen::VectorXd multiple(const ApproxTerm& term) const;
  bool represents(const ApproxCombination& combination, const Eigen::VectorXd& x) const;

  int dimension_;
  bool complex_;
  std::vector<Eigen::VectorXd> vectors_;
  std::vector<std::pair<int, double>> columns_;   // of the linear program: +-v_j
  Eigen::MatrixXd atoms_;                         // whitened v_j, i v_j, conj(v_j), i conj(v_j), for all j
  Eigen::MatrixXd whitening_;  // coordinates in which the hull is round: the program's tolerances are absolute
  std::size_t next_rebuild_;
  std::unique_ptr<Program> program_;
};

}  // namespace limes
