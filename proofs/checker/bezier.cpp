// SPDX-License-Identifier: MIT
#include "proofs/checker/bezier.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

void add_multiple(Vector& x, const mpq_class& factor, const Vector& y) {
  for (std::size_t c = 0; c < x.size(); ++c)
    if (y[c] != 0) x[c] += factor * y[c];
}

}  // namespace

mpq_class binomial(int n, int k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

mpq_class power(const mpq_class& x, int n) {
  mpq_class result = 1;
  for (int k = 0; k < n; ++k) result *= x;
  return result;
}

Rows jet_rows(int from, int to, int r) {
  const auto falling = [](int x, int count) {
    mpq_class result = 1;
    for (int s = 0; s < count; ++s) result *= x - s;
    return result;
  };
  Rows rows;
  for (int i = 0; i <= r; ++i) {
    rows.emplace_back(static_cast<std::size_t>(from + 1));
    for (int j = 0; j <= std::min(i, from); ++j)
      rows.back()[static_cast<std::size_t>(j)] =
          binomial(i, j) * falling(from, j) * falling(to - from, i - j) / falling(to, i);
  }
  return rows;
}

// sum_{l<=r} a_l u^l + x_0 u^{r+1} + sum_{0<k<pieces} x_k (u - k/pieces)_+^{r+1} with the Taylor coefficients a_l of S
// at 0; its Taylor coefficients i <= r at 1 are those of S: r+1 equations for the x_k.
Rows split_rows(int degree, int r, int pieces) {
  const Vector zero(static_cast<std::size_t>(degree + 1));
  Rows start, end;  // Taylor coefficients 0..r of S at 0 and at 1
  for (int l = 0; l <= r; ++l) {
    start.push_back(zero);
    end.push_back(zero);
    for (int s = 0; s <= l && l <= degree; ++s) {
      const mpq_class difference = binomial(degree, l) * binomial(l, s) * ((l - s) % 2 == 0 ? 1 : -1);
      start.back()[static_cast<std::size_t>(s)] = difference;
      end.back()[static_cast<std::size_t>(degree - l + s)] = difference;
    }
  }
  Rows system, right;
  for (int i = 0; i <= r; ++i) {
    system.emplace_back();
    for (int k = 0; k < pieces; ++k)
      system.back().push_back(binomial(r + 1, i) * power(mpq_class(pieces - k) / pieces, r + 1 - i));
    right.push_back(end[static_cast<std::size_t>(i)]);
    for (int l = i; l <= r; ++l) add_multiple(right.back(), -binomial(l, i), start[static_cast<std::size_t>(l)]);
  }
  const auto unknowns = static_cast<std::size_t>(pieces);
  for (std::size_t k = 0; k < unknowns; ++k) {  // the columns are independent: there is a pivot
    std::size_t pivot = k;
    while (pivot < system.size() && system[pivot][k] == 0) ++pivot;
    if (pivot == system.size()) return {};
    std::swap(system[k], system[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = 0; i < system.size(); ++i) {
      if (i == k || system[i][k] == 0) continue;
      const mpq_class factor = -system[i][k] / system[k][k];
      add_multiple(system[i], factor, system[k]);
      add_multiple(right[i], factor, right[k]);
    }
  }
  for (std::size_t i = unknowns; i < right.size(); ++i)
    if (right[i] != zero) return {};
  Rows result;
  for (int piece = 0; piece < pieces; ++piece) {
    Rows local;  // the Taylor coefficients at the piece's start, its length being the unit
    for (int i = 0; i <= r + 1; ++i) {
      Vector sum = zero;
      for (int l = i; l <= r; ++l)
        add_multiple(sum, binomial(l, i) * power(mpq_class(piece) / pieces, l - i), start[static_cast<std::size_t>(l)]);
      for (std::size_t k = 0; k <= static_cast<std::size_t>(piece); ++k)
        add_multiple(
            sum, binomial(r + 1, i) * power(mpq_class(piece - static_cast<int>(k)) / pieces, r + 1 - i) / system[k][k],
            right[k]);
      for (auto& c : sum) c *= power(mpq_class(1) / pieces, i);
      local.push_back(std::move(sum));
    }
    for (int j = 0; j <= r + 1; ++j) {
      result.push_back(zero);
      for (int i = 0; i <= j; ++i)
        add_multiple(result.back(), binomial(j, i) / binomial(r + 1, i), local[static_cast<std::size_t>(i)]);
    }
  }
  return result;
}

}  // namespace limes::checker
