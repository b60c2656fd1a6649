#include "analysis/nonuniform/polynomial_determinant.hpp"

#include "algebra/error.hpp"
#include "algebra/number/flint_conversion.hpp"

#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

namespace limes {

namespace {

class IntegerVector {
 public:
  explicit IntegerVector(std::size_t size = 0) : size_(size), data_(_fmpz_vec_init(slong(size))) {}
  IntegerVector(IntegerVector&& other) noexcept : size_(other.size_), data_(other.data_) {
    other.size_ = 0;
    other.data_ = nullptr;
  }
  IntegerVector& operator=(IntegerVector&& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(data_, other.data_);
    return *this;
  }
  ~IntegerVector() {
    if (data_) _fmpz_vec_clear(data_, slong(size_));
  }

  std::size_t size() const { return size_; }
  fmpz* data() const { return data_; }

 private:
  std::size_t size_;
  fmpz* data_;
};

/// A dense polynomial with integer coefficients, last variable fastest; no coefficients for 0.
struct Dense {
  std::vector<int> degrees;
  IntegerVector values;
};

// 0, 1, -1, 2, -2, ...
slong grid_point(int i) { return i % 2 != 0 ? (i + 1) / 2 : -(i / 2); }

Dense dense(const MultivariatePolynomial& p, const Integer& factor) {
  Dense result{p.degrees(), IntegerVector()};
  if (p.is_zero()) return result;
  std::size_t size = 1;
  for (const int n : result.degrees) size *= std::size_t(n) + 1;
  result.values = IntegerVector(size);
  for (const auto& [exponents, coefficient] : p.terms()) {
    std::size_t index = 0;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      index = index * (std::size_t(result.degrees[i]) + 1) + std::size_t(exponents[i]);
    }
    to_fmpz(result.values.data() + index, numerator(coefficient) * (factor / denominator(coefficient)));
  }
  return result;
}

// The first variable := x, by Horner's scheme.
Dense evaluate_first(const Dense& p, slong x) {
  Dense result{{p.degrees.begin() + 1, p.degrees.end()}, IntegerVector()};
  if (p.values.size() == 0) return result;
  const std::size_t n = std::size_t(p.degrees.front());
  const std::size_t block = p.values.size() / (n + 1);
  result.values = IntegerVector(block);
  fmpz* out = result.values.data();
  _fmpz_vec_set(out, p.values.data() + n * block, slong(block));
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = 0; i < block; ++i) {
      fmpz_mul_si(out + i, out + i, x);
      fmpz_add(out + i, out + i, p.values.data() + k * block + i);
    }
  }
  return result;
}

/// Determinants at all points of the grid, last axis fastest.
class GridDeterminants {
 public:
  GridDeterminants(int size, std::vector<int> points, std::size_t volume, const Stop& stop)
      : values(volume), points_(std::move(points)), stop_(stop) {
    fmpz_mat_init(matrix_, size, size);
  }
  GridDeterminants(const GridDeterminants&) = delete;
  GridDeterminants& operator=(const GridDeterminants&) = delete;
  ~GridDeterminants() { fmpz_mat_clear(matrix_); }

  void evaluate(const std::vector<Dense>& entries, std::size_t axis = 0) {
    if (axis == points_.size()) {
      for (std::size_t k = 0; k < entries.size(); ++k) {
        if (entries[k].values.size() > 0) fmpz_set(matrix_->entries + k, entries[k].values.data());
      }
      fmpz_mat_det(values.data() + next_++, matrix_);
      return;
    }
    if (axis < 2) stop_.check();
    for (int i = 0; i < points_[axis]; ++i) {
      std::vector<Dense> at;
      at.reserve(entries.size());
      for (const Dense& entry : entries) at.push_back(evaluate_first(entry, grid_point(i)));
      evaluate(at, axis + 1);
    }
  }

  IntegerVector values;

 private:
  std::vector<int> points_;
  const Stop& stop_;
  fmpz_mat_t matrix_;
  std::size_t next_ = 0;
};

