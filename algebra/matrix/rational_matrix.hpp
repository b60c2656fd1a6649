#pragma once

#include "algebra/number/rational.hpp"
#include "algebra/polynomial/polynomial.hpp"

#include <vector>

namespace limes {

/// A dense matrix over Q, row by row.
class RationalMatrix {
 public:
  RationalMatrix() = default;
  RationalMatrix(int rows, int columns) : rows_(rows), columns_(columns), entries_(std::size_t(rows) * columns) {}
  static RationalMatrix identity(int size);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  Rational& operator()(int i, int j) { return entries_[std::size_t(i) * columns_ + j]; }
  const Rational& operator()(int i, int j) const { return entries_[std::size_t(i) * columns_ + j]; }
  friend bool operator==(const RationalMatrix&, const RationalMatrix&) = default;

 private:
  int rows_ = 0;
  int columns_ = 0;
  std::vector<Rational> entries_;
};

/// \throws DomainError when the shapes do not match.
RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b);
std::vector<Rational> operator*(const RationalMatrix& a, const std::vector<Rational>& x);
/// det(lambda I - a), monic of degree n. \pre a is square
Polynomial characteristic_polynomial(const RationalMatrix& a);
int rank(const RationalMatrix& a);

}  // namespace limes
