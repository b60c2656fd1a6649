// SPDX-License-Identifier: MIT
//
// Interval arithmetic on a fixed grid, cos and sin by Taylor's series, and the number of roots in a disc.
#include "proofs/checker/enclosure.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

mpz_class floor_quotient(const mpz_class& x, const mpz_class& y) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  return result;
}

mpz_class ceil_quotient(const mpz_class& x, const mpz_class& y) {
  mpz_class result;
  mpz_cdiv_q(result.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  return result;
}

/// x 2^-enclosure_bits, rounded down or up.
mpz_class shifted_down(const mpz_class& x) {
  mpz_class result;
  mpz_fdiv_q_2exp(result.get_mpz_t(), x.get_mpz_t(), enclosure_bits);
  return result;
}
mpz_class shifted_up(const mpz_class& x) {
  mpz_class result;
  mpz_cdiv_q_2exp(result.get_mpz_t(), x.get_mpz_t(), enclosure_bits);
  return result;
}

Enclosure widened(Enclosure x, const Enclosure& by) {
  x.lower -= by.upper;
  x.upper += by.upper;
  return x;
}

/// arctan(1/q) = sum_k (-1)^k / ((2k+1) q^{2k+1}); the terms fall, so the first one left out bounds the rest.
Enclosure arctangent_of_inverse(long q) {
  const Enclosure square(mpq_class(q) * q);
  Enclosure power(mpq_class(1, q)), sum(mpq_class(0)), term;
  for (long k = 0;; ++k) {
    term = power / Enclosure(mpq_class(2 * k + 1));
    if (term.upper <= 2) return widened(sum, term);
    sum = k % 2 == 0 ? sum + term : sum - term;
    power = power / square;
  }
}

}  // namespace

Enclosure::Enclosure(const mpq_class& from, const mpq_class& to)
    : lower(floor_quotient(from.get_num() << enclosure_bits, from.get_den())),
      upper(ceil_quotient(to.get_num() << enclosure_bits, to.get_den())) {}

mpq_class Enclosure::least() const {
  mpq_class result(lower, mpz_class(1) << enclosure_bits);
  result.canonicalize();
  return result;
}

mpq_class Enclosure::greatest() const {
  mpq_class result(upper, mpz_class(1) << enclosure_bits);
  result.canonicalize();
  return result;
}

Enclosure operator-(const Enclosure& x) { return {mpz_class(-x.upper), mpz_class(-x.lower)}; }
Enclosure operator+(const Enclosure& x, const Enclosure& y) {
  return {mpz_class(x.lower + y.lower), mpz_class(x.upper + y.upper)};
}
Enclosure operator-(const Enclosure& x, const Enclosure& y) {
  return {mpz_class(x.lower - y.upper), mpz_class(x.upper - y.lower)};
}

Enclosure operator*(const Enclosure& x, const Enclosure& y) {
  if (x.lower >= 0 && y.lower >= 0)
    return {shifted_down(mpz_class(x.lower * y.lower)), shifted_up(mpz_class(x.upper * y.upper))};
  const mpz_class p[] = {x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper};
  return {shifted_down(*std::min_element(p, p + 4)), shifted_up(*std::max_element(p, p + 4))};
}

Enclosure operator/(const Enclosure& x, const Enclosure& y) {
  if (y.is_negative()) return -x / -y;
  const mpz_class low = x.lower << enclosure_bits, high = x.upper << enclosure_bits;
  return {floor_quotient(low, low >= 0 ? y.upper : y.lower), ceil_quotient(high, high >= 0 ? y.lower : y.upper)};
}

Enclosure absolute(const Enclosure& x) {
  if (x.lower >= 0) return x;
  if (x.upper <= 0) return -x;
  return {mpz_class(0), std::max(mpz_class(-x.lower), x.upper)};
}

Enclosure hull(const Enclosure& x, const Enclosure& y) {
  return {std::min(x.lower, y.lower), std::max(x.upper, y.upper)};
}

const Enclosure& pi() {  // Machin
  static const Enclosure value = Enclosure(mpq_class(16)) * arctangent_of_inverse(5) -
                                 Enclosure(mpq_class(4)) * arctangent_of_inverse(239);
  return value;
}

Enclosure cosine(const mpq_class& turn) {
  const Enclosure x = Enclosure(mpq_class(2 * turn)) * pi(), square = absolute(x) * absolute(x);
  Enclosure sum(mpq_class(1)), term(mpq_class(1));
  for (long k = 1;; ++k) {
    term = term * square / Enclosure(mpq_class((2 * k - 1) * (2 * k)));
    // Lagrange's remainder after the terms before this one is at most this one.
    if (term.upper <= 2) return widened(sum, term);
    sum = k % 2 == 0 ? sum + term : sum - term;
  }
}

Enclosure sine(const mpq_class& turn) { return cosine(mpq_class(turn - mpq_class(1, 4))); }

int roots_inside(std::vector<Enclosure> f, const mpq_class& radius, Budget& budget) {
  budget.work(enclosure_cost * static_cast<double>(f.size() * f.size()) * 3);
  Enclosure scale(mpq_class(1));
  for (Enclosure& c : f) {
    c = c * scale;
    scale = scale * Enclosure(radius);
  }
  // On |z| = 1 f and its reverse f* have the same modulus, so f - k f* with |k| < 1 has as many roots inside as f, and a root on the
  // circle with it. With k = f_0 / f_d one of its roots is 0, with f* - k f, k = f_d / f_0, its degree falls.
  int inside = 0;
  while (f.size() > 1) {
    const Enclosure first = absolute(f.front()), last = absolute(f.back());
    const std::size_t d = f.size() - 1;
    std::vector<Enclosure> next;
    if (first < last) {
      const Enclosure k = f.front() / f.back();
      for (std::size_t i = 1; i <= d; ++i) next.push_back(f[i] - k * f[d - i]);
      ++inside;
    } else if (last < first) {
      const Enclosure k = f.back() / f.front();
      for (std::size_t i = 0; i < d; ++i) next.push_back(f[i] - k * f[d - i]);
    } else {
      return -1;
    }
    f = std::move(next);
  }
  return f.empty() || absolute(f.front()).lower > 0 ? inside : -1;
}

}  // namespace limes::checker
