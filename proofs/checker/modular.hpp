// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/bernstein.hpp"

#include <cmath>
#include <cstdint>
#include <functional>

namespace limes::checker {

using Residue = std::uint64_t;
__extension__ typedef unsigned __int128 Wide;

/// The integers modulo an odd p < 2^62; x is stored as 2^64 x mod p (Montgomery). p is a prime (nextprime of GMP), but
/// nothing that is proved depends on it: what is used are inverses, and inverse() verifies them.
class Modulus {
 public:
  explicit Modulus(const mpz_class& p);
  const mpz_class& value() const { return value_; }
  Residue one() const { return one_; }
  Residue from(const mpz_class& x) const { return times(mpz_fdiv_ui(x.get_mpz_t(), p_), square_); }
  mpz_class to_integer(Residue x) const { return mpz_class(static_cast<unsigned long>(reduce(x))); }
  Residue plus(Residue x, Residue y) const { return x + y >= p_ ? x + y - p_ : x + y; }
  Residue minus(Residue x, Residue y) const { return x >= y ? x - y : x + (p_ - y); }
  Residue times(Residue x, Residue y) const { return reduce(static_cast<Wide>(x) * y); }
  /// x^{-1}; 0 when there is none.
  Residue inverse(Residue x) const;

 private:
  Residue reduce(Wide x) const {
    const auto q = static_cast<std::uint64_t>(x) * negative_inverse_;
    const auto y = static_cast<std::uint64_t>((x + static_cast<Wide>(q) * p_) >> 64);
    return y >= p_ ? y - p_ : y;
  }
  mpz_class value_;
  std::uint64_t p_, negative_inverse_ = 1;
  Residue one_, square_;  // 2^64 and 2^128 mod p, so 1 and 2^64
};

/// The number of moduli that next_modulus gives until their product exceeds 2^bits.
inline double moduli_for(double bits) { return std::floor(bits / 61) + 1; }
/// p > previous.value(), for a start from 2^61.
mpz_class next_modulus(const mpz_class& previous = mpz_class(1) << 61);

/// c_0 .. c_n = 1 with det(lambda - M) = sum_i c_i lambda^i, for the matrix M row by row. Empty when a pivot has no
/// inverse.
std::vector<Residue> characteristic_polynomial(const Modulus& modulus, std::vector<Residue> matrix, std::size_t n);
/// \returns whether the product of the pivots had an inverse
bool determinant(const Modulus& modulus, std::vector<Residue> matrix, std::size_t n, Residue& result);

/// Polynomials with integer coefficients, dense in the degrees of each; the last variable runs fastest.
struct Dense {
  std::vector<int> degrees;
  std::vector<mpz_class> coefficients;
};
mpz_class norm(const Dense& p);  ///< the sum of the absolute values of the coefficients: submultiplicative

/// Calls `use` with the values of the polynomials at all points of a grid, counts[k] integers from `start` on along
/// variable k, the last variable fastest, until it returns false. \returns whether it never did
bool for_each_point(const Modulus& modulus, const std::vector<Dense>& polynomials, const std::vector<int>& counts,
                    const mpz_class& start, const std::function<bool(const std::vector<Residue>&)>& use);

/// Nanoseconds of a call of characteristic_polynomial, and of a visit of for_each_point without `use`.
inline double charpoly_cost(double n) { return 500 * n + 15 * n * n * n; }
double visit_cost(const std::vector<Dense>& polynomials, const std::vector<int>& counts);

/// From the values at the grid start .. start + counts[k] - 1 to the coefficients of the polynomial of degrees
/// counts[k] - 1. \returns whether the differences of the points have inverses
bool interpolate(const Modulus& modulus, std::vector<Residue>& values, const std::vector<int>& counts, int start);

/// Integers x with |x| < bound, from their residues modulo enough moduli.
class Reconstruction {
 public:
  Reconstruction(std::size_t count, const mpz_class& bound) : twice_(2 * bound), values_(count) {}
  bool is_complete() const { return product_ > twice_; }
  void add(const Modulus& modulus, const std::vector<Residue>& residues);
  std::vector<mpz_class> result() const;

 private:
  mpz_class product_ = 1, twice_;
  std::vector<mpz_class> values_;
};

}  // namespace limes::checker
