// SPDX-License-Identifier: MIT
//
// Theorem U2: let S_a be interpolatory, or let the integer shifts of its refinable function be linearly independent. If
// S_a is C^m, then sigma^{m+1} divides a, and S_b is a contraction; so a remainder that does not vanish, or a product
// of the matrices B_e with spectral radius >= 1, shows that S_a is not C^m (Dyn & Levin, Acta Numerica 2002).
#include "proofs/checker/certificate.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

using Coefficients = std::vector<mpz_class>;

// ---- Stability ------------------------------------------------------------------------------------------------------

/// Some residue class modulo p holds one coefficient D and zeros: then phi(k + x_0) = delta_{k,0} for the limit phi of
/// delta.
bool is_interpolatory(const LocalScheme& scheme) {
  const auto p = static_cast<std::size_t>(scheme.arity);
  for (std::size_t residue = 0; residue < p; ++residue) {
    std::vector<std::size_t> entries;
    for (std::size_t j = residue; j < scheme.mask.count(); j += p)
      if (!scheme.mask.is_zero(j)) entries.push_back(j);
    if (entries.size() != 1) continue;
    if (scheme.mask.polynomial(entries[0]).coefficients == scheme.denominator.coefficients) return true;
  }
  return false;
}

/// Polynomials over the field of P elements, P a prime below 2^31; the last coefficient is not 0, the zero polynomial
/// is empty.
using Modular = std::vector<std::uint64_t>;

std::uint64_t modular_power(std::uint64_t x, std::uint64_t n, std::uint64_t P) {
  std::uint64_t result = 1;
  for (; n > 0; n /= 2, x = x * x % P)
    if (n % 2 == 1) result = result * x % P;
  return result;
}

Modular modular_gcd(Modular f, Modular g, std::uint64_t P) {
  while (!g.empty()) {
    const std::uint64_t inverse = modular_power(g.back(), P - 2, P);
    while (f.size() >= g.size()) {
      const std::uint64_t factor = P - f.back() * inverse % P;
      const std::size_t shift = f.size() - g.size();
      for (std::size_t i = 0; i < g.size(); ++i) f[shift + i] = (f[shift + i] + factor * g[i]) % P;
      while (!f.empty() && f.back() == 0) f.pop_back();
    }
    std::swap(f, g);
  }
  return f;
}

/// Jia & Wang 1993 for a(z) with non-zero constant coefficient: a(z) and a(-z) have no common zero, and no primitive
/// 2k-th root of unity is a zero for odd k >= 3. Both are shown modulo one prime P that divides neither end
/// coefficient: a common factor over Q would leave a common factor of the same degree modulo P. So "true" is a proof,
/// and "false" shows nothing.
bool has_independent_shifts(const Coefficients& a, std::uint64_t P) {
  Modular f, g;  // a(z), a(-z)
  for (std::size_t i = 0; i < a.size(); ++i) {
    f.push_back(mpz_fdiv_ui(a[i].get_mpz_t(), P));
    g.push_back(i % 2 == 0 ? f[i] : (P - f[i]) % P);
  }
  if (f.front() == 0 || f.back() == 0) return false;
  if (modular_gcd(f, g, P).size() > 1) return false;
  // A primitive 2k-th root of unity of a is -omega with omega of odd order k, so a(-omega) = 0; over Q all omega of
  // order k are zeros of a(-z) then, and squaring permutes them. Dropping the zero 1 (k = 1) and then, again and again,
  // every zero whose square is no zero must leave nothing.
  for (;;) {
    std::uint64_t at_one = 0;
    for (const auto c : g) at_one = (at_one + c) % P;
    if (at_one != 0) break;
    for (std::size_t i = g.size() - 1; i-- > 0;) g[i] = (g[i] + g[i + 1]) % P;  // division by z - 1
    g.erase(g.begin());
  }
  while (g.size() > 1) {
    Modular squares(2 * g.size() - 1, 0);  // g(z^2)
    for (std::size_t i = 0; i < g.size(); ++i) squares[2 * i] = g[i];
    Modular kept = modular_gcd(squares, g, P);
    if (kept.size() == g.size()) return false;
    g = std::move(kept);
  }
  return true;
}

}  // namespace

