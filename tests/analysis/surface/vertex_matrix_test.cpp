#include "analysis/surface/vertex_matrix.hpp"

#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

RingRule rule_of(const std::string& name) { return load_scheme(name).surface->rings; }

/// The coefficients at mu = 1, a valence and a rational c, monic.
Polynomial at(const LambdaPolynomialInC& chi, int n, const Rational& c) {
  std::vector<Rational> coefficients;
  for (const MultivariatePolynomial& a : chi.coefficients) coefficients.push_back(a(std::vector<Rational>{1, n, c}));
  const Rational leading = coefficients.back();
  for (Rational& a : coefficients) a /= leading;
  return Polynomial(coefficients);
}

TEST(VertexMatrix, RulesOfTheCatalogueAreAffineAndMirrorSymmetric) {
  for (const char* name : {"unified", "catmull-clark", "doo-sabin"}) {
    const RingRule rule = rule_of(name);
    for (int rings = rule.invariant_rings(); rings <= 4; ++rings) {
      EXPECT_TRUE(rows_sum_to_one(rule, rings)) << name;
      EXPECT_TRUE(mirror_symmetric(rule, rings)) << name;
    }
  }
}

TEST(VertexMatrix, WithoutItsMirrorImageATermIsNoticed) {
  RingRule rule = rule_of("doo-sabin");
  ASSERT_TRUE(mirror_symmetric(rule, 2));
  rule.given.at({0, 0}).push_back({{0, 0}, 1, -1, RationalFunction::constant(2, Rational(1) / 9)});
  EXPECT_FALSE(mirror_symmetric(rule, 2));
  EXPECT_FALSE(rows_sum_to_one(rule, 2));
  rule.given.at({0, 0}).push_back({{0, 0}, -1, -1, RationalFunction::constant(2, Rational(1) / 9)});
  EXPECT_TRUE(mirror_symmetric(rule, 2));
}

TEST(VertexMatrix, NumbersOfInvariantRings) {
  EXPECT_EQ(rule_of("unified").invariant_rings(), 2);
  EXPECT_EQ(rule_of("catmull-clark").invariant_rings(), 1);
  EXPECT_EQ(rule_of("doo-sabin").invariant_rings(), 1);
  EXPECT_EQ(rule_of("unified").invariant_rings(3), 3);
}

// Catmull & Clark 1978; Doo & Sabin 1978: lambda^2 - (5 + c)/8 lambda + 1/16 in the blocks j != 0.
TEST(VertexMatrix, CatmullClarkBlocks) {
  const RingRule rule = rule_of("catmull-clark");
  const LambdaPolynomialInC generic = characteristic_polynomial(generic_block(rule, 1));
  for (const Rational& c : {Rational(-1), Rational(0), Rational(1) / 3, Rational(1)})
    EXPECT_EQ(at(generic, 5, c), Polynomial({Rational(1) / 16, -(5 + c) / 8, 1}));
  // Block 0: (lambda - 1)(lambda^2 - (3n - 7)/(4n) lambda + (n^2 - 5 n + ..)): the other two have the sum 3/4 - 7/(4n).
  const LambdaPolynomialInC zero = characteristic_polynomial(harmonic_block(rule, 1, 0));
  for (const int n : {3, 4, 7, 50}) {
    const Polynomial chi = at(zero, n, 1);
    const auto [rest, remainder] = divide(chi, Polynomial({-1, 1}));
    EXPECT_TRUE(remainder.is_zero());
    EXPECT_EQ(rest.coefficient(1), -(Rational(3) / 4 - Rational(7) / (4 * n)));
    // discriminant (5 n^2 - 30 n + 49)/(4 n)^2
    EXPECT_EQ(rest.coefficient(1) * rest.coefficient(1) - 4 * rest.coefficient(0), Rational(5 * n * n - 30 * n + 49) / (16 * n * n));
  }
}

// At n = 4 every scheme is the tensor product of its curve scheme: eigenvalues are the products of those of the curve.
TEST(VertexMatrix, ValenceFourIsTheTensorProduct) {
  const Polynomial x = Polynomial::monomial(1, 1), half({-Rational(1) / 2, 1});
  for (const char* name : {"unified", "catmull-clark", "doo-sabin"}) {
    const RingRule rule = rule_of(name);
    const int rings = rule.invariant_rings();
    const auto chi = [&](int j) { return at(characteristic_polynomial(block(rule, rings, 4, j)), 4, j == 0 ? 1 : j == 2 ? -1 : 0); };
    EXPECT_EQ(chi(0)(1), 0) << name;
    EXPECT_EQ(chi(1)(Rational(1) / 2), 0) << name;
    EXPECT_EQ(chi(3), chi(1)) << name;
    EXPECT_EQ(chi(2)(Rational(1) / 4), 0) << name;
    EXPECT_NE(chi(1)(Rational(1)), 0) << name;
  }
}

TEST(VertexMatrix, TheFactorsOfAllBlocksMultiplyToTheTrace) {
  const RingRule rule = rule_of("unified");
  for (const int rings : {2, 3}) {
    const VertexBlock b = generic_block(rule, rings).at(1, 5);
    RationalFunction trace(2);
    for (int i = 0; i < b.size(); ++i) trace += b(i, i).coefficient(0);
    // The average over omega of the trace is its coefficient of omega^0, and that of T_i(c) is 0: so compare at many c.
    const LambdaPolynomialInC chi = characteristic_polynomial(generic_block(rule, rings));
    EXPECT_EQ(chi.degree(), b.size());
    for (const Rational& omega : {Rational(2), Rational(3) / 2}) {
      RationalFunction sum(2);
      for (int i = 0; i < b.size(); ++i) sum += b(i, i)(omega);
      const Rational c = (omega + 1 / omega) / 2;
      EXPECT_EQ(at(chi, 5, c).coefficient(b.size() - 1), -sum.constant_value());
    }
  }
}

}  // namespace
}  // namespace limes
