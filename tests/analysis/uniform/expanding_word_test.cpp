#include "analysis/uniform/expanding_word.hpp"

#include "algebra/polynomial/schur_cohn.hpp"

#include "analysis/uniform/contractivity_bound.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

const LaurentPolynomial four_point_second = LaurentPolynomial::from_rationals(0, {Rational(-1) / 4, Rational(3) / 4, Rational(3) / 4, Rational(-1) / 4});

TEST(FiniteSections, SizeAndEntries) {
  EXPECT_EQ(FiniteSections(LaurentPolynomial::from_rationals(3, {1}), 2).size(), 1);   // B-splines: N = 0
  EXPECT_EQ(FiniteSections(four_point_second, 2).size(), 3);
  EXPECT_EQ(FiniteSections(LaurentPolynomial::from_rationals(0, {1, 1, 1, 1, 1, 1}), 3).size(), 3);
  const FiniteSections sections(four_point_second, 2);
  const RationalMatrix b0 = sections.product({0}, {});
  EXPECT_EQ(b0(0, 0), Rational(-1) / 4);  // b_0
  EXPECT_EQ(b0(0, 1), Rational(3) / 4);   // b_2
  EXPECT_EQ(b0(1, 0), 0);                 // b_{-1}
  EXPECT_EQ(b0(1, 1), Rational(3) / 4);   // b_1
}

/// Refining delta l times and restricting is the same as products of sections: the entries of all products of length l are the
/// coefficients of b^{[l]}.
TEST(FiniteSections, ProductsHoldTheIteratedSymbol) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> digit(-5, 5);
  for (int arity = 2; arity <= 3; ++arity) {
    std::vector<Rational> coefficients{1};
    for (int i = 0; i < 4; ++i) coefficients.push_back(Rational(digit(random)) / 7);
    coefficients.push_back(2);
    const LaurentPolynomial b = LaurentPolynomial::from_rationals(0, coefficients);
    const LaurentPolynomial iterated = b * b.dilated(arity);
    const FiniteSections sections(b, arity);
    for (int e = 0; e < arity; ++e) {
      for (int f = 0; f < arity; ++f) {
        const RationalMatrix product = sections.product({e, f}, {});
        for (int i = 0; i < sections.size(); ++i) {
          for (int j = 0; j < sections.size(); ++j) {
            EXPECT_EQ(product(i, j), iterated.coefficient(e + arity * f + arity * arity * j - i).constant_value());
          }
        }
      }
    }
  }
}

TEST(ExpandingWord, RadiusIsBoundedByTheNorm) {
  // rho(product)^{1/length} <= ||S_b^l||^{1/l}: a contractive scheme has no expanding word.
  const LaurentPolynomial b = LaurentPolynomial::from_rationals(0, {Rational(-1) / 8, Rational(5) / 8, Rational(5) / 8, Rational(-1) / 8});
  ASSERT_LT(exact_contractivity_norm(b, 2, 3), 1);
  const FiniteSections sections(b, 2);
  const Stop stop;
  EXPECT_TRUE(approx_expanding_words(sections, {}, 8, 0.995, 10000, stop).empty());
  EXPECT_FALSE(exact_expands(sections, {0, 1, 1}, {}));
}

TEST(ExpandingWord, FindsTheEigenvalueOneOfTheFourPointScheme) {
  const FiniteSections sections(four_point_second, 2);
  const Stop stop;
  const std::vector<WordHint> hints = approx_expanding_words(sections, {}, 4, 0.995, 10000, stop);
  ASSERT_FALSE(hints.empty());
  EXPECT_EQ(hints.front().word, std::vector<int>{0});
  EXPECT_TRUE(exact_expands(sections, {0}, {}));
  const ExpansionSigns signs = expansion_signs(sections, {0});
  EXPECT_EQ(signs.at_one.constant_value(), 0);
}

TEST(ExpandingWord, SignsAreTheCharacteristicPolynomialAtOneAndMinusOne) {
  const RationalFunction w = RationalFunction::variable(1, 0);
  const RationalFunction one = RationalFunction::constant(1, 1);
  const LaurentPolynomial b(1, 0, {w, one / (w + RationalFunction::constant(1, 3)), w * w, -w});
  const FiniteSections sections(b, 2);
  const std::vector<int> word{0, 1, 1};
  const ExpansionSigns signs = expansion_signs(sections, word);
  for (int k = -2; k <= 5; ++k) {
    const std::vector<Rational> point{Rational(k) / 3};
    const Polynomial chi = characteristic_polynomial(sections.product(word, point));
    const Rational scale = power(sections.denominator()(point), 3 * sections.size());
    EXPECT_EQ(signs.at_one(point), chi(1) * scale);
    EXPECT_EQ(signs.at_minus_one(point), (sections.size() % 2 ? -1 : 1) * chi(-1) * scale);
  }
}

TEST(ExpandingWord, TheDeterminantIsThatOfPairsOfEigenvalues) {
  const RationalFunction w = RationalFunction::variable(1, 0), one = RationalFunction::constant(1, 1);
  const FiniteSections sections({1, 0, {w, one, -one, w * w}}, 2);
  for (const std::vector<int>& word : {std::vector<int>{0}, {0, 1}}) {
    const MultivariatePolynomial determinant = expansion_determinant(sections, word);
    for (int k = -4; k <= 4; ++k) {
      const std::vector<Rational> point{Rational(k) / 5};
      if (determinant(point) <= 0) {
        EXPECT_TRUE(exact_expands(sections, word, point));
      }
    }
  }
}

}  // namespace
}  // namespace limes