void prove_stability(const LocalScheme& scheme, bool interpolatory, Budget& budget) {
  if (interpolatory) {
    if (!is_interpolatory(scheme)) throw Rejected{"stability", "the scheme is not interpolatory"};
    return;
  }
  if (scheme.arity != 2) throw Rejected{"stability", "linear independence needs arity 2"};
  if (!scheme.box.empty()) throw Rejected{"stability", "linear independence needs a leaf that is a single point"};
  if (scheme.mask.count() > 128) throw Rejected{"stability", "linear independence needs at most 128 coefficients"};
  mpz_class sum = 0;
  for (const auto& c : scheme.mask.coefficients) sum += c;
  if (sum != 2 * scheme.denominator.coefficients.front()) throw Rejected{"stability", "a(1) is not 2"};
  budget.work(5e7);
  for (const std::uint64_t prime : {2147483647u, 2147483629u, 2147483587u})
    if (has_independent_shifts(scheme.mask.coefficients, prime)) return;
  throw Rejected{"stability", "the shifts are not proved linearly independent"};
}

namespace {

// ---- The missing factor ---------------------------------------------------------------------------------------------

void prove_missing_factor(const LocalScheme& scheme) {
  for (std::size_t j = 0; j < scheme.remainder.count(); ++j) {
    Coefficients coefficient = scheme.remainder.polynomial(j).coefficients;
    if (is_positive(coefficient, scheme.remainder.degrees, scheme.box)) return;
    for (auto& c : coefficient) c = -c;
    if (is_positive(coefficient, scheme.remainder.degrees, scheme.box)) return;
  }
  throw Rejected{"missing_factor", "no coefficient of the remainder by sigma^(m+1) has a proven strict sign"};
}

// ---- Words ----------------------------------------------------------------------------------------------------------

/// Polynomials of one degree in a matrix, row by row; all entries are in the same multidegree.
struct Matrix {
  std::size_t size = 0;
  std::vector<Bernstein> entries;
  const Bernstein& at(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

void accumulate(Bernstein& sum, const Bernstein& term, bool negative = false) {
  for (std::size_t i = 0; i < sum.coefficients.size(); ++i) {
    if (negative)
      sum.coefficients[i] -= term.coefficients[i];
    else
      sum.coefficients[i] += term.coefficients[i];
  }
}

std::vector<int> times(std::vector<int> degrees, int factor) {
  for (int& n : degrees) n *= factor;
  return degrees;
}

Bernstein zero(const std::vector<int>& degrees) {
  Bernstein result{degrees, {}};
  result.coefficients.resize(result.size());
  return result;
}

/// sum_k x_k y_k, of lists of the same length, not empty.
Bernstein scalar_product(const std::vector<const Bernstein*>& x, const std::vector<const Bernstein*>& y) {
  std::vector<int> degrees = x[0]->degrees;
  for (std::size_t k = 0; k < degrees.size(); ++k) degrees[k] += y[0]->degrees[k];
  Bernstein result = zero(degrees);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!x[k]->is_zero(0) && !y[k]->is_zero(0)) accumulate(result, convolve(*x[k], *y[k]));
  return result;
}

std::size_t section_size(const LocalScheme& scheme) {
  const std::size_t N = scheme.quotient.count() - 1, q = static_cast<std::size_t>(scheme.arity - 1);
  return std::max<std::size_t>(1, (N + q - 1) / q);
}

/// (B_e)_{ij} = B_{e + pj - i} for i, j in R = {0, .., size - 1}.
Matrix section(const LocalScheme& scheme, int letter) {
  const Bernstein& b = scheme.quotient;
  Matrix result{section_size(scheme), {}};
  const auto n = static_cast<long>(result.size), count = static_cast<long>(b.count());
  for (long i = 0; i < n; ++i) {
    // R is invariant: B_{e + pj - i} = 0 for i in R and every j outside of R.
    for (long j = -count - n; j <= count + n; ++j) {
      const long k = letter + scheme.arity * j - i;
      const Bernstein entry = k >= 0 && k < count ? b.polynomial(static_cast<std::size_t>(k)) : zero(b.degrees);
      if (j >= 0 && j < n)
        result.entries.push_back(entry);
      else if (!entry.is_zero(0))
        throw Rejected{"word", "the section is not invariant"};
    }
  }
  return result;
}

Matrix product(const Matrix& x, const Matrix& y) {
  Matrix result{x.size, {}};
  for (std::size_t i = 0; i < x.size; ++i) {
    for (std::size_t j = 0; j < x.size; ++j) {
      std::vector<const Bernstein*> row, column;
      for (std::size_t k = 0; k < x.size; ++k) {
        row.push_back(&x.at(i, k));
        column.push_back(&y.at(k, j));
      }
      result.entries.push_back(scalar_product(row, column));
    }
  }
  return result;
}

/// c_0 = 1, .., c_n with det(lambda - M) = sum_i c_i lambda^{n-i}, by the division-free recursion of Samuelson and
/// Berkowitz: with the leading blocks M_r = (M_{r-1}, C; R, a), the coefficients of M_r are those of M_{r-1} times the
/// lower triangular Toeplitz matrix with first column 1, -a, -R C, -R M_{r-1} C, .. . c_i has i times the multidegree
/// of the entries.
std::vector<Bernstein> characteristic_polynomial(const Matrix& m) {
  const Bernstein one{std::vector<int>(m.entries[0].degrees.size(), 0), {1}};
  std::vector<Bernstein> result{one};
  for (std::size_t r = 0; r < m.size; ++r) {
    std::vector<Bernstein> toeplitz{one, zero(m.at(r, r).degrees)}, column;
    accumulate(toeplitz[1], m.at(r, r), true);
    std::vector<const Bernstein*> row;
    for (std::size_t i = 0; i < r; ++i) {
      column.push_back(m.at(i, r));
      row.push_back(&m.at(r, i));
    }
    const auto pointers = [](const std::vector<Bernstein>& list) {
      std::vector<const Bernstein*> addresses;
      for (const auto& element : list) addresses.push_back(&element);
      return addresses;
    };
    for (std::size_t power = 0; power < r; ++power) {
      const Bernstein entry = scalar_product(row, pointers(column));
      toeplitz.push_back(zero(entry.degrees));
      accumulate(toeplitz.back(), entry, true);
      std::vector<Bernstein> next;
      for (std::size_t i = 0; i < r && power + 1 < r; ++i) {
        std::vector<const Bernstein*> block_row;
        for (std::size_t j = 0; j < r; ++j) block_row.push_back(&m.at(i, j));
        next.push_back(scalar_product(block_row, pointers(column)));
      }
      column = std::move(next);
    }
    std::vector<Bernstein> product;
    for (std::size_t i = 0; i <= r + 1; ++i) {
      product.push_back(zero(times(m.entries[0].degrees, static_cast<int>(i))));
      for (std::size_t j = 0; j <= std::min(i, r); ++j)
        accumulate(product.back(), convolve(toeplitz[i - j], result[j]));
    }
    result = std::move(product);
  }
  return result;
}

void prove_word(const LocalScheme& scheme, const std::vector<int>& word, Budget& budget) {
  if (!scheme.has_factor) throw Rejected{"factor", "sigma^(m+1) does not divide the symbol"};
  const Bernstein& b = scheme.quotient;
  if (b.is_zero(0) || b.is_zero(b.count() - 1)) throw Rejected{"word", "an end coefficient of B is zero"};
  Matrix m = section(scheme, word[0]);
  for (std::size_t k = 1; k < word.size(); ++k) m = product(m, section(scheme, word[k]));

  // With d = D^k > 0: chi(lambda) = det(lambda d - M) = sum_i c_i d^{n-i} lambda^{n-i}.
  const Bernstein d = power(scheme.denominator, static_cast<int>(word.size()));
  std::vector<Bernstein> chi = characteristic_polynomial(m);
  const std::size_t n = m.size;
  for (std::size_t i = 0; i < n; ++i) chi[i] = convolve(power(d, static_cast<int>(n - i)), chi[i]);
  Bernstein at_one = zero(chi[n].degrees), at_minus_one = at_one;  // chi(1), (-1)^n chi(-1)
  for (std::size_t i = 0; i <= n; ++i) {
    accumulate(at_one, chi[i]);
    accumulate(at_minus_one, chi[i], i % 2 == 1);
  }
  const auto non_positive = [](const Bernstein& p) {
    return std::all_of(p.coefficients.begin(), p.coefficients.end(), [](const mpz_class& c) { return c <= 0; });
  };
  if (non_positive(at_one) || non_positive(at_minus_one)) return;
  if (scheme.box.empty()) {
    Coefficients ascending;
    for (std::size_t i = n + 1; i-- > 0;) ascending.push_back(chi[i].coefficients[0]);
    if (!all_roots_inside(ascending, budget)) return;
  } else if (n > 1) {
    // With all roots inside, d^{n(n-1)} prod_{i<j} (1 - z_i z_j) would be positive.
    Bernstein ascending{chi[n].degrees, {}};
    for (std::size_t i = n + 1; i-- > 0;)
      ascending.coefficients.insert(ascending.coefficients.end(), chi[i].coefficients.begin(), chi[i].coefficients.end());
    if (non_positive(boundary_determinant(ascending, budget))) return;
  }
  throw Rejected{"word", "the product of the word is not proved to have spectral radius at least 1"};
}

}  // namespace

/// Whether all roots of f_0 + .. + f_n z^n lie in |z| < 1: |f_n| > |f_0|, and the same for (f_n f - f_0 z^n f(1/z)) / z
/// (Schur).
bool all_roots_inside(std::vector<mpz_class> f, Budget& budget) {
  while (f.size() > 1) {
    double size = 1;
    for (const auto& c : f) size = std::max(size, limbs(c));
    budget.work(static_cast<double>(f.size()) * (500 + 8 * size * size));
    if (abs(f.back()) <= abs(f.front())) return false;
    const std::size_t n = f.size() - 1;
    Coefficients next(n);
    mpz_class content = 0;
    for (std::size_t i = 0; i < n; ++i) {
      next[i] = f[n] * f[i + 1] - f[0] * f[n - 1 - i];
      content = gcd(content, next[i]);
    }
    for (auto& c : next) c /= content;
    f = std::move(next);
  }
  return true;
}

double u2_work(const LocalScheme& scheme, const Leaf& leaf) {
  const double setup = static_cast<double>(scheme.mask.coefficients.size()) * 200;
  if (leaf.missing_factor || !scheme.has_factor || scheme.quotient.count() == 0) return setup;
  const Bernstein& b = scheme.quotient;
  mpz_class sum = 1;
  for (const auto& c : b.coefficients) sum += abs(c);
  for (const auto& c : scheme.denominator.coefficients) sum += abs(c);
  const double size = static_cast<double>(mpz_sizeinbase(sum.get_mpz_t(), 2)) / 64;
  const auto k = static_cast<double>(leaf.word.size()), n = static_cast<double>(section_size(scheme));
  // Multiplications of an entry of i letters by one of j letters: both lengths are bounded by sums of absolute values.
  const auto multiplication = [&](double i, double j) {
    return 300 + tensor_size(b.degrees, i) * tensor_size(b.degrees, j) * cost(i * size + 1, j * size + 1);
  };
  double work = setup + k * n * (n + static_cast<double>(b.count())) * 50;
  for (double j = 1; j < k; ++j) work += n * n * n * multiplication(j, 1);
  for (double j = 1; j < n; ++j) work += (n - j) * n * n * multiplication(j * k, k);  // R M^{j-1} C for all r > j
  for (double i = 0; i <= n; ++i)
    for (double j = 0; j <= i; ++j) work += (n - i + 1) * multiplication((i - j) * k, j * k);
  for (double j = 0; j < n; ++j) work += 2 * n * multiplication(j * k, k);
  const double entries = 3 * n * n * tensor_size(b.degrees, k) + 4 * n * tensor_size(b.degrees, n * k);
  if (!(entries * (32 + 8 * (n * k * size + 1)) <= 512e6)) throw Rejected{"limits", "the word needs too much memory"};
  return work;
}

void prove_u2(const LocalScheme& scheme, bool interpolatory, const Leaf& leaf, Budget& budget) {
  prove_stability(scheme, interpolatory, budget);
  if (leaf.missing_factor)
    prove_missing_factor(scheme);
  else
    prove_word(scheme, leaf.word, budget);
}

}  // namespace limes::checker