// Values at the grid points become coefficients, along one axis of a tensor.
void interpolate(IntegerVector& tensor, std::size_t stride, int count) {
  const std::size_t length = std::size_t(count);
  IntegerVector points(length), line(length);
  for (int i = 0; i < count; ++i) fmpz_set_si(points.data() + i, grid_point(i));
  fmpz_poly_t poly;
  fmpz_poly_init2(poly, count);
  for (std::size_t outer = 0; outer < tensor.size(); outer += stride * length) {
    for (std::size_t inner = 0; inner < stride; ++inner) {
      fmpz* const first = tensor.data() + outer + inner;
      for (std::size_t i = 0; i < length; ++i) fmpz_set(line.data() + i, first + i * stride);
      // The interpolant has integer coefficients, which FLINT asks for: they are those of a determinant over Z[x].
      fmpz_poly_interpolate_fmpz_vec(poly, points.data(), line.data(), count);
      for (std::size_t i = 0; i < length; ++i) fmpz_poly_get_coeff_fmpz(first + i * stride, poly, slong(i));
    }
  }
  fmpz_poly_clear(poly);
}

// The least factor that makes a row integral.
Integer row_denominator(const PolynomialMatrix& a, int row) {
  Integer result = 1;
  for (int j = 0; j < a.columns(); ++j) {
    for (const auto& term : a(row, j).terms()) result = lcm(result, denominator(term.coefficient));
  }
  return result;
}

int degree_bound(const PolynomialMatrix& a, int variable) {
  const int n = a.rows();
  std::vector<int> rows(std::size_t(n), 0), columns(std::size_t(n), 0);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int degree = a(i, j).degree(variable);
      rows[std::size_t(i)] = std::max(rows[std::size_t(i)], degree);
      columns[std::size_t(j)] = std::max(columns[std::size_t(j)], degree);
    }
  }
  int by_rows = 0, by_columns = 0;
  for (const int degree : rows) by_rows += degree;
  for (const int degree : columns) by_columns += degree;
  return std::min(by_rows, by_columns);
}

}  // namespace

MultivariatePolynomial determinant(const PolynomialMatrix& a, const Stop& stop) {
  if (a.rows() != a.columns()) throw DomainError("the determinant of a matrix that is not square");
  clean_up_flint_at_thread_exit();
  const int variables = a.variables();
  std::vector<int> points;
  std::size_t volume = 1;
  for (int k = 0; k < variables; ++k) {
    points.push_back(degree_bound(a, k) + 1);
    volume *= std::size_t(points.back());
    if (volume > 10000000) throw LimitError("a determinant of more than 10^7 grid points");
  }
  Integer scale = 1;
  std::vector<Dense> entries;
  for (int i = 0; i < a.rows(); ++i) {
    const Integer factor = row_denominator(a, i);
    scale *= factor;
    for (int j = 0; j < a.columns(); ++j) entries.push_back(dense(a(i, j), factor));
  }
  GridDeterminants grid(a.rows(), points, volume, stop);
  grid.evaluate(entries);

  std::size_t stride = 1;
  for (std::size_t axis = points.size(); axis-- > 0; stride *= std::size_t(points[axis])) {
    stop.check();
    interpolate(grid.values, stride, points[axis]);
  }
  std::vector<MultivariatePolynomial::Term> terms;
  std::vector<int> exponents(points.size(), 0);
  for (std::size_t index = 0; index < volume; ++index) {
    if (const fmpz* value = grid.values.data() + index; !fmpz_is_zero(value)) {
      terms.push_back({exponents, Rational(from_fmpz(value), scale)});
    }
    for (std::size_t axis = points.size(); axis-- > 0;) {
      if (++exponents[axis] < points[axis]) break;
      exponents[axis] = 0;
    }
  }
  return MultivariatePolynomial::from_terms(variables, terms);
}

}  // namespace limes
