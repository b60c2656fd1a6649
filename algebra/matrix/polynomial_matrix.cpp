#include "algebra/matrix/polynomial_matrix.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace limes {

namespace {

// Element k: the greatest sum of k of the numbers.
std::vector<int> greatest_sums(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end(), std::greater<>());
  std::vector<int> sums{0};
  for (const int number : numbers) sums.push_back(sums.back() + number);
  return sums;
}

// Element k bounds the degree in x_index of the coefficient of lambda^{n-k}, a sum of k x k principal minors: each
// product in a minor takes one entry from each of k rows, and from each of k columns.
std::vector<int> degree_bounds(const PolynomialMatrix& a, int index) {
  const int n = a.rows();
  std::vector<int> rows(std::size_t(n), 0);
  std::vector<int> columns(std::size_t(n), 0);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int degree = a(i, j).degree(index);
      rows[std::size_t(i)] = std::max(rows[std::size_t(i)], degree);
      columns[std::size_t(j)] = std::max(columns[std::size_t(j)], degree);
    }
  }
  std::vector<int> result = greatest_sums(rows);
  const std::vector<int> by_columns = greatest_sums(columns);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = std::min(result[k], by_columns[k]);
  return result;
}

// 0, 1, -1, 2, -2, ...: a lower degree is interpolated on the first points alone.
Rational grid_point(int i) { return i % 2 != 0 ? (i + 1) / 2 : -(i / 2); }

// Values at grid_point(0), .., grid_point(m) become the coefficients of the interpolant, in place. The values are
// values[0], values[stride], ...
void interpolate(Rational* values, int count, std::size_t stride) {
  const auto at = [&](int i) -> Rational& { return values[std::size_t(i) * stride]; };
  for (int order = 1; order < count; ++order) {
    for (int i = count - 1; i >= order; --i) at(i) = (at(i) - at(i - 1)) / (grid_point(i) - grid_point(i - order));
  }
  // From Newton's form to powers of x by Horner's scheme: multiply by (x - point_k), add the next coefficient.
  for (int k = count - 2; k >= 0; --k) {
    const Rational point = grid_point(k);
    for (int i = k; i + 1 < count; ++i) at(i) -= point * at(i + 1);
  }
}

// A point of a tensor grid with `sizes` points per axis, last axis fastest. advance() returns false after the last one.
bool advance(std::vector<int>& position, const std::vector<int>& sizes) {
  for (std::size_t axis = sizes.size(); axis-- > 0;) {
    if (++position[axis] < sizes[axis]) return true;
    position[axis] = 0;
  }
  return false;
}

std::size_t volume(const std::vector<int>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t(1),
                         [](std::size_t v, int size) { return v * std::size_t(size); });
}

// The polynomial with the given values on a tensor grid.
MultivariatePolynomial interpolant(std::vector<Rational> values, const std::vector<int>& sizes) {
  const int variables = int(sizes.size());
  std::size_t stride = 1;
  for (std::size_t axis = sizes.size(); axis-- > 0;) {
    const std::size_t block = stride * std::size_t(sizes[axis]);
    for (std::size_t start = 0; start < values.size(); start += block) {
      for (std::size_t offset = 0; offset < stride; ++offset) interpolate(&values[start + offset], sizes[axis], stride);
    }
    stride = block;
  }
  std::vector<MultivariatePolynomial::Term> terms;
  std::vector<int> exponents(sizes.size(), 0);
  for (const auto& value : values) {
    if (value != 0) terms.push_back({exponents, value});
    advance(exponents, sizes);
  }
  return MultivariatePolynomial::from_terms(variables, terms);
}

}  // namespace

PolynomialMatrix::PolynomialMatrix(int variables, int rows, int columns)
    : variables_(variables),
      rows_(rows),
      columns_(columns),
      entries_(std::size_t(rows) * std::size_t(columns), MultivariatePolynomial(variables)) {}

PolynomialMatrix PolynomialMatrix::identity(int variables, int size) {
  PolynomialMatrix result(variables, size, size);
  for (int i = 0; i < size; ++i) result(i, i) = MultivariatePolynomial::constant(variables, 1);
  return result;
}

RationalMatrix PolynomialMatrix::at(std::span<const Rational> point) const {
  RationalMatrix result(rows_, columns_);
  for (int i = 0; i < rows_; ++i) {
    for (int j = 0; j < columns_; ++j) {
      if (!(*this)(i, j).is_zero()) result(i, j) = (*this)(i, j)(point);
    }
  }
  return result;
}

PolynomialMatrix operator*(const PolynomialMatrix& a, const PolynomialMatrix& b) {
  if (a.columns() != b.rows() || a.variables() != b.variables()) {
    throw DomainError(fmt::format("a {} x {} matrix in {} variables was multiplied by a {} x {} matrix in {} variables",
                                  a.rows(), a.columns(), a.variables(), b.rows(), b.columns(), b.variables()));
  }
  PolynomialMatrix result(a.variables(), a.rows(), b.columns());
  for (int i = 0; i < a.rows(); ++i) {
    for (int k = 0; k < a.columns(); ++k) {
      if (a(i, k).is_zero()) continue;
      for (int j = 0; j < b.columns(); ++j) {
        if (!b(k, j).is_zero()) result(i, j) += a(i, k) * b(k, j);
      }
    }
  }
  return result;
}

std::vector<MultivariatePolynomial> characteristic_polynomial(const PolynomialMatrix& a, const Stop& stop) {
  if (a.rows() != a.columns()) {
    throw DomainError(
        fmt::format("the characteristic polynomial of a {} x {} matrix was asked for", a.rows(), a.columns()));
  }
  const int n = a.rows();
  const int variables = a.variables();
  std::vector<std::vector<int>> bounds;
  for (int index = 0; index < variables; ++index) bounds.push_back(degree_bounds(a, index));
  // sizes[k]: the grid for the coefficient of lambda^{n-k}; they grow with k, and each is a corner of the next.
  std::vector<std::vector<int>> sizes(std::size_t(n) + 1);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    for (const auto& bound : bounds) sizes[k].push_back(bound[k] + 1);
  }

  double all_values = 0;
  for (const auto& size : sizes) {
    double product = 1;
    for (const int k : size) product *= k;
    all_values += product;
  }
  if (all_values > 1e7) throw LimitError("a characteristic polynomial of more than 10^7 grid points");
  std::vector<std::vector<Rational>> values(std::size_t(n) + 1);
  for (std::size_t k = 0; k < values.size(); ++k) values[k].reserve(volume(sizes[k]));
  std::vector<int> position(std::size_t(variables), 0);
  do {
    stop.check();
    std::vector<Rational> point;
    for (const int i : position) point.push_back(grid_point(i));
    const Polynomial chi = characteristic_polynomial(a.at(point));
    for (std::size_t k = 0; k < values.size(); ++k) {
      // The order of the large grid, restricted to a corner, is the order of the small one.
      const bool inside = std::equal(position.begin(), position.end(), sizes[k].begin(), std::less<>());
      if (inside) values[k].push_back(chi.coefficient(n - int(k)));
    }
  } while (advance(position, sizes.back()));

  std::vector<MultivariatePolynomial> result;
  for (std::size_t k = values.size(); k-- > 0;) result.push_back(interpolant(std::move(values[k]), sizes[k]));
  return result;
}

}  // namespace limes
