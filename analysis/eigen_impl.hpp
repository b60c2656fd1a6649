// Eigen inside of analysis/: floating-point pictures of exact matrices, their eigenvalues. Included by sources only.
#pragma once

#include "analysis/spectral_radius/matrix_family.hpp"

#include <Eigen/Core>

namespace limes {

inline Eigen::MatrixXd approx_matrix(const RationalMatrix& a) {
  Eigen::MatrixXd result(a.rows(), a.columns());
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) result(i, j) = approx_double(a(i, j));
  }
  return result;
}

inline Eigen::VectorXd approx_vector(const std::vector<Rational>& x) {
  Eigen::VectorXd result{Eigen::Index(x.size())};
  for (std::size_t i = 0; i < x.size(); ++i) result(Eigen::Index(i)) = approx_double(x[i]);
  return result;
}

inline Eigen::MatrixXd approx_product(const std::vector<Eigen::MatrixXd>& family, const Word& word) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(family.front().rows(), family.front().cols());
  for (const int letter : word) result = result * family[std::size_t(letter)];
  return result;
}

// Eigenvalues of square matrices of finite entries; functions, because every source that instantiates Eigen's solvers takes ten seconds to compile.
struct ApproxEigenpairs {
  Eigen::VectorXcd values;
  /// Column k belongs to values(k).
  Eigen::MatrixXcd vectors;
};
ApproxEigenpairs approx_eigenpairs(const Eigen::MatrixXd& a);
Eigen::VectorXcd approx_eigenvalues(const Eigen::MatrixXd& a);
Eigen::VectorXcd approx_eigenvalues(const Eigen::MatrixXcd& a);
/// 0 for a matrix without entries.
double approx_spectral_radius(const Eigen::MatrixXd& a);

}  // namespace limes
