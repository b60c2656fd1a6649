// Eigen inside of analysis/spectral_radius: floating-point pictures of exact families. Included by sources only.
#pragma once

#include "analysis/spectral_radius/matrix_family.hpp"

#include <Eigen/Dense>

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

}  // namespace limes
