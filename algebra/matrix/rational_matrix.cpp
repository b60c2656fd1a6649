#include "algebra/matrix/rational_matrix.hpp"

#include "algebra/error.hpp"
#include "algebra/number/flint_conversion.hpp"

#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>

#include <fmt/format.h>

namespace limes {

namespace {

// The least D > 0 with D a integer.
Integer common_denominator(const RationalMatrix& a) {
  Integer result = 1;
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) {
      if (const Integer d = denominator(a(i, j)); d != 1) result = lcm(result, d);
    }
  }
  return result;
}

// D a as a FLINT matrix.
class IntegerMatrix {
 public:
  IntegerMatrix(const RationalMatrix& a, const Integer& common) {
    fmpz_mat_init(value, a.rows(), a.columns());
    for (int i = 0; i < a.rows(); ++i) {
      for (int j = 0; j < a.columns(); ++j)
        to_fmpz(fmpz_mat_entry(value, i, j), numerator(a(i, j)) * (common / denominator(a(i, j))));
    }
  }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;
  ~IntegerMatrix() { fmpz_mat_clear(value); }

  fmpz_mat_t value;
};

}  // namespace

RationalMatrix RationalMatrix::identity(int size) {
  RationalMatrix result(size, size);
  for (int i = 0; i < size; ++i) result(i, i) = 1;
  return result;
}

RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b) {
  if (a.columns() != b.rows()) {
    throw DomainError(fmt::format("a {} x {} matrix was multiplied by a {} x {} matrix", a.rows(), a.columns(),
                                  b.rows(), b.columns()));
  }
  RationalMatrix result(a.rows(), b.columns());
  for (int i = 0; i < a.rows(); ++i) {
    for (int k = 0; k < a.columns(); ++k) {
      const Rational& factor = a(i, k);
      if (factor == 0) continue;
      for (int j = 0; j < b.columns(); ++j) result(i, j) += factor * b(k, j);
    }
  }
  return result;
}

std::vector<Rational> operator*(const RationalMatrix& a, const std::vector<Rational>& x) {
  if (std::size_t(a.columns()) != x.size()) {
    throw DomainError(
        fmt::format("a {} x {} matrix was multiplied by a vector of length {}", a.rows(), a.columns(), x.size()));
  }
  std::vector<Rational> result(std::size_t(a.rows()));
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) {
      if (a(i, j) != 0) result[std::size_t(i)] += a(i, j) * x[std::size_t(j)];
    }
  }
  return result;
}

Polynomial characteristic_polynomial(const RationalMatrix& a) {
  if (a.rows() != a.columns()) {
    throw DomainError(
        fmt::format("the characteristic polynomial of a {} x {} matrix was asked for", a.rows(), a.columns()));
  }
  const int n = a.rows();
  const Integer common = common_denominator(a);
  const IntegerMatrix scaled(a, common);
  fmpz_poly_t chi;
  fmpz_poly_init(chi);
  fmpz_mat_charpoly(chi, scaled.value);
  // det(lambda I - a) = D^{-n} chi(D lambda): element k is divided by D^{n-k}.
  std::vector<Rational> coefficients(std::size_t(n) + 1);
  Integer divisor = 1;
  for (int k = n; k >= 0; --k, divisor *= common)
    coefficients[std::size_t(k)] = Rational(from_fmpz(fmpz_poly_get_coeff_ptr(chi, k)), divisor);
  fmpz_poly_clear(chi);
  return Polynomial(coefficients);
}

int rank(const RationalMatrix& a) { return int(fmpz_mat_rank(IntegerMatrix(a, common_denominator(a)).value)); }

}  // namespace limes
