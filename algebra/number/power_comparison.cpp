#include "algebra/number/power_comparison.hpp"

#include "algebra/error.hpp"

#include <cmath>

namespace limes {
namespace {

/// A number in [lower, upper] 2^exponent.
struct ScaledInterval {
  Integer lower = 1, upper = 1, exponent = 0;

  void multiply(const ScaledInterval& y, unsigned bits) {
    lower *= y.lower;
    upper *= y.upper;
    exponent += y.exponent;
    round(bits);
  }
  void round(unsigned bits) {
    const unsigned size = unsigned(msb(upper)) + 1;
    if (size <= bits) return;
    const unsigned excess = size - bits;
    const bool exact = lsb(upper) >= excess;
    lower >>= excess;
    upper >>= excess;
    if (!exact) upper += 1;
    exponent += excess;
  }
};

ScaledInterval power_interval(const Integer& base, const Integer& exponent, unsigned bits) {
  ScaledInterval result, square{base, base, 0};
  square.round(bits);
  for (Integer rest = exponent; rest > 0; rest >>= 1) {
    if (bit_test(rest, 0)) result.multiply(square, bits);
    const ScaledInterval copy = square;
    square.multiply(copy, bits);
  }
  return result;
}

/// -1, 0 or 1 when all numbers of x are below, equal to, above all numbers of y; else nothing.
std::optional<int> compare(const ScaledInterval& x, const ScaledInterval& y) {
  const auto below = [](const Integer& m, const Integer& e, const Integer& n, const Integer& f, bool strict) {
    const Integer shift = e - f;
    if (abs(shift) > 100000) return shift < 0;
    const Integer left = shift > 0 ? Integer(m << unsigned(shift)) : m, right = shift < 0 ? Integer(n << unsigned(-shift)) : n;
    return strict ? left < right : left <= right;
  };
  if (below(x.upper, x.exponent, y.lower, y.exponent, true)) return -1;
  if (below(y.upper, y.exponent, x.lower, x.exponent, true)) return 1;
  if (below(x.upper, x.exponent, y.lower, y.exponent, false) && below(y.upper, y.exponent, x.lower, x.exponent, false)) return 0;
  return std::nullopt;
}

double approx_logarithm(const Rational& x, int p) {
  // The exponents of numerator and denominator may be beyond double's range.
  const auto log2_of = [](const Integer& n) {
    const unsigned size = unsigned(msb(n));
    const unsigned shift = size > 60 ? size - 60 : 0;
    return std::log2(static_cast<double>(Integer(n >> shift))) + shift;
  };
  return (log2_of(numerator(x)) - log2_of(denominator(x))) / std::log2(p);
}

/// The greatest a with p^a <= x^b, one decimal digit of b = 10^digits at a time. \returns whether p^a = x^b
std::pair<Integer, bool> floor_logarithm(const Rational& x, int p, int digits) {
  Integer a = Integer(std::floor(approx_logarithm(x, p))), b = 1;
  const auto sign = [&](const Integer& exponent) {
    const std::optional<int> result = compare_powers(x, b, p, exponent);
    if (!result) throw LimitError("a power is too close to another one to be told apart");
    return *result;
  };
  while (sign(a) < 0) a -= 1;
  while (sign(a + 1) >= 0) a += 1;
  for (int k = 0; k < digits; ++k) {
    a *= 10;
    b *= 10;
    int low = 0, high = 10;  // p^{a+low} <= x^b < p^{a+high}
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (sign(a + middle) >= 0 ? low : high) = middle;
    }
    a += low;
  }
  return {a, sign(a) == 0};
}

void require_logarithm(const Rational& x, int p, int digits) {
  if (x <= 0 || p < 2 || digits < 0 || digits > 100) throw DomainError("a logarithm with x <= 0, p < 2 or digits beyond 0 .. 100");
}

std::optional<Rational> short_logarithm(const Rational& x, int p) {
  for (int b = 1; b <= 12; ++b) {
    const Integer a = Integer(std::round(approx_logarithm(x, p) * b));
    if (abs(a) < 1000 && power(x, b) == power(Rational(p), int(a))) return Rational(a, Integer(b));
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> compare_powers(const Rational& x, const Integer& b, int p, const Integer& a, int bits) {
  if (x <= 0 || b < 0 || p < 2) throw DomainError("compare_powers: x <= 0, b < 0 or p < 2");
  const unsigned precision = unsigned(bits);
  ScaledInterval left = power_interval(numerator(x), b, precision), right = power_interval(denominator(x), b, precision);
  (a >= 0 ? right : left).multiply(power_interval(p, abs(a), precision), precision);
  return compare(left, right);
}

Rational logarithm_below(const Rational& x, int p, int digits) {
  require_logarithm(x, p, digits);
  if (const std::optional<Rational> exact = short_logarithm(x, p)) return *exact;
  return Rational(floor_logarithm(x, p, digits).first, pow(Integer(10), unsigned(digits)));
}

Rational logarithm_above(const Rational& x, int p, int digits) {
  require_logarithm(x, p, digits);
  if (const std::optional<Rational> exact = short_logarithm(x, p)) return *exact;
  const auto [a, equal] = floor_logarithm(x, p, digits);
  return Rational(equal ? a : Integer(a + 1), pow(Integer(10), unsigned(digits)));
}

}  // namespace limes
