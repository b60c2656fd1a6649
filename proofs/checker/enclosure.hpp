// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

namespace limes::checker {

/// A closed interval of real numbers whose ends are multiples of 2^-enclosure_bits; results are rounded outward.
struct Enclosure {
  mpz_class lower, upper;  ///< times 2^enclosure_bits

  Enclosure() = default;
  explicit Enclosure(const mpq_class& x) : Enclosure(x, x) {}
  /// \pre from <= to
  Enclosure(const mpq_class& from, const mpq_class& to);
  Enclosure(mpz_class from, mpz_class to) : lower(std::move(from)), upper(std::move(to)) {}

  bool is_positive() const { return lower > 0; }
  bool is_negative() const { return upper < 0; }
  /// The ends.
  mpq_class least() const;
  mpq_class greatest() const;
};

constexpr unsigned long enclosure_bits = 256;
/// What an operation costs at most, in nanoseconds, while |x| < 2^256.
constexpr double enclosure_cost = 400;

Enclosure operator-(const Enclosure& x);
Enclosure operator+(const Enclosure& x, const Enclosure& y);
Enclosure operator-(const Enclosure& x, const Enclosure& y);
Enclosure operator*(const Enclosure& x, const Enclosure& y);
/// \pre y is positive or negative
Enclosure operator/(const Enclosure& x, const Enclosure& y);
/// {|t| : t in x}
Enclosure absolute(const Enclosure& x);
/// What contains both.
Enclosure hull(const Enclosure& x, const Enclosure& y);
/// Whether every number of x is less than every number of y.
inline bool operator<(const Enclosure& x, const Enclosure& y) { return x.upper < y.lower; }

const Enclosure& pi();
/// cos(2 pi turn) and sin(2 pi turn). \pre |turn| <= 2
Enclosure cosine(const mpq_class& turn);
Enclosure sine(const mpq_class& turn);

/// The roots of f_0 + .. + f_d z^d in |z| < radius, none on the circle, for all coefficients in the enclosures [Schur; Cohn]; -1 when
/// that is not proved. f_d may be 0: there are d roots then with those at infinity.
int roots_inside(std::vector<Enclosure> f, const mpq_class& radius, Budget& budget);

}  // namespace limes::checker
