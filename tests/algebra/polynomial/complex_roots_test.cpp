#include "algebra/polynomial/complex_roots.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

Polynomial linear(const Rational& root) { return Polynomial({-root, 1}); }

TEST(ComplexRoots, RationalRootsAreExactAndSortedByModulus) {
  const Polynomial a = linear(Rational(1) / 4) * linear(Rational(1) / 4) * linear(-1) * linear(Rational(1) / 2) * linear(0);
  const std::vector<ComplexRoot> roots = enclose_complex_roots(a);
  ASSERT_EQ(roots.size(), 4u);
  const std::vector<Rational> expected{-1, Rational(1) / 2, Rational(1) / 4, 0};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_TRUE(roots[k].is_real());
    EXPECT_EQ(roots[k].re, Interval::point(expected[k]));
    EXPECT_EQ(roots[k].modulus, Interval::point(abs(expected[k])));
  }
  EXPECT_EQ(roots[2].multiplicity, 2);
}

TEST(ComplexRoots, ConjugatePairs) {
  const std::vector<ComplexRoot> roots = enclose_complex_roots(Polynomial({5, 2, 1}));  // -1 +- 2i
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_TRUE(roots[0].re.contains(-1) && roots[0].im.contains(2));
  EXPECT_TRUE(roots[1].re.contains(-1) && roots[1].im.contains(-2));
  EXPECT_EQ(roots[0].im.lower, -roots[1].im.upper);
  EXPECT_LE(roots[0].modulus.lower * roots[0].modulus.lower, 5);
  EXPECT_GE(roots[0].modulus.upper * roots[0].modulus.upper, 5);
  EXPECT_FALSE(roots[0].modulus.is_point());
}

// Vieta: sum and product of the enclosures contain the coefficients' values.
TEST(ComplexRoots, EnclosuresContainTheRoots) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> digit(-9, 9);
  for (int run = 0; run < 50; ++run) {
    const int degree = 1 + run % 9;
    std::vector<Rational> coefficients;
    for (int k = 0; k < degree; ++k) coefficients.emplace_back(digit(random));
    coefficients.emplace_back(1);
    Rational lower = 0, upper = 0, product_lower = 1, product_upper = 1;
    int count = 0;
    for (const ComplexRoot& root : enclose_complex_roots(Polynomial(coefficients))) {
      ASSERT_LE(root.re.lower, root.re.upper);
      ASSERT_LE(root.im.lower, root.im.upper);
      for (int k = 0; k < root.multiplicity; ++k) {
        lower += root.re.lower;
        upper += root.re.upper;
        product_lower *= root.modulus.lower;
        product_upper *= root.modulus.upper;
        ++count;
      }
    }
    EXPECT_EQ(count, degree);
    const Rational sum = -coefficients[static_cast<std::size_t>(degree - 1)], product = abs(coefficients.front());
    EXPECT_TRUE(lower <= sum && sum <= upper);
    EXPECT_TRUE(product_lower <= product && product <= product_upper);
    EXPECT_LT(upper - lower, power(Rational(2), -40));
  }
}

TEST(ComplexRoots, WrongCalls) {
  EXPECT_THROW(enclose_complex_roots(Polynomial()), DomainError);
  EXPECT_THROW(enclose_complex_roots(Polynomial({1, 1}), 4), DomainError);
  EXPECT_TRUE(enclose_complex_roots(Polynomial::constant(3)).empty());
}

}  // namespace
}  // namespace limes
