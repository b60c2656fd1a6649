#include "algebra/number/power_comparison.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace limes;

TEST(PowerComparison, SmallPowersAreExact) {
  EXPECT_EQ(compare_powers(Rational(9), 3, 3, 6), 0);
  EXPECT_EQ(compare_powers(Rational(9, 2), 1, 2, 2), 1);
  EXPECT_EQ(compare_powers(Rational(1, 4), 5, 2, -10), 0);
  EXPECT_EQ(compare_powers(Rational(1, 4), 5, 2, -9), -1);
  EXPECT_THROW(compare_powers(Rational(0), 1, 2, 1), DomainError);
}

TEST(PowerComparison, EqualLongPowersAreNotToldApart) {
  EXPECT_EQ(compare_powers(Rational(2), 1000000, 2, 1000000), 0);  // mantissa 1
  EXPECT_EQ(compare_powers(Rational(9), 1000000, 3, 2000000), std::nullopt);
  EXPECT_EQ(compare_powers(Rational(9), 1000000, 3, 2000001), -1);
}

TEST(PowerComparison, LogarithmsEncloseTheValue) {
  for (int n = 2; n < 60; ++n) {
    for (int p : {2, 3, 5}) {
      const Rational x = Rational(n) / 7, below = logarithm_below(x, p, 8), above = logarithm_above(x, p, 8);
      EXPECT_LE(below, above);
      EXPECT_LE(above - below, Rational(1, 100000000));
      EXPECT_NEAR(approx_double(below), std::log(n / 7.0) / std::log(p), 2e-8);
    }
  }
}

TEST(PowerComparison, RationalLogarithmsAreExact) {
  EXPECT_EQ(logarithm_below(Rational(27), 9, 5), Rational(3, 2));
  EXPECT_EQ(logarithm_above(Rational(1, 8), 4, 5), Rational(-3, 2));
  EXPECT_EQ(logarithm_below(Rational(1), 2, 30), 0);
}

TEST(PowerComparison, ThirtyDigits) {
  const Rational below = logarithm_below(Rational(3), 2, 30);
  EXPECT_EQ(to_decimal(below, 31, Rounding::nearest), "1.584962500721156181453738943947");
}
