#include "analysis/uniform/difference_symbol.hpp"

#include "algebra/expression/expression.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

Mask b_spline(int degree) {
  const RationalFunction scale = RationalFunction::constant(0, power(Rational(2), -degree));
  return {2, scale * power(sigma(0, 2), degree + 1)};
}

Mask deslauriers_dubuc(int points) {
  return uniform_mask(InsertionRule(read_expression("at(f(" + std::to_string(points - 1) + ",0),1/2)"), {}));
}

TEST(DifferenceSymbol, UndoesTheFactor) {
  const Mask mask = deslauriers_dubuc(6);
  for (int k = 0; k <= 6; ++k) {
    const auto b = difference_symbol(mask, k);
    ASSERT_TRUE(b.has_value());
    const LaurentPolynomial a = RationalFunction::constant(0, power(Rational(2), 1 - k)) * (power(sigma(0, 2), k) * *b);
    EXPECT_EQ(a, mask.symbol);
    EXPECT_EQ((*b)(1), RationalFunction::constant(0, 1));
  }
  EXPECT_FALSE(difference_symbol(mask, 7).has_value());
  EXPECT_TRUE(sum_rule_remainder(mask, 6).is_zero());
  EXPECT_FALSE(sum_rule_remainder(mask, 7).is_zero());
}

TEST(DifferenceSymbol, OfABSplineIsAMonomial) {
  for (int degree = 1; degree <= 8; ++degree) {
    EXPECT_EQ(sum_rule_order(b_spline(degree)), degree + 1);
    EXPECT_EQ(difference_symbol(b_spline(degree), degree + 1)->length(), 1);
  }
}

// Deslauriers & Dubuc 1989: 2n points reproduce degree 2n - 1.
TEST(PolynomialDegrees, OfDeslauriersDubuc) {
  for (int points = 2; points <= 12; points += 2) {
    const PolynomialDegrees degrees = polynomial_degrees(deslauriers_dubuc(points));
    EXPECT_EQ(degrees.generation, points - 1);
    EXPECT_EQ(degrees.reproduction, points - 1);
    EXPECT_TRUE(degrees.parameter_shift.is_zero());
  }
}

TEST(PolynomialDegrees, BSplinesReproduceLinearFunctionsOnly) {
  for (int degree = 1; degree <= 6; ++degree) {
    const PolynomialDegrees degrees = polynomial_degrees(b_spline(degree));
    EXPECT_EQ(degrees.generation, degree);
    EXPECT_EQ(degrees.reproduction, 1);
    EXPECT_EQ(degrees.parameter_shift, RationalFunction::constant(0, Rational(degree + 1) / 2));
  }
}

// Dyn, Floater & Hormann 2004: cubic precision with the dual parametrisation.
TEST(PolynomialDegrees, OfTheDualFourPointScheme) {
  std::vector<Rational> mask;
  for (const int c : {-5, -7, 35, 105, 105, 35, -7, -5}) mask.push_back(Rational(c) / 128);
  const PolynomialDegrees degrees = polynomial_degrees({2, LaurentPolynomial::from_rationals(-4, mask)});
  EXPECT_EQ(degrees.reproduction, 3);
  EXPECT_EQ(degrees.parameter_shift, RationalFunction::constant(0, Rational(-1) / 2));
}

// Reproduction is checked against its meaning: samples of t^d refine to samples.
TEST(PolynomialDegrees, ReproductionIsWhatTheSchemeDoes) {
  std::vector<Rational> coefficients;
  for (const int c : {-5, -7, 35, 105, 105, 35, -7, -5}) coefficients.push_back(Rational(c) / 128);
  const Mask mask{2, LaurentPolynomial::from_rationals(-4, coefficients)};
  const PolynomialDegrees degrees = polynomial_degrees(mask);
  const Rational shift = degrees.parameter_shift.constant_value();
  for (int d = 0; d <= 5; ++d) {
    bool reproduced = true;
    for (int i = -3; i <= 3; ++i) {
      Rational refined = 0;
      for (int j = -20; j <= 20; ++j) refined += mask.symbol.coefficient(i - 2 * j).constant_value() * power(j + shift, d);
      reproduced = reproduced && refined == power((i + shift) / 2, d);
    }
    EXPECT_EQ(reproduced, d <= degrees.reproduction) << d;
  }
}

TEST(PolynomialDegrees, AMaskWithTheWrongSumKnowsNothing) {
  EXPECT_EQ(polynomial_degrees({2, LaurentPolynomial::from_rationals(0, {Rational(9) / 10, Rational(9) / 5, Rational(9) / 10})}).generation, -1);
}

}  // namespace
}  // namespace limes
