#include "schemes/nonuniform/bezier_maps.hpp"

#include <algorithm>

namespace limes {

Rational binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  Rational result = 1;
  for (int j = 1; j <= k; ++j) result = result * (n - k + j) / j;
  return result;
}

std::vector<Rational> bernstein_values(int degree, const Rational& u) {
  std::vector<Rational> result;
  for (int j = 0; j <= degree; ++j)
    result.push_back(binomial(degree, j) * power(Rational(1 - u), degree - j) * power(u, j));
  return result;
}

RationalMatrix jet_in_degree(int from, int to, int r) {
  const auto falling = [](int x, int count) {
    Rational product = 1;
    for (int s = 0; s < count; ++s) product *= x - s;
    return product;
  };
  RationalMatrix result(r + 1, from + 1);
  for (int i = 0; i <= r; ++i) {
    for (int j = 0; j <= std::min(i, from); ++j) {
      result(i, j) = binomial(i, j) * falling(from, j) * falling(to - from, i - j) / falling(to, i);
    }
  }
  return result;
}

RationalMatrix degree_raising(int from, int to) { return jet_in_degree(from, to, to); }

// Each piece is written in powers of its own v in [0, 1], the pieces being p in number: piece 0 has the Taylor
// coefficients T_l / p^l, l <= r, of the jet at 0 and an unknown coefficient g_0 of v^{r+1}; the coefficient of v^{r+1}
// jumps by an unknown g_k at the start of piece k. Reaching the r-jet S_i / p^i at the end of the last piece gives r+1
// equations,
//   sum_k g_k C(r+1, i) (p-k)^{r+1-i} = S_i / p^i - sum_{l=i..r} C(l, i) p^{l-i} T_l / p^l,
// whose columns are independent.
RationalMatrix split_in_pieces(int degree, int r, int pieces) {
  const int columns = degree + 1;
  RationalMatrix start(r + 1, columns);  // row l: T_l / p^l as a combination of the Bezier coefficients
  RationalMatrix goal(r + 1, columns);   // row i: S_i / p^i
  for (int l = 0; l <= std::min(r, degree); ++l) {
    const Rational scale = binomial(degree, l) / power(Rational(pieces), l);
    for (int s = 0; s <= l; ++s) {
      const Rational difference = scale * binomial(l, s) * ((l - s) % 2 == 0 ? 1 : -1);
      start(l, s) = difference;
      goal(l, degree - l + s) = difference;
    }
  }

  RationalMatrix system(r + 1, pieces + columns);
  for (int i = 0; i <= r; ++i) {
    for (int k = 0; k < pieces; ++k) system(i, k) = binomial(r + 1, i) * power(Rational(pieces - k), r + 1 - i);
    for (int c = 0; c < columns; ++c) {
      Rational rest = goal(i, c);
      for (int l = i; l <= r; ++l) rest -= binomial(l, i) * power(Rational(pieces), l - i) * start(l, c);
      system(i, pieces + c) = rest;
    }
  }
  for (int k = 0; k < pieces; ++k) {
    int pivot = k;
    while (system(pivot, k) == 0) ++pivot;
    for (int c = 0; c < pieces + columns; ++c) std::swap(system(k, c), system(pivot, c));
    for (int i = 0; i <= r; ++i) {
      if (i == k || system(i, k) == 0) continue;
      const Rational factor = system(i, k) / system(k, k);
      for (int c = k; c < pieces + columns; ++c) system(i, c) -= factor * system(k, c);
    }
  }
  for (int i = pieces; i <= r; ++i) {
    for (int c = 0; c < columns; ++c) {
      if (system(i, pieces + c) != 0) return {};
    }
  }

  RationalMatrix result(pieces * (r + 2), columns);
  for (int c = 0; c < columns; ++c) {
    std::vector<Rational> taylor;
    for (int l = 0; l <= r; ++l) taylor.push_back(start(l, c));
    taylor.push_back(0);
    for (int k = 0; k < pieces; ++k) {
      if (k > 0) {
        for (int i = 0; i <= r + 1; ++i) {
          for (int l = i + 1; l <= r + 1; ++l) taylor[std::size_t(i)] += binomial(l, i) * taylor[std::size_t(l)];
        }
      }
      taylor.back() += Rational(system(k, pieces + c) / system(k, k));
      for (int j = 0; j <= r + 1; ++j) {
        Rational& coefficient = result(k * (r + 2) + j, c);
        for (int i = 0; i <= j; ++i) coefficient += binomial(j, i) / binomial(r + 1, i) * taylor[std::size_t(i)];
      }
    }
  }
  return result;
}

}  // namespace limes
