#include "analysis/approx_radius.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace limes {
namespace {

double greatest_modulus(const Eigen::MatrixXd& matrix) {
  return matrix.size() == 0 ? 0 : Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

double approx_spectral_radius(const RationalMatrix& a) {
  Eigen::MatrixXd matrix(a.rows(), a.columns());
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) matrix(i, j) = approx_double(a(i, j));
  }
  return greatest_modulus(matrix);
}

double approx_greatest_root(const Polynomial& a) {
  const int n = a.degree();
  if (n < 1) return 0;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    companion(i, n - 1) = -approx_double(a.coefficient(i) / a.leading_coefficient());
    if (i > 0) companion(i, i - 1) = 1;
  }
  return greatest_modulus(companion);
}

}  // namespace limes
