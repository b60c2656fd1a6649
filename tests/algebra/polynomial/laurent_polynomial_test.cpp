#include "algebra/polynomial/laurent_polynomial.hpp"

#include "algebra/error.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

using L = LaurentPolynomial;

L random_laurent(test::Generator& generator, int variables, int max_length) {
  std::vector<RationalFunction> coefficients;
  for (int n = generator.integer(0, max_length); n > 0; --n) {
    coefficients.push_back(generator.coin() ? RationalFunction(generator.multivariate(variables, 1, 2))
                                            : generator.rational_function(variables, 1, 2));
  }
  return {variables, generator.integer(-5, 5), coefficients};
}

TEST(LaurentPolynomial, RingAxiomsAndEvaluation) {
  test::Generator generator(41);
  for (int round = 0; round < 60; ++round) {
    const int n = generator.integer(0, 2);
    const L a = random_laurent(generator, n, 4), b = random_laurent(generator, n, 4);
    const L c = random_laurent(generator, n, 4);
    const Rational z = generator.non_zero_rational();
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ(a * b, b * a);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_TRUE((a - a).is_zero());
    EXPECT_EQ((a * b)(z), a(z) * b(z));
    EXPECT_EQ((a + b)(z), a(z) + b(z));
    EXPECT_EQ(a.shifted(3)(z), a(z) * RationalFunction::constant(n, power(z, 3)));
    EXPECT_EQ(a.dilated(3)(z), a(power(z, 3)));
    EXPECT_EQ(a.alternated()(z), a(-z));
    EXPECT_EQ((a * b).differentiated(), a.differentiated() * b + a * b.differentiated());
    EXPECT_EQ(power(a, 3), a * a * a);
    L twice = a;
    twice += twice;
    EXPECT_EQ(twice, RationalFunction::constant(n, 2) * a);
    if (!a.is_zero() && !b.is_zero()) {
      EXPECT_EQ((a * b).lowest(), a.lowest() + b.lowest());
      EXPECT_EQ((a * b).highest(), a.highest() + b.highest());
    }
  }
}

TEST(LaurentPolynomial, TrimsBothEnds) {
  const L a = L::from_rationals(-3, {0, 0, 5, 0, 7, 0});
  EXPECT_EQ(a.lowest(), -1);
  EXPECT_EQ(a.highest(), 1);
  EXPECT_EQ(a.rational_coefficients(), (std::vector<Rational>{5, 0, 7}));
  EXPECT_EQ(a.coefficient(1).constant_value(), 7);
  EXPECT_TRUE(a.coefficient(2).is_zero());
  EXPECT_TRUE(a.coefficient(-2).is_zero());
  EXPECT_TRUE(L::from_rationals(4, {0, 0}).is_zero());
  EXPECT_EQ(L::from_rationals(4, {0, 0}), L(0));
  EXPECT_THROW(L(0).lowest(), DomainError);
  EXPECT_THROW(L(1, 0, {RationalFunction(2)}), DomainError);
  EXPECT_THROW(a(Rational(0)), DomainError);
  // The constant term disappears under d/dz.
  EXPECT_EQ(L::from_rationals(0, {3, 1}).differentiated(), L::from_rationals(0, {1}));
}

TEST(LaurentPolynomial, DivisionIdentity) {
  test::Generator generator(42);
  for (int round = 0; round < 60; ++round) {
    const int n = generator.integer(0, 2);
    const L a = random_laurent(generator, n, 7);
    L d = random_laurent(generator, n, 3);
    const auto constant = [&] { return RationalFunction::constant(n, generator.non_zero_rational()) * sigma(n, 1); };
    d = (d.is_zero() ? d : d.shifted(-d.lowest() + 1)) + constant();
    d += constant().shifted(d.highest() + 1);
    const auto [quotient, remainder] = divide(a, d);
    EXPECT_EQ(quotient * d + remainder, a);
    if (!remainder.is_zero()) {
      EXPECT_GE(remainder.lowest(), a.lowest());
      EXPECT_LT(remainder.highest(), a.lowest() + d.highest());
    }
    EXPECT_EQ(divide(a * d, d).first, a);
    EXPECT_TRUE(divide(a * d, d).second.is_zero());
  }
}

TEST(LaurentPolynomial, DivisorsMustStartAtZeroWithConstantLead) {
  const L a = sigma(1, 4), w(1, 0, {RationalFunction::constant(1, 1), RationalFunction::variable(1, 0)});
  EXPECT_THROW(divide(a, L(1)), DomainError);
  EXPECT_THROW(divide(a, sigma(1, 2).shifted(1)), DomainError);
  EXPECT_THROW(divide(a, w), DomainError);
  EXPECT_THROW(divide(a, sigma(2, 2)), DomainError);
  EXPECT_EQ(divide(a, sigma(1, 2)).first, sigma(1, 2).dilated(2));
}

TEST(LaurentPolynomial, FourPointSchemeHasTwoSumRules) {
  // -w, 0, 1/2+w, 1, 1/2+w, 0, -w
  const auto w = RationalFunction::variable(1, 0);
  const auto c = [](Rational x) { return RationalFunction::constant(1, x); };
  const L a(1, -3, {-w, c(0), c(Rational(1) / 2) + w, c(1), c(Rational(1) / 2) + w, c(0), -w});
  EXPECT_EQ(a(Rational(1)), c(2));
  EXPECT_TRUE(divide(a, power(sigma(1, 2), 2)).second.is_zero());
  EXPECT_FALSE(divide(a, power(sigma(1, 2), 3)).second.is_zero());
  const L at = a.substitute(0, Rational(1) / 16);
  EXPECT_TRUE(divide(at, power(sigma(1, 2), 4)).second.is_zero());
  EXPECT_EQ(at.at(std::vector<Rational>{0}), a.at(std::vector<Rational>{Rational(1) / 16}));
  EXPECT_EQ(a.substitute(0, Rational(0)).length(), 3);
}

}  // namespace
}  // namespace limes
