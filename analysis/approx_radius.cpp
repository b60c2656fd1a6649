#include "analysis/approx_radius.hpp"

#include "analysis/eigen_impl.hpp"

namespace limes {

double approx_spectral_radius(const RationalMatrix& a) { return approx_spectral_radius(approx_matrix(a)); }

double approx_greatest_root(const Polynomial& a) {
  const int n = a.degree();
  if (n < 1) return 0;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    companion(i, n - 1) = -approx_double(a.coefficient(i) / a.leading_coefficient());
    if (i > 0) companion(i, i - 1) = 1;
  }
  return approx_spectral_radius(companion);
}

}  // namespace limes
