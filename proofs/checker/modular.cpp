// SPDX-License-Identifier: MIT
#include "proofs/checker/modular.hpp"

#include <algorithm>

namespace limes::checker {

Modulus::Modulus(const mpz_class& p) : value_(p), p_(p.get_ui()) {
  for (int k = 0; k < 6; ++k) negative_inverse_ *= 2 - p_ * negative_inverse_;  // Newton: p^{-1} mod 2^64
  negative_inverse_ = 0 - negative_inverse_;
  const mpz_class one = (mpz_class(1) << 64) % p, square = one * one % p;
  one_ = one.get_ui();
  square_ = square.get_ui();
}

Residue Modulus::inverse(Residue x) const {
  Residue result = one_;
  for (int bit = 61; bit >= 0; --bit) {  // x^{p-2}
    result = times(result, result);
    if (((p_ - 2) >> bit & 1) != 0) result = times(result, x);
  }
  return times(result, x) == one_ ? result : 0;
}

mpz_class next_modulus(const mpz_class& previous) {
  mpz_class result;
  mpz_nextprime(result.get_mpz_t(), previous.get_mpz_t());
  return result;
}

std::vector<Residue> characteristic_polynomial(const Modulus& f, std::vector<Residue> matrix, std::size_t n) {
  const auto at = [&](std::size_t i, std::size_t j) -> Residue& { return matrix[i * n + j]; };
  // Similar to an upper Hessenberg matrix: column k-1 is cleared below row k.
  for (std::size_t k = 1; k + 1 < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && at(pivot, k - 1) == 0) ++pivot;
    if (pivot == n) continue;
    if (pivot != k) {
      for (std::size_t j = 0; j < n; ++j) std::swap(at(pivot, j), at(k, j));
      for (std::size_t i = 0; i < n; ++i) std::swap(at(i, pivot), at(i, k));
    }
    const Residue inverse = f.inverse(at(k, k - 1));
    if (inverse == 0) return {};
    for (std::size_t i = k + 1; i < n; ++i) {
      if (at(i, k - 1) == 0) continue;
      const Residue factor = f.times(at(i, k - 1), inverse);
      for (std::size_t j = k - 1; j < n; ++j) at(i, j) = f.minus(at(i, j), f.times(factor, at(k, j)));
      for (std::size_t j = 0; j < n; ++j) at(j, k) = f.plus(at(j, k), f.times(factor, at(j, i)));
    }
  }
  // det(lambda - H_m), H_m the leading blocks, by expansion along the last column.
  std::vector<std::vector<Residue>> p{{f.one()}};
  for (std::size_t m = 1; m <= n; ++m) {
    std::vector<Residue> next(m + 1, 0);
    for (std::size_t i = 0; i < m; ++i) {
      next[i + 1] = f.plus(next[i + 1], p[m - 1][i]);
      next[i] = f.minus(next[i], f.times(at(m - 1, m - 1), p[m - 1][i]));
    }
    Residue below = f.one();
    for (std::size_t k = m - 1; k-- > 0;) {
      below = f.times(below, at(k + 1, k));
      if (below == 0) break;
      const Residue factor = f.times(below, at(k, m - 1));
      for (std::size_t i = 0; factor != 0 && i <= k; ++i) next[i] = f.minus(next[i], f.times(factor, p[k][i]));
    }
    p.push_back(std::move(next));
  }
  return p[n];
}

bool determinant(const Modulus& f, std::vector<Residue> matrix, std::size_t n, Residue& result) {
  const auto at = [&](std::size_t i, std::size_t j) -> Residue& { return matrix[i * n + j]; };
  // Rows are multiplied by the pivots instead of divided: one inverse in all.
  Residue scale = f.one();
  result = f.one();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && at(pivot, k) == 0) ++pivot;
    if (pivot == n) return result = 0, true;
    if (pivot != k) {
      for (std::size_t j = k; j < n; ++j) std::swap(at(pivot, j), at(k, j));
      result = f.minus(0, result);
    }
    result = f.times(result, at(k, k));
    for (std::size_t i = k + 1; i < n; ++i) {
      const Residue factor = at(i, k);
      if (factor == 0) continue;
      scale = f.times(scale, at(k, k));
      for (std::size_t j = k + 1; j < n; ++j)
        at(i, j) = f.minus(f.times(at(k, k), at(i, j)), f.times(factor, at(k, j)));
    }
  }
  const Residue inverse = f.inverse(scale);
  result = f.times(result, inverse);
  return inverse != 0;
}

