#include "analysis/nonuniform/subdivision_matrix.hpp"

#include "algebra/error.hpp"
#include "tests/analysis/nonuniform/rules.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

// Karciauskas & Peters 2013, eq. (17), as printed, with the symmetry of (12).
std::vector<RationalFunction> printed_cr1(const RationalFunction& b1, const RationalFunction& b2) {
  const int variables = b1.variables();
  const auto number = [&](const Rational& x) { return RationalFunction::constant(variables, x); };
  const RationalFunction w = RationalFunction::variable(variables, 0), one = number(1), four = number(4),
                         two = number(2);
  const auto e1 = [&](const RationalFunction& b) { return -two * b * b / (one + b) * w; };
  const auto e2 = [&](const RationalFunction& b, const RationalFunction& c) {
    return (one + c + four * (b + b * c - one) * w) / (two * (one + c));
  };
  return {e1(b1), e2(b1, b2), e2(one / b2, one / b1), e1(one / b2)};
}

SubdivisionMatrix printed_cr1_matrix() {
  const RationalFunction gamma = RationalFunction::variable(2, 1), one = RationalFunction::constant(2, 1);
  return SubdivisionMatrix::from_stencils({printed_cr1(one, one), printed_cr1(one, gamma), printed_cr1(gamma, one)});
}

TEST(SubdivisionMatrix, RuleAndPrintedFormulaAgree) {
  const SubdivisionMatrix a(test::cr1()), b = printed_cr1_matrix();
  ASSERT_EQ(a.size(), 7);
  for (int row = -3; row <= 3; ++row) {
    for (int column = -3; column <= 3; ++column)
      EXPECT_EQ(a.entry(row, column), b.entry(row, column)) << row << ' ' << column;
  }
}

TEST(SubdivisionMatrix, RowsAreThoseOfTheRuleOnTheKnots) {
  const InsertionRule rule = test::a2_5_3();
  const SubdivisionMatrix matrix(rule);
  const Rational gamma = Rational(3) / 7, w = Rational(1) / 50;
  const std::vector<Rational> point{w, gamma}, parameters{w};
  const RationalMatrix at = matrix.at(point);
  const auto knot = [&](int j) { return Rational(j > 0 ? j * gamma : Rational(j)); };
  for (int j = -5; j <= 5; ++j) {
    EXPECT_EQ(matrix.knot(j)(point), knot(j));
    for (int column = -5; column <= 5; ++column) {
      if (j % 2 == 0) {
        EXPECT_EQ(at(j + 5, column + 5), column == j / 2 ? 1 : 0);
      }
    }
    if (j % 2 == 0) continue;
    const int i = (j - 1) / 2;
    std::vector<Rational> knots;
    for (int k = i - 2; k <= i + 3; ++k) knots.push_back(knot(k));
    const std::vector<Rational> weights = rule.stencil(knots, parameters);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(at(j + 5, i - 2 + k + 5), weights[static_cast<std::size_t>(k)]);
  }
}

TEST(SubdivisionMatrix, ReproducesPolynomials) {
  EXPECT_EQ(SubdivisionMatrix(test::cr1()).reproduced_degree(4), 1);
  EXPECT_EQ(SubdivisionMatrix(test::cr2()).reproduced_degree(4), 2);
  EXPECT_EQ(SubdivisionMatrix(test::a2_5_3()).reproduced_degree(6), 3);
  EXPECT_EQ(SubdivisionMatrix(test::rule("at(f(5,0),1/2)", {})).reproduced_degree(9), 5);
  EXPECT_EQ(SubdivisionMatrix(test::rule("at(f(5,0),1/2)", {})).reproduced_degree(2), 2);
  EXPECT_EQ(SubdivisionMatrix(test::rule("2*at(f(3,0),1/2)", {})).reproduced_degree(2), -1);
}

TEST(SubdivisionMatrix, MisshapenStencilsAreRefused) {
  EXPECT_THROW(SubdivisionMatrix::from_stencils({}), DomainError);
  const std::vector<RationalFunction> three(3, RationalFunction::constant(1, 1));
  EXPECT_THROW(SubdivisionMatrix::from_stencils({three, three, three}), DomainError);
}

}  // namespace
}  // namespace limes
