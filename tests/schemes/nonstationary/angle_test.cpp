#include "schemes/nonstationary/angle.hpp"

#include "algebra/error.hpp"
#include "algebra/number/elementary.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

TEST(Angle, RationalAnglesAreExact) {
  EXPECT_EQ(read_angles("1/3"), Interval::point(Rational(1) / 3));
  EXPECT_EQ(read_angles("0.8"), Interval::point(Rational(4) / 5));
  EXPECT_EQ(read_angles("(0, 3.14]"), (Interval{0, Rational(157) / 50, true, false}));
}

TEST(Angle, MultiplesOfPiAreEnclosed) {
  const Interval pi = pi_enclosure(400);
  for (const auto& [text, factor] : {std::pair{"pi", Rational(1)},
                                     {"2*pi/7", Rational(2) / 7},
                                     {"pi/2", Rational(1) / 2},
                                     {"3*pi - 2*pi", Rational(1)},
                                     {"-pi/5", Rational(-1) / 5}}) {
    const Interval angle = read_angles(text);
    EXPECT_TRUE(angle.contains(factor * pi.lower)) << text;
    EXPECT_TRUE(angle.contains(factor * pi.upper)) << text;
    EXPECT_LT(angle.width(), power(Rational(10), -35)) << text;
  }
  const Interval range = read_angles("(0, 2*pi/7)");
  EXPECT_TRUE(range.lower_open);
  EXPECT_FALSE(range.upper_open);
  EXPECT_GT(range.upper, Rational(2) / 7 * pi.upper);
}

TEST(Angle, OtherTextsAreErrors) {
  for (const char* text : {"pi^2", "1/pi", "pi*pi", "2pi", "tau", "[0, pi", "[pi, 1]", "(pi, pi)", "pi/0"}) {
    EXPECT_THROW(read_angles(text), InputError) << text;
  }
}

}  // namespace
}  // namespace limes