mpz_class norm(const Dense& p) {
  mpz_class result = 0;
  for (const auto& c : p.coefficients) result += abs(c);
  return result;
}

namespace {

/// Fills `values`, one for each polynomial, variable by variable (Horner along the first, slowest one).
bool visit(const Modulus& f, const std::vector<Dense>& shapes, std::size_t level,
           const std::vector<std::vector<Residue>>& coefficients, const std::vector<int>& counts, Residue start,
           const std::function<bool(const std::vector<Residue>&)>& use) {
  if (level == counts.size()) {
    std::vector<Residue> values;
    for (const auto& c : coefficients) values.push_back(c[0]);
    return use(values);
  }
  Residue x = start;
  std::vector<std::vector<Residue>> next(coefficients.size());
  for (int step = 0; step < counts[level]; ++step, x = f.plus(x, f.one())) {
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const auto n = static_cast<std::size_t>(shapes[k].degrees[level]);
      const std::vector<Residue>& c = coefficients[k];
      const std::size_t size = c.size() / (n + 1);
      next[k].assign(c.end() - static_cast<std::ptrdiff_t>(size), c.end());
      for (std::size_t e = n; e-- > 0;)
        for (std::size_t i = 0; i < size; ++i) next[k][i] = f.plus(f.times(next[k][i], x), c[e * size + i]);
    }
    if (!visit(f, shapes, level + 1, next, counts, start, use)) return false;
  }
  return true;
}

}  // namespace

bool for_each_point(const Modulus& modulus, const std::vector<Dense>& polynomials, const std::vector<int>& counts,
                    const mpz_class& start, const std::function<bool(const std::vector<Residue>&)>& use) {
  std::vector<std::vector<Residue>> coefficients;
  for (const auto& p : polynomials) {
    coefficients.emplace_back();
    for (const auto& c : p.coefficients) coefficients.back().push_back(modulus.from(c));
  }
  return visit(modulus, polynomials, 0, coefficients, counts, modulus.from(start), use);
}

double visit_cost(const std::vector<Dense>& polynomials, const std::vector<int>& counts) {
  double result = 0, points = 1;
  for (std::size_t level = 0; level <= counts.size(); ++level) {  // level variables already have values
    if (level > 0) points *= counts[level - 1];
    for (const auto& p : polynomials) {
      double size = 1;
      for (std::size_t k = level == 0 ? 0 : level - 1; k < counts.size(); ++k) size *= p.degrees[k] + 1;
      result += points * (20 + 5 * size) + (level == 0 ? 20 * size * limbs(norm(p)) : 0);
    }
  }
  return result;
}

bool interpolate(const Modulus& f, std::vector<Residue>& values, const std::vector<int>& counts, int start) {
  std::size_t stride = values.size();
  for (const int count : counts) {
    const auto n = static_cast<std::size_t>(count);
    std::vector<Residue> inverses{0}, nodes;
    for (std::size_t k = 0; k < n; ++k) nodes.push_back(f.from(mpz_class(start) + k));
    for (std::size_t k = 1; k < n; ++k) {
      inverses.push_back(f.inverse(f.from(mpz_class(k))));
      if (inverses.back() == 0) return false;
    }
    const std::size_t block = stride;
    stride /= n;
    for (std::size_t first = 0; first < values.size(); first += block) {
      for (std::size_t offset = first; offset < first + stride; ++offset) {
        const auto at = [&](std::size_t k) -> Residue& { return values[offset + k * stride]; };
        for (std::size_t order = 1; order < n; ++order)  // Newton's divided differences
          for (std::size_t k = n - 1; k >= order; --k) at(k) = f.times(f.minus(at(k), at(k - 1)), inverses[order]);
        for (std::size_t k = n - 1; k-- > 0;)  // Horner: .. (x - k) + difference k
          for (std::size_t j = k; j + 1 < n; ++j) at(j) = f.minus(at(j), f.times(nodes[k], at(j + 1)));
      }
    }
  }
  return true;
}

void Reconstruction::add(const Modulus& modulus, const std::vector<Residue>& residues) {
  const Residue inverse = modulus.inverse(modulus.from(product_));
  if (inverse == 0) return;
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] +=
        product_ * modulus.to_integer(modulus.times(modulus.minus(residues[i], modulus.from(values_[i])), inverse));
  product_ *= modulus.value();
}

std::vector<mpz_class> Reconstruction::result() const {
  std::vector<mpz_class> result = values_;
  for (auto& x : result)
    if (2 * x > product_) x -= product_;
  return result;
}

}  // namespace limes::checker
