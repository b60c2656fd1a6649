#include "analysis/spectral_radius/invariant_subspace.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/factorisation.hpp"

#include <numeric>

namespace limes {
namespace {

using Vector = std::vector<Rational>;

/// Linearly independent vectors in reduced echelon form: each has a 1 at its pivot, where all others have 0.
class EchelonBasis {
 public:
  explicit EchelonBasis(int n) : n_(n) {}
  std::size_t size() const { return vectors_.size(); }
  const std::vector<Vector>& vectors() const { return vectors_; }
  const std::vector<int>& pivots() const { return pivots_; }

  /// Adds a vector; false when it is in the span already.
  bool add(Vector x) {
    for (std::size_t k = 0; k < vectors_.size(); ++k) subtract(x, x[pivots_[k]], vectors_[k]);
    int pivot = 0;
    while (pivot < n_ && x[pivot] == 0) ++pivot;
    if (pivot == n_) return false;
    const Rational scale = 1 / x[pivot];
    for (Rational& entry : x) entry *= scale;
    for (Vector& v : vectors_) subtract(v, v[pivot], x);
    vectors_.push_back(std::move(x));
    pivots_.push_back(pivot);
    return true;
  }

 private:
  static void subtract(Vector& x, Rational factor, const Vector& y) {
    if (factor == 0) return;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (y[i] != 0) x[i] -= factor * y[i];
    }
  }

  int n_;
  std::vector<Vector> vectors_;
  std::vector<int> pivots_;
};

/// The least subspace that contains x and is invariant under the family; stops early when it is everything.
EchelonBasis spin(const MatrixFamily& family, const Vector& x) {
  const int n = family.front().rows();
  EchelonBasis basis(n);
  std::vector<Vector> queue{x};
  basis.add(x);
  while (!queue.empty() && basis.size() < std::size_t(n)) {
    const Vector y = std::move(queue.back());
    queue.pop_back();
    for (const RationalMatrix& b : family) {
      Vector image = b * y;
      if (basis.add(image)) queue.push_back(std::move(image));
    }
  }
  return basis;
}

RationalMatrix evaluate(const Polynomial& f, const RationalMatrix& a) {
  RationalMatrix result(a.rows(), a.rows());
  for (int k = f.degree(); k >= 0; --k) {
    result = result * a;
    for (int i = 0; i < a.rows(); ++i) result(i, i) += f.coefficient(k);
  }
  return result;
}

/// A basis of the kernel: the rows in echelon form give the dependent coordinates in terms of the free ones.
std::vector<Vector> kernel(const RationalMatrix& a) {
  const int n = a.columns();
  EchelonBasis rows(n);
  for (int i = 0; i < a.rows(); ++i) {
    Vector row(n);
    for (int j = 0; j < n; ++j) row[j] = a(i, j);
    rows.add(std::move(row));
  }
  std::vector<Vector> result;
  for (int j = 0; j < n; ++j) {
    if (std::find(rows.pivots().begin(), rows.pivots().end(), j) != rows.pivots().end()) continue;
    Vector x(n);
    x[j] = 1;
    for (std::size_t k = 0; k < rows.size(); ++k) x[rows.pivots()[k]] = -rows.vectors()[k][j];
    result.push_back(std::move(x));
  }
  return result;
}

RationalMatrix columns(const EchelonBasis& basis, int n) {
  std::vector<std::size_t> order(basis.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return basis.pivots()[i] < basis.pivots()[j]; });
  RationalMatrix result(n, int(basis.size()));
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (int i = 0; i < n; ++i) result(i, int(k)) = basis.vectors()[order[k]][i];
  }
  return result;
}

/// The vectors orthogonal to a subspace; invariant under the family when the subspace is invariant under the transposed one.
EchelonBasis orthogonal(const EchelonBasis& basis, int n) {
  RationalMatrix rows(int(basis.size()), n);
  for (std::size_t k = 0; k < basis.size(); ++k) {
    for (int j = 0; j < n; ++j) rows(int(k), j) = basis.vectors()[k][j];
  }
  EchelonBasis result(n);
  for (Vector& x : kernel(rows)) result.add(std::move(x));
  return result;
}

/// Small elements of the algebra that the family generates: the matrices, then sums and products of them with small coefficients.
std::vector<RationalMatrix> algebra_elements(const MatrixFamily& family) {
  std::vector<RationalMatrix> result(family.begin(), family.end());
  const std::size_t most = family.size() + 8;
  for (std::size_t k = 1; result.size() < most; ++k) {
    // A fixed sequence that mixes all matrices: sum_e c_e B_e + B_i B_j.
    RationalMatrix a = family[k % family.size()] * family[(k / family.size() + k) % family.size()];
    for (std::size_t e = 0; e < family.size(); ++e) {
      const Rational c = Rational(int((5 * k + 3 * e) % 7)) - 2;
      for (int i = 0; i < a.rows(); ++i) {
        for (int j = 0; j < a.columns(); ++j) a(i, j) += c * family[e](i, j);
      }
    }
    result.push_back(std::move(a));
  }
  return result;
}

