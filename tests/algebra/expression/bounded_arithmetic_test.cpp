#include "algebra/expression/bounded_arithmetic.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

const RationalFunction w = RationalFunction::variable(1, 0);
RationalFunction number(const Rational& x) { return RationalFunction::constant(1, x); }

TEST(BoundedArithmetic, AgreesWithTheOperators) {
  BoundedArithmetic arithmetic;
  const std::vector<RationalFunction> samples{number(0), number(Rational(-2) / 3), w, w * w - number(1), number(1) / (w + number(2))};
  for (const RationalFunction& a : samples) {
    for (const RationalFunction& b : samples) {
      EXPECT_EQ(arithmetic.apply('+', a, b, 1), a + b);
      EXPECT_EQ(arithmetic.apply('-', a, b, 1), a - b);
      EXPECT_EQ(arithmetic.apply('*', a, b, 1), a * b);
      if (b.is_zero()) continue;
      EXPECT_EQ(arithmetic.apply('/', a, b, 1), a / b);
    }
    EXPECT_EQ(arithmetic.power(a, 3, 1), a * a * a);
    if (a.is_zero()) continue;
    EXPECT_EQ(arithmetic.power(a, -2, 1), number(1) / (a * a));
  }
}

TEST(BoundedArithmetic, ErrorsPointToTheColumn) {
  BoundedArithmetic arithmetic;
  const auto column = [](auto work) {
    try {
      work();
    } catch (const InputError& error) {
      return error.position().column;
    }
    return 0;
  };
  EXPECT_EQ(column([&] { arithmetic.apply('/', w, number(0), 7); }), 7);
  EXPECT_EQ(column([&] { arithmetic.power(number(0), -1, 8); }), 8);
  EXPECT_EQ(column([&] { arithmetic.power(w, 1001, 9); }), 9);
}

TEST(BoundedArithmetic, ManySmallOperationsAreLimitedTogether) {
  const RationalFunction base = w + number(1);
  const auto repeat = [&](int times) {
    BoundedArithmetic arithmetic;
    for (int k = 0; k < times; ++k) arithmetic.power(base, 900, 1);
  };
  EXPECT_NO_THROW(repeat(2));
  EXPECT_THROW(repeat(1000000), LimitError);
}

}  // namespace
}  // namespace limes
