#include "analysis/uniform/contractivity_bound.hpp"

#include "algebra/error.hpp"
#include "analysis/uniform/difference_symbol.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

LaurentPolynomial random_symbol(std::mt19937& random, int length) {
  std::vector<Rational> coefficients;
  std::uniform_int_distribution<int> digit(-9, 9);
  for (int i = 0; i < length; ++i) coefficients.push_back(Rational(digit(random)) / (1 + std::abs(digit(random))));
  coefficients.front() = 1;
  coefficients.back() = Rational(1) / 3;
  return LaurentPolynomial::from_rationals(-2, coefficients);
}

/// The definition, literally: products of dilated Laurent polynomials.
Rational norm_by_definition(const LaurentPolynomial& b, int arity, int level) {
  LaurentPolynomial iterated = b;
  int stride = arity;
  for (int l = 1; l < level; ++l, stride *= arity) iterated = iterated * b.dilated(stride);
  Rational greatest = 0;
  for (int residue = 0; residue < stride; ++residue) {
    Rational sum = 0;
    for (int i = iterated.lowest(); i <= iterated.highest(); ++i) {
      if (((i - residue) % stride + stride) % stride == 0) sum += abs(iterated.coefficient(i).constant_value());
    }
    greatest = std::max(greatest, sum);
  }
  return greatest;
}

TEST(ContractivityNorm, AgreesWithTheDefinition) {
  std::mt19937 random(7);
  for (int arity = 2; arity <= 4; ++arity) {
    for (int length = 1; length <= 6; ++length) {
      const LaurentPolynomial b = random_symbol(random, std::max(length, 2));
      for (int level = 1; level <= (arity == 2 ? 4 : 3); ++level) {
        EXPECT_EQ(exact_contractivity_norm(b, arity, level), norm_by_definition(b, arity, level)) << arity << " " << length << " " << level;
      }
    }
  }
}

TEST(ContractivityNorm, IsSubmultiplicativeAndInvariantUnderReversalAndShift) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 10; ++trial) {
    const LaurentPolynomial b = random_symbol(random, 5);
    std::vector<Rational> reversed = b.rational_coefficients();
    std::reverse(reversed.begin(), reversed.end());
    const Rational two = exact_contractivity_norm(b, 2, 2);
    const Rational three = exact_contractivity_norm(b, 2, 3);
    EXPECT_LE(exact_contractivity_norm(b, 2, 5), two * three);
    EXPECT_EQ(exact_contractivity_norm(b.shifted(5), 2, 3), three);
    EXPECT_EQ(exact_contractivity_norm(LaurentPolynomial::from_rationals(0, reversed), 2, 3), three);
    EXPECT_EQ(exact_contractivity_norm(-b, 2, 3), three);
  }
}

TEST(ContractivityNorm, NumbersOfManyLimbsAreExact) {
  // b = c (1 - z) / 2: b^{[l]} has 2^l coefficients of modulus (c/2)^l, one in each row.
  const Rational c = Rational(Integer("123456789012345678901234567890123456789")) / Rational(Integer("987654321098765432109876543210987654321"));
  const LaurentPolynomial b = LaurentPolynomial::from_rationals(0, {c / 2, -c / 2});
  for (int level = 1; level <= 12; ++level) {
    EXPECT_EQ(exact_contractivity_norm(b, 2, level), power(c, level) * power(Rational(2), -level)) << level;
  }
}

TEST(ContractivityNorm, NumbersOfEveryWidthAgreeWithTheDefinition) {
  // From one limb on, with weights of one limb and of more.
  std::mt19937 random(13);
  std::uniform_int_distribution<int> digit(0, 9);
  for (const int digits : {1, 4, 8, 12, 18, 19, 20, 40}) {
    std::vector<Rational> coefficients;
    for (int i = 0; i < 4; ++i) {
      std::string text = i % 2 == 0 ? "-9" : "9";
      for (int k = 1; k < digits; ++k) text += std::to_string(digit(random));
      coefficients.push_back(Rational(Integer(text)));
    }
    const LaurentPolynomial b = LaurentPolynomial::from_rationals(0, coefficients);
    for (int level = 1; level <= 6; ++level) {
      EXPECT_EQ(exact_contractivity_norm(b, 2, level), norm_by_definition(b, 2, level)) << digits << " " << level;
    }
  }
}

// The second differences of the four-point scheme at w = 1/16 have norm 1 on every level: C^2 is missed by a hair.
TEST(ContractivityNorm, FourPointSecondDifferencesHaveNormOne) {
  const LaurentPolynomial b = LaurentPolynomial::from_rationals(0, {Rational(-1) / 4, Rational(3) / 4, Rational(3) / 4, Rational(-1) / 4});
  for (int level = 1; level <= 8; ++level) EXPECT_EQ(exact_contractivity_norm(b, 2, level), 1) << level;
}

TEST(ContractivityNorm, RefusesWhatWouldNotFit) {
  const LaurentPolynomial b = LaurentPolynomial::from_rationals(0, {Rational(1) / 2, Rational(1) / 2});
  EXPECT_THROW(exact_contractivity_norm(b, 2, 40), LimitError);
  EXPECT_THROW(exact_contractivity_norm(b, 2, 0), DomainError);
}

