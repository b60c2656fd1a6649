#include "algebra/number/elementary.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

/// Exact partial sums of the alternating series around cos x, or below cosh x.
Rational series(const Rational& x, int terms, int sign) {
  Rational sum = 0, term = 1;
  for (int n = 0; n < terms; ++n) {
    sum += term;
    term *= Rational(sign) * x * x / ((2 * n + 1) * (2 * n + 2));
  }
  return sum;
}

TEST(Elementary, EnclosuresAreNarrowAndContainTheValue) {
  for (int k = 1; k <= 40; ++k) {
    const Rational x = Rational(k) / 7;
    for (const int bits : {20, 128, 500}) {
      const Interval cosine = cos_enclosure(x, bits), hyperbolic = cosh_enclosure(x, bits);
      EXPECT_LE(cosine.lower, series(x, 161, -1));
      EXPECT_GE(cosine.upper, series(x, 160, -1));
      EXPECT_LE(series(x, 160, 1), hyperbolic.upper);
      EXPECT_GE(series(x, 160, 1) + power(Rational(2), -600), hyperbolic.lower);
      EXPECT_LE(cosine.width(), power(Rational(2), 4 - bits) * abs(cosine.lower));
      EXPECT_LE(hyperbolic.width(), power(Rational(2), 4 - bits) * hyperbolic.lower);
    }
  }
}

TEST(Elementary, PiIsTwiceTheFirstZeroOfTheCosine) {
  // cos changes its sign at pi/2, and 0 < pi/2 < 2.
  const Interval pi = pi_enclosure(200);
  EXPECT_GT(cos_enclosure(pi.lower / 2).lower, 0);
  EXPECT_LT(cos_enclosure(pi.upper / 2).upper, 0);
  EXPECT_LT(pi.width(), power(Rational(2), -190));
  EXPECT_DOUBLE_EQ(approx_double(pi.lower), 3.14159265358979323846);
}

TEST(Elementary, ZeroIsExact) {
  EXPECT_EQ(cos_enclosure(0), Interval::point(1));
  EXPECT_EQ(cosh_enclosure(0), Interval::point(1));
  EXPECT_EQ(cos_enclosure(Rational(1) / 3), cos_enclosure(Rational(-1) / 3));
}

TEST(Elementary, ArgumentsAreLimited) {
  EXPECT_THROW(cos_enclosure(1001), DomainError);
  EXPECT_THROW(cosh_enclosure(1, 8), DomainError);
}

}  // namespace
}  // namespace limes
