#include "analysis/nonuniform/dominance_comparison.hpp"

#include "algebra/polynomial/schur_cohn.hpp"
#include "tests/analysis/nonuniform/rules.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

std::vector<FactorComparison> compare(const InsertionRule& rule, int m, const Box& region) {
  return compare_dominance_methods(split_characteristic_polynomial(SubdivisionMatrix(rule), m), region, 64);
}

const MethodResult& result(const FactorComparison& comparison, DominanceMethod method) {
  return *std::find_if(comparison.methods.begin(), comparison.methods.end(), [&](const auto& r) { return r.method == method; });
}

// Where the coefficient test is said to fail at a point, it fails there exactly: sum_{s<p} |d_s| rho^s >= d_p rho^p.
TEST(DominanceComparison, PointsOfFailureAreExact) {
  const Rational rho = Rational(1) / 4;
  int failures = 0;
  for (const FactorComparison& comparison : compare(test::repeated_a1_3_1(), 2, {})) {
    const MethodResult& rouche = result(comparison, DominanceMethod::rouche);
    if (!rouche.hopeless_point) continue;
    ++failures;
    const Polynomial at = comparison.factor.polynomial.at(*rouche.hopeless_point);
    const int p = comparison.factor.polynomial.degree();
    Rational sum = 0;
    for (int s = 0; s < p; ++s) sum += abs(at.coefficient(s)) * power(rho, s);
    EXPECT_GE(sum, abs(at.coefficient(p)) * power(rho, p));
  }
  EXPECT_EQ(failures, 1);
}

// A root lies on the circle at gamma = 0: the circle test cannot work there, the boundary test divides the face out.
TEST(DominanceComparison, RepeatedFourPointNeedsTheBoundaryTest) {
  for (const FactorComparison& comparison : compare(test::repeated_a1_3_1(), 2, {})) {
    EXPECT_TRUE(result(comparison, DominanceMethod::boundary).proved);
    if (comparison.in_ell) continue;
    const MethodResult& circle = result(comparison, DominanceMethod::circle);
    EXPECT_FALSE(circle.proved);
    ASSERT_TRUE(circle.hopeless_point);
    EXPECT_EQ(circle.hopeless_point->back(), 0);
  }
}

// Karciauskas & Peters 2013: the coefficient test suffices for A^{2,5:3} on the printed range.
TEST(DominanceComparison, CoefficientTestProvesA253) {
  for (const FactorComparison& comparison : compare(test::a2_5_3(), 2, {read_interval("[1/1000, 1/50]")})) {
    EXPECT_TRUE(result(comparison, DominanceMethod::rouche).proved);
  }
}

TEST(DominanceComparison, AFalseStatementHasACounterexample) {
  bool found = false;
  for (const FactorComparison& comparison : compare(test::a2_5_3(), 3, {read_interval("141/10000")})) {
    for (const MethodResult& one : comparison.methods) {
      if (!one.counterexample) continue;
      found = true;
      EXPECT_FALSE(roots_inside_circle(comparison.factor.polynomial.at(*one.counterexample), Rational(1) / 8));
    }
  }
  EXPECT_TRUE(found);
}

// Separation is never called hopeless where it proves: on random boxes of a scheme that it can do.
TEST(DominanceComparison, SeparationIsHopelessOnlyWhereItIs) {
  const std::vector<FactorComparison> comparisons = compare(test::a3_5_3_3(), 3, {read_interval("141/10000")});
  for (const FactorComparison& comparison : comparisons) {
    const MethodResult& separation = result(comparison, DominanceMethod::sign_separation);
    EXPECT_TRUE(separation.proved);
    EXPECT_FALSE(separation.hopeless_point);
  }
}

}  // namespace
}  // namespace limes