TEST(ContractivityNorm, FloatingHintsAgreeWithExactNorms) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 10; ++trial) {
    const LaurentPolynomial b = random_symbol(random, 4);
    const std::vector<double> hints = approx_contractivity_norms(b, 2, {}, 6, 0);
    ASSERT_EQ(hints.size(), 6u);
    for (int level = 1; level <= 6; ++level) {
      const double exact = approx_double(exact_contractivity_norm(b, 2, level));
      EXPECT_NEAR(hints[level - 1], exact, 1e-9 * exact);
    }
  }
}

const RationalFunction w = RationalFunction::variable(1, 0);
RationalFunction number(const Rational& x) { return RationalFunction::constant(1, x); }

Mask four_point() {
  const RationalFunction zero(1);
  return {2, LaurentPolynomial(1, -3, {-w, zero, w + number(Rational(1) / 2), number(1), w + number(Rational(1) / 2), zero, -w})};
}

bool proves(const Mask& mask, int m, const Interval& interval, int level) {
  const Stop stop;
  const LaurentPolynomial b = *difference_symbol(mask, m + 1);
  return ContractivityBound(b, common_denominator(b), mask.arity, {interval}).proves_contraction(level, {}, stop);
}

TEST(ContractivityBound, NeverClaimsMoreThanThePointwiseNorm) {
  // Wherever a box is proved, the exact norm is below 1 at many of its points.
  std::mt19937 random(5);
  std::uniform_int_distribution<int> numerator(1, 249);
  const LaurentPolynomial b = *difference_symbol(four_point(), 2);
  int proved = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Rational lower = Rational(numerator(random)) / 1000;
    Rational upper = lower + Rational(numerator(random)) / 5000;
    for (int level = 1; level <= 6; ++level) {
      if (!proves(four_point(), 1, {lower, upper}, level)) continue;
      ++proved;
      for (int k = 0; k <= 8; ++k) {
        const std::vector<Rational> point{lower + (upper - lower) * k / 8};
        EXPECT_LT(exact_contractivity_norm(b.at(point), 2, level), 1);
      }
    }
  }
  EXPECT_GT(proved, 20);
}

TEST(ContractivityBound, OnAPointItIsTheNorm) {
  const LaurentPolynomial b = *difference_symbol(four_point(), 2);
  for (int k = 1; k < 50; ++k) {
    const Rational value = Rational(k) / 200;
    for (int level = 1; level <= 5; ++level) {
      EXPECT_EQ(proves(four_point(), 1, Interval::point(value), level),
                exact_contractivity_norm(b.at(std::vector<Rational>{value}), 2, level) < 1) << k << " " << level;
    }
  }
}

TEST(ContractivityBound, DividesTheVanishingFactorAtOpenEndsOnly) {
  // 1 - ||S_b^2|| has the factor w.
  EXPECT_TRUE(proves(four_point(), 1, {0, Rational(1) / 16, true, false}, 2));
  EXPECT_FALSE(proves(four_point(), 1, {0, Rational(1) / 16, false, false}, 2));
  EXPECT_FALSE(proves(four_point(), 1, {Rational(-1) / 1000, Rational(1) / 16, true, false}, 2));
}

TEST(ContractivityBound, DenominatorsMustHaveAStrictSign) {
  const LaurentPolynomial b(1, 0, {number(Rational(1) / 100) / w});
  const Stop stop;
  EXPECT_TRUE(ContractivityBound(b, common_denominator(b), 2, {{1, 2}}).proves_contraction(1, {}, stop));
  EXPECT_TRUE(ContractivityBound(b, common_denominator(b), 2, {{-2, -1}}).proves_contraction(1, {}, stop));
  EXPECT_FALSE(ContractivityBound(b, common_denominator(b), 2, {{-1, 1}}).proves_contraction(1, {}, stop));
  EXPECT_FALSE(ContractivityBound(b, common_denominator(b), 2, {{0, 1, true, false}}).proves_contraction(1, {}, stop));
}

TEST(ContractivityBound, TwoParameters) {
  // |x| + |y| < 1 on boxes inside of the diamond only.
  const RationalFunction x = RationalFunction::variable(2, 0);
  const RationalFunction y = RationalFunction::variable(2, 1);
  const LaurentPolynomial b(2, 0, {x, RationalFunction(2), y});
  const Stop stop;
  const auto box = [](Rational x0, Rational x1, Rational y0, Rational y1) { return Box{{x0, x1}, {y0, y1}}; };
  EXPECT_TRUE(ContractivityBound(b, common_denominator(b), 2, box(0, Rational(1) / 2, 0, Rational(49) / 100)).proves_contraction(1, {}, stop));
  EXPECT_FALSE(ContractivityBound(b, common_denominator(b), 2, box(0, Rational(1) / 2, 0, Rational(1) / 2)).proves_contraction(1, {}, stop));
  EXPECT_TRUE(ContractivityBound(b, common_denominator(b), 2, box(-Rational(1) / 2, 0, -Rational(49) / 100, 0)).proves_contraction(1, {}, stop));
  // Both ends open: 1 - x - y vanishes in one corner only, which no product of powers divides out.
  EXPECT_FALSE(ContractivityBound(b, common_denominator(b), 2, {{0, Rational(1) / 2, false, true}, {0, Rational(1) / 2, false, true}}).proves_contraction(1, {}, stop));
}

}  // namespace
}  // namespace limes
