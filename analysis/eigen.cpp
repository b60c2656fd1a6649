#include "analysis/eigen_impl.hpp"

#include <Eigen/Eigenvalues>

namespace limes {

ApproxEigenpairs approx_eigenpairs(const Eigen::MatrixXd& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd approx_eigenvalues(const Eigen::MatrixXd& a) { return Eigen::EigenSolver<Eigen::MatrixXd>(a, false).eigenvalues(); }

Eigen::VectorXcd approx_eigenvalues(const Eigen::MatrixXcd& a) {
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(a, false).eigenvalues();
}

double approx_spectral_radius(const Eigen::MatrixXd& a) {
  return a.size() == 0 ? 0 : approx_eigenvalues(a).cwiseAbs().maxCoeff();
}

}  // namespace limes
