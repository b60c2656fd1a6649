#include "analysis/nonuniform/expanding_eigenvalue.hpp"

#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "tests/analysis/nonuniform/rules.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

LambdaPolynomial chi(const InsertionRule& rule) { return characteristic_polynomial(SubdivisionMatrix(rule)); }

TEST(ExpandingEigenvalue, A131AtThirteenHundredths) {
  const auto found = find_expanding_eigenvalue(chi(test::a1_3_1()), 1, {Interval::point(Rational(13) / 100)});
  ASSERT_TRUE(found);
  EXPECT_LT(found->point.back(), 1);
  EXPECT_GT(found->count.outside + found->count.on, 0);
  // Not for equal intervals: the uniform scheme is C^1 there.
  EXPECT_FALSE(expanding_eigenvalue_at(chi(test::a1_3_1()), 1, {Rational(13) / 100, 1}));
}

TEST(ExpandingEigenvalue, A253IsNotC3) {
  const LambdaPolynomial p = chi(test::a2_5_3());
  EXPECT_TRUE(find_expanding_eigenvalue(p, 3, {Interval::point(Rational(141) / 10000)}));
  EXPECT_FALSE(find_expanding_eigenvalue(p, 2, {Interval::point(Rational(141) / 10000)}));
}

TEST(ExpandingEigenvalue, SmoothSchemesHaveNone) {
  EXPECT_FALSE(find_expanding_eigenvalue(chi(test::cr1()), 1, {read_interval("[1/1000, 37/200]")}));
  EXPECT_FALSE(find_expanding_eigenvalue(chi(test::a3_5()), 3, {read_interval("141/10000")}));
  EXPECT_TRUE(find_expanding_eigenvalue(chi(test::a3_5()), 4, {read_interval("141/10000")}));
}

TEST(ExpandingEigenvalue, ASecondPowerOfOneHalfCounts) {
  // Piecewise linear limits: the eigenvalue 1/2 is double, and the limit is not C^1.
  const auto found = find_expanding_eigenvalue(chi(test::rule("at(f(1,0),1/2)", {}, 4)), 1, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count.on, 1);
  EXPECT_FALSE(find_expanding_eigenvalue(chi(test::rule("at(f(1,0),1/2)", {}, 4)), 0, {}));
}

TEST(ExpandingEigenvalue, MissingReproductionAloneIsNone) {
  // CR^1 does not reproduce quadratics; 1/4 is no eigenvalue of it, but 2 roots of r have modulus sqrt(w) > 1/4.
  const auto found = expanding_eigenvalue_at(chi(test::cr1()), 2, {Rational(1) / 10, 1});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->remainder.degree(), 5);
}

}  // namespace
}  // namespace limes
