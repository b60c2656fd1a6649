#include "analysis/spectral_radius/matrix_family.hpp"

#include "algebra/error.hpp"

namespace limes {

int family_size(const MatrixFamily& family) {
  if (family.empty()) throw DomainError("a family of matrices is empty");
  const int n = family.front().rows();
  for (const RationalMatrix& b : family) {
    if (b.rows() != n || b.columns() != n || n < 1) throw DomainError("the matrices of a family are not square of one size");
  }
  return n;
}

RationalMatrix product(const MatrixFamily& family, const Word& word) {
  RationalMatrix result = RationalMatrix::identity(family_size(family));
  for (const int letter : word) result = result * family.at(letter);
  return result;
}

MatrixFamily scaled(const MatrixFamily& family, const Rational& c) {
  MatrixFamily result = family;
  for (RationalMatrix& b : result) {
    for (int i = 0; i < b.rows(); ++i) {
      for (int j = 0; j < b.columns(); ++j) b(i, j) *= c;
    }
  }
  return result;
}

MatrixFamily transposed(const MatrixFamily& family) {
  MatrixFamily result;
  for (const RationalMatrix& b : family) {
    RationalMatrix t(b.columns(), b.rows());
    for (int i = 0; i < b.rows(); ++i) {
      for (int j = 0; j < b.columns(); ++j) t(j, i) = b(i, j);
    }
    result.push_back(std::move(t));
  }
  return result;
}

}  // namespace limes