RationalMatrix block(const RationalMatrix& a, int row, int column, int rows, int columns) {
  RationalMatrix result(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) result(i, j) = a(row + i, column + j);
  }
  return result;
}

/// diag(a, b).
RationalMatrix direct_sum(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix result(a.rows() + b.rows(), a.columns() + b.columns());
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) result(i, j) = a(i, j);
  }
  for (int i = 0; i < b.rows(); ++i) {
    for (int j = 0; j < b.columns(); ++j) result(a.rows() + i, a.columns() + j) = b(i, j);
  }
  return result;
}

/// T = [W | unit vectors off the pivots of W] and its inverse: with rows sorted by pivot and not, T = [I 0; X I].
std::pair<RationalMatrix, RationalMatrix> complete(const RationalMatrix& w) {
  const int n = w.rows(), m = w.columns();
  std::vector<int> pivots;
  for (int k = 0; k < m; ++k) {
    int i = 0;
    while (w(i, k) == 0) ++i;
    pivots.push_back(i);
  }
  std::vector<int> rest;
  for (int i = 0; i < n; ++i) {
    if (std::find(pivots.begin(), pivots.end(), i) == pivots.end()) rest.push_back(i);
  }
  RationalMatrix basis(n, n), inverse(n, n);
  for (int k = 0; k < m; ++k) {
    for (int i = 0; i < n; ++i) basis(i, k) = w(i, k);
    inverse(k, pivots[k]) = 1;
  }
  for (int r = 0; r < n - m; ++r) {
    basis(rest[r], m + r) = 1;
    inverse(m + r, rest[r]) = 1;
    for (int k = 0; k < m; ++k) inverse(m + r, pivots[k]) = -w(rest[r], k);
  }
  return {std::move(basis), std::move(inverse)};
}

}  // namespace

std::optional<RationalMatrix> find_invariant_subspace(const MatrixFamily& family) {
  const int n = family_size(family);
  if (n == 1) return std::nullopt;
  const MatrixFamily mirrored = transposed(family);
  const auto proper = [&](const EchelonBasis& basis) { return basis.size() > 0 && basis.size() < std::size_t(n); };
  for (const RationalMatrix& a : algebra_elements(family)) {
    const RationalMatrix at = transposed({a}).front();
    for (const auto& [factor, multiplicity] : irreducible_factors(characteristic_polynomial(a))) {
      const std::vector<Vector> null_space = kernel(evaluate(factor, a));
      if (const EchelonBasis w = spin(family, null_space.front()); proper(w)) return columns(w, n);
      const EchelonBasis dual = spin(mirrored, kernel(evaluate(factor, at)).front());
      if (proper(dual)) return columns(orthogonal(dual, n), n);
      // Norton: the kernel has no proper subspace that is invariant under a, so every vector of it spins to everything.
      if (null_space.size() == std::size_t(factor.degree())) return std::nullopt;
    }
  }
  return std::nullopt;
}

MatrixFamily BlockTriangularForm::diagonal_block(std::size_t k) const {
  const int first = std::accumulate(sizes.begin(), sizes.begin() + std::ptrdiff_t(k), 0);
  MatrixFamily result;
  for (const RationalMatrix& b : matrices) result.push_back(block(b, first, first, sizes[k], sizes[k]));
  return result;
}

BlockTriangularForm block_triangular_form(const MatrixFamily& family) {
  const int n = family_size(family);
  BlockTriangularForm form{RationalMatrix::identity(n), RationalMatrix::identity(n), {n}, family};
  const std::optional<RationalMatrix> w = find_invariant_subspace(family);
  if (!w) return form;
  const int m = w->columns();
  const auto [basis, inverse] = complete(*w);
  MatrixFamily top, bottom;
  for (const RationalMatrix& b : family) {
    const RationalMatrix c = inverse * b * basis;
    top.push_back(block(c, 0, 0, m, m));
    bottom.push_back(block(c, m, m, n - m, n - m));
  }
  const BlockTriangularForm upper = block_triangular_form(top), lower = block_triangular_form(bottom);
  form.basis = basis * direct_sum(upper.basis, lower.basis);
  form.inverse = direct_sum(upper.inverse, lower.inverse) * inverse;
  form.sizes = upper.sizes;
  form.sizes.insert(form.sizes.end(), lower.sizes.begin(), lower.sizes.end());
  for (RationalMatrix& b : form.matrices) b = form.inverse * b * form.basis;
  return form;
}

}  // namespace limes
