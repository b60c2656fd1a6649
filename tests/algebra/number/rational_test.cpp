#include "algebra/number/rational.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

Rational q(const char* text) { return read_rational(text); }

TEST(Rational, PrintsInLowestTerms) {
  EXPECT_EQ(to_string(Rational(0)), "0");
  EXPECT_EQ(to_string(q("-6/4")), "-3/2");
  EXPECT_EQ(to_string(q("8/4")), "2");
  EXPECT_EQ(to_string(Integer(-12)), "-12");
  EXPECT_EQ(to_string(power(Rational(10), 60)), "1" + std::string(60, '0'));
}

TEST(Rational, PowerAgreesWithRepeatedMultiplication) {
  test::Generator generator(1);
  for (int round = 0; round < 50; ++round) {
    const Rational x = generator.non_zero_rational();
    Rational product = 1;
    for (int e = 0; e < 8; ++e, product *= x) {
      EXPECT_EQ(power(x, e), product);
      EXPECT_EQ(power(x, -e), 1 / product);
      EXPECT_GT(denominator(power(x, -e)), 0);
    }
  }
  EXPECT_EQ(power(Rational(0), 0), 1);
  EXPECT_EQ(power(Rational(0), 3), 0);
  EXPECT_THROW(power(Rational(0), -1), DomainError);
}

TEST(Rational, ApproxDoubleIsNearest) {
  EXPECT_EQ(approx_double(q("1/3")), 1.0 / 3.0);
  EXPECT_EQ(approx_double(q("-0.1")), -0.1);
  EXPECT_EQ(approx_double(q("0.1000000000000000055511151231257827021181583404541015625")), 0.1);
  // Just above the middle of 1 and its neighbour; truncation would give 1.
  const Rational epsilon = power(Rational(2), -52);
  EXPECT_EQ(approx_double(1 + epsilon * q("51/100")), 1 + std::ldexp(1.0, -52));
  EXPECT_EQ(approx_double(1 + epsilon * q("49/100")), 1.0);
  EXPECT_EQ(approx_double(-1 - epsilon * q("51/100")), -1 - std::ldexp(1.0, -52));
  EXPECT_EQ(approx_double(q("1e-400")), 0.0);
  EXPECT_EQ(approx_double(power(Rational(3), 100)), std::pow(3.0, 100));
}

TEST(Rational, ToDecimalGolden) {
  const auto down = Rounding::down, up = Rounding::up, nearest = Rounding::nearest;
  EXPECT_EQ(to_decimal(q("0"), 5, up), "0");
  EXPECT_EQ(to_decimal(q("1/3"), 4, down), "0.3333");
  EXPECT_EQ(to_decimal(q("1/3"), 4, up), "0.3334");
  EXPECT_EQ(to_decimal(q("-1/3"), 4, down), "-0.3334");
  EXPECT_EQ(to_decimal(q("-1/3"), 4, up), "-0.3333");
  EXPECT_EQ(to_decimal(q("2/3"), 4, nearest), "0.6667");
  EXPECT_EQ(to_decimal(q("1/8"), 10, down), "0.125");
  EXPECT_EQ(to_decimal(q("-1000"), 2, up), "-1000");
  EXPECT_EQ(to_decimal(q("999.96"), 4, nearest), "1000");
  EXPECT_EQ(to_decimal(q("999.96"), 4, down), "999.9");
  EXPECT_EQ(to_decimal(q("-999.96"), 4, down), "-1000");
  EXPECT_EQ(to_decimal(q("0.099999"), 3, up), "0.100");
  EXPECT_EQ(to_decimal(q("123456"), 3, up), "124000");
  EXPECT_EQ(to_decimal(q("1e-30"), 3, up), "1e-30");
  EXPECT_EQ(to_decimal(q("-12.5e40"), 3, up), "-1.25e41");
  EXPECT_EQ(to_decimal(q("1/3") * power(Rational(10), -50), 3, up), "3.34e-51");
  EXPECT_THROW(to_decimal(q("1"), 0, up), DomainError);
  EXPECT_THROW(to_decimal(q("1"), 1001, up), DomainError);
}

TEST(Rational, ToDecimalEnclosesWithinOneUnit) {
  test::Generator generator(2);
  for (int round = 0; round < 400; ++round) {
    const Rational x = generator.non_zero_rational(10000) * power(Rational(10), generator.integer(-40, 40));
    const int digits = generator.integer(1, 12);
    const Rational low = read_rational(to_decimal(x, digits, Rounding::down));
    const Rational high = read_rational(to_decimal(x, digits, Rounding::up));
    const Rational near = read_rational(to_decimal(x, digits, Rounding::nearest));
    EXPECT_LE(low, x);
    EXPECT_LE(x, high);
    EXPECT_TRUE(near == low || near == high);
    EXPECT_LE(abs(x - near) * 2, high - low);
    // One unit of the last digit is at most 10^{1-digits} times the modulus.
    EXPECT_LE((high - low) * power(Rational(10), digits - 1), abs(x) * (low == high ? Rational(0) : Rational(1)));
  }
}

TEST(Rational, ToDecimalAtPowersOfTen) {
  for (int e = -30; e <= 30; ++e) {
    const Rational x = power(Rational(10), e), less = x - power(Rational(10), e - 20);
    for (const auto rounding : {Rounding::down, Rounding::up, Rounding::nearest}) {
      EXPECT_EQ(read_rational(to_decimal(x, 3, rounding)), x);
    }
    EXPECT_EQ(read_rational(to_decimal(less, 3, Rounding::up)), x);
    EXPECT_EQ(read_rational(to_decimal(less, 3, Rounding::down)), x * q("0.999"));
  }
}

TEST(Rational, SimplestBetween) {
  EXPECT_EQ(simplest_between(q("0.3"), q("0.34")), q("1/3"));
  EXPECT_EQ(simplest_between(q("3.14"), q("3.15")), q("22/7"));
  EXPECT_EQ(simplest_between(q("-1/2"), q("1/3")), 0);
  EXPECT_EQ(simplest_between(q("-0.34"), q("-0.3")), q("-1/3"));
  EXPECT_EQ(simplest_between(q("5/7"), q("5/7")), q("5/7"));
  EXPECT_EQ(simplest_between(q("2"), q("3")), 2);
  EXPECT_EQ(simplest_between(q("-3"), q("-2")), -2);
  EXPECT_THROW(simplest_between(q("2"), q("1")), DomainError);
}

TEST(Rational, SimplestBetweenHasLeastDenominatorByExhaustion) {
  test::Generator generator(3);
  for (int round = 0; round < 200; ++round) {
    const Rational a = generator.rational(60), b = generator.rational(60);
    const Rational lower = a < b ? a : b, upper = a < b ? b : a;
    const Rational x = simplest_between(lower, upper);
    EXPECT_TRUE(lower <= x && x <= upper);
    for (Integer d = 1; d < denominator(x); ++d) {
      const Rational scaled = upper * Rational(d);
      Integer floor;
      mpz_fdiv_q(floor.backend().data(), mpq_numref(scaled.backend().data()), mpq_denref(scaled.backend().data()));
      EXPECT_LT(Rational(floor, d), lower) << to_string(x);
    }
  }
}

}  // namespace
}  // namespace limes
