#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace limes {
namespace {

const VariableNames none;
const VariableNames w_only = {"w"};
const VariableNames xy = {"x", "y"};

Rational constant(const std::string& text) { return read_rational_function(text, none).constant_value(); }

void expect_error(const std::string& text, const VariableNames& names, int column, const std::string& reason) {
  try {
    read_rational_function(text, names);
    ADD_FAILURE() << "no error for " << text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.position().column, column) << text << ": " << error.what();
    EXPECT_EQ(error.reason(), reason) << text;
  }
}

TEST(ToRationalFunction, ConstantsAreExact) {
  EXPECT_EQ(constant("0.1+0.2"), Rational(3, 10));
  EXPECT_EQ(constant("2^-1"), Rational(1, 2));
  EXPECT_EQ(constant("-2^2"), -4);
  EXPECT_EQ(constant("(-2)^2"), 4);
  EXPECT_EQ(constant("1-2-3"), -4);
  EXPECT_EQ(constant("1-2-3+4-5-6+7"), -4);
  EXPECT_EQ(constant("12/2/3"), 2);
  EXPECT_EQ(constant("1/2/3*0"), 0);
  EXPECT_EQ(constant("0^0"), 1);
  EXPECT_EQ(constant("1e-3*0.0141"), Rational(141, 10000000));
}

TEST(ToRationalFunction, Polynomials) {
  const RationalFunction f = read_rational_function("-w^2 + (1/2+w)*(1/2-w) + 1/4", w_only);
  const Rational at_three[] = {3};
  EXPECT_EQ(f(at_three), Rational(-35, 2));
  EXPECT_TRUE(f.is_polynomial());
  EXPECT_EQ(read_rational_function("(w^2-1)/(w-1)", w_only), read_rational_function("w+1", w_only));
  EXPECT_EQ(read_rational_function("w^-2", w_only), read_rational_function("1/w/w", w_only));
}

TEST(ToRationalFunction, ErrorsSayWhereAndWhat) {
  expect_error("1+v", w_only, 3, "unknown name 'v' (known: w)");
  expect_error("z", xy, 1, "unknown name 'z' (known: x, y)");
  expect_error("w", none, 1, "unknown name 'w' (no names are known here)");
  expect_error("1+f(2)", w_only, 3, "a function such as 'f' is not allowed here");
  expect_error("[1]", w_only, 1, "a list is not allowed here");
  expect_error("1/(w-w)", w_only, 2, "division by zero");
  expect_error("1/0", none, 2, "division by zero");
  expect_error("2*0^-1", none, 4, "division by zero");
  expect_error("(w^2-1-(w-1)*(w+1))^-3", w_only, 20, "division by zero");
}

TEST(ToRationalFunction, WhatIsTooLargeIsRefusedQuickly) {
  std::string literals = "1";
  for (int i = 0; i < 900; ++i) literals += "*1e100";
  std::string primes = "0";
  for (int i = 1; i < 12000; ++i) primes += "+1/" + std::to_string(2 * i + 1);
  std::string powers = "0";
  for (int i = 0; i < 6000; ++i) powers += "+(x+y+1)^300";
  std::string poles = "0";
  for (int i = 1; i < 5000; ++i) poles += "+1/(x-" + std::to_string(i) + "*y)";
  const std::string hostile[] = {"(((1+x)^1000)^1000)^1000",
                                 "(1+x)^1001",
                                 "((1+x)^1000)*x",
                                 "(1+x)^999/(1+y)^999*(1+x*y)",
                                 "(x+y+x*y+1)^999",
                                 "((2^1000)^1000)^1000",
                                 "((1/3)^1000)^1000",
                                 "((((x+1)^10)^10)^10)^10",
                                 "(x+1e9999)^1000",
                                 "(x+1e-9999)^1000",
                                 "1/(1+x+y)^400+1/(1+x-y)^400",
                                 "(1/(1+x+y)^999+1)^2",
                                 literals,
                                 primes,
                                 powers,
                                 poles};
  for (const auto& text : hostile) {
    EXPECT_THROW(read_rational_function(text, xy), LimitError) << text.substr(0, 60);
  }
}

TEST(ToRationalFunction, WhatIsReasonableIsAllowed) {
  EXPECT_EQ(read_rational_function("(1+w)^1000", w_only).numerator().term_count(), 1001u);
  EXPECT_EQ(read_rational_function("(1+x+y)^100", xy).numerator().term_count(), 5151u);
  EXPECT_EQ(read_rational_function("(1+x+y+z)^30*(1+x-y+2*z)^30", {"x", "y", "z"}).numerator().degree(2), 60);
  EXPECT_EQ(constant("2^1000 - 2^999 - 2^999"), 0);
  EXPECT_EQ(constant("(2^1000)^30/(2^1000)^30"), 1);
  EXPECT_EQ(read_rational_function("1/(1+x+y)^20 - 1/(1+x-y)^20", xy).denominator().degree(0), 40);
}

// An expression and its value at a point, built together.
struct Sample {
  std::string text;
  Rational value;
};

Sample random_sample(std::mt19937& random, int depth, const Rational& x, const Rational& y) {
  if (depth == 0) {
    switch (random() % 4) {
      case 0:
        return {"x", x};
      case 1:
        return {"y", y};
      case 2:
        return {"0.75", Rational(3, 4)};
      default: {
        const int n = int(random() % 9);
        return {std::to_string(n), n};
      }
    }
  }
  const Sample a = random_sample(random, depth - 1, x, y);
  const Sample b = random_sample(random, depth - 1, x, y);
  switch (random() % 6) {
    case 0:
      return {"(" + a.text + "+" + b.text + ")", a.value + b.value};
    case 1:
      return {"(" + a.text + "-" + b.text + ")", a.value - b.value};
    case 2:
      return {"(-" + a.text + ")", -a.value};
    case 3:
      return {"(" + a.text + "^2)", a.value * a.value};
    case 4:
      if (b.value != 0) return {"(" + a.text + "/" + b.text + ")", a.value / b.value};
      [[fallthrough]];
    default:
      return {"(" + a.text + "*" + b.text + ")", a.value * b.value};
  }
}

TEST(ToRationalFunction, AgreesWithArithmeticAtAPoint) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Rational point[] = {Rational(int(random() % 1000) + 7, 13), Rational(-int(random() % 1000) - 5, 17)};
    const Sample sample = random_sample(random, 4, point[0], point[1]);
    const RationalFunction f = read_rational_function(sample.text, xy);
    EXPECT_EQ(f(point), sample.value) << sample.text;
    EXPECT_EQ(read_rational_function(to_string(f, xy), xy), f) << sample.text;
  }
}

}  // namespace
}  // namespace limes
