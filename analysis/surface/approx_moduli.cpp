#include "analysis/surface/approx_moduli.hpp"

#include "analysis/eigen_impl.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace limes {

ApproxBlock::ApproxBlock(const VertexBlock& block) : size_(block.size()) {
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) {
      const LaurentPolynomial& entry = block(i, j);
      for (int k = 0; k < entry.length(); ++k) {
        const RationalFunction& c = entry.coefficients()[static_cast<std::size_t>(k)];
        if (!c.is_zero()) entries_.push_back({i, j, entry.lowest() + k, c.constant_value().convert_to<double>()});
      }
    }
  }
}

std::vector<double> ApproxBlock::moduli(double c) const {
  const double angle = std::acos(c);
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(size_, size_);
  for (const Entry& e : entries_) matrix(e.row, e.column) += std::polar(std::abs(e.weight), angle * e.exponent) * (e.weight < 0 ? -1.0 : 1.0);
  const Eigen::VectorXcd values = approx_eigenvalues(matrix);
  std::vector<double> result;
  for (Eigen::Index k = 0; k < values.size(); ++k) result.push_back(std::abs(values(k)));
  std::sort(result.rbegin(), result.rend());
  return result;
}

}  // namespace limes
