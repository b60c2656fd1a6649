#include "analysis/nonuniform/split_characteristic_polynomial.hpp"

#include "algebra/expression/expression.hpp"
#include "tests/analysis/nonuniform/rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace limes {
namespace {

// From a text in lambda, w, gamma.
LambdaPolynomial polynomial(const std::string& text) {
  return primitive_part(
             LambdaPolynomial::from_expanded(read_rational_function(text, {"lambda", "w", "gamma"}).numerator()))
      .part;
}

void expect_factors(const std::vector<CharacteristicFactor>& found,
                    const std::vector<std::pair<std::string, int>>& expected) {
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [text, multiplicity] : expected) {
    const auto at = std::find_if(found.begin(), found.end(),
                                 [&, &t = text](const auto& f) { return f.polynomial == polynomial(t); });
    ASSERT_NE(at, found.end()) << text;
    EXPECT_EQ(at->multiplicity, multiplicity) << text;
  }
}

// chi is the characteristic polynomial of the rational matrix, and the product of its parts.
void expect_consistent(const InsertionRule& rule, int smoothness, const std::vector<Rational>& point) {
  const SubdivisionMatrix matrix(rule);
  const auto split = split_characteristic_polynomial(matrix, smoothness);
  const Polynomial chi = split.chi.at(point);
  EXPECT_EQ((1 / chi.leading_coefficient()) * chi, characteristic_polynomial(matrix.at(point)));
  EXPECT_EQ(split.chi.degree(), matrix.size());
  EXPECT_FALSE(split.missing_eigenvalue);
  const int variables = matrix.variables();
  LambdaPolynomial product(variables, {MultivariatePolynomial::constant(variables, 1)});
  for (int k = 0; k <= smoothness; ++k) {
    product = product * LambdaPolynomial::linear(MultivariatePolynomial::constant(variables, 1),
                                                 MultivariatePolynomial::constant(variables, power(Rational(2), -k)));
  }
  for (const auto* factors : {&split.ell, &split.r}) {
    for (const auto& f : *factors) {
      for (int k = 0; k < f.multiplicity; ++k) product = product * f.polynomial;
    }
  }
  EXPECT_EQ(product.leading(), split.leading());
  EXPECT_EQ(primitive_part(product).part, split.chi);
}

TEST(SplitCharacteristicPolynomial, IsTheCharacteristicPolynomial) {
  const std::vector<Rational> point{Rational(2) / 31, Rational(5) / 3}, ratio{Rational(5) / 3};
  expect_consistent(test::cr1(), 1, point);
  expect_consistent(test::a1_3_1(), 1, point);
  expect_consistent(test::three_point(), 1, point);
  expect_consistent(test::cr2(), 2, point);
  expect_consistent(test::cu2_4(), 2, point);
  expect_consistent(test::a3_5(), 3, point);
  expect_consistent(test::repeated_a1_3_1(), 2, ratio);
}

TEST(SplitCharacteristicPolynomial, CatmullRomC1AsPrinted) {
  const auto split = split_characteristic_polynomial(SubdivisionMatrix(test::cr1()), 1);
  expect_factors(split.ell, {{"lambda+w", 2}, {"lambda-2*w", 1}});
  expect_factors(split.r, {{"2*lambda^2-lambda+2*w", 1}});
  EXPECT_TRUE(split.is_symmetric());
}

TEST(SplitCharacteristicPolynomial, CatmullRomC2AsPrinted) {
  const auto split = split_characteristic_polynomial(SubdivisionMatrix(test::cr2()), 2);
  expect_factors(split.ell, {{"lambda-1/8", 1}, {"lambda-w", 2}});
  expect_factors(split.r, {{"16*lambda^2+(1-32*w)*lambda-256*w^2", 1},
                           {"64*lambda^3+(256*w-12)*lambda^2+(64*w-1)*lambda+256*w^2", 1}});
  EXPECT_TRUE(split.is_symmetric());
}

TEST(SplitCharacteristicPolynomial, DegreesAsPrinted) {
  const auto a = split_characteristic_polynomial(SubdivisionMatrix(test::a3_5_3_3()), 3);
  expect_factors(a.ell, {{"lambda-w", 2}});
  ASSERT_EQ(a.r.size(), 1u);
  EXPECT_EQ(a.r[0].polynomial.degree(), 5);
  EXPECT_EQ(a.r[0].polynomial.degrees(), (std::vector<int>{4, 8}));
  const auto b = split_characteristic_polynomial(SubdivisionMatrix(test::repeated_a1_3_1()), 2);
  ASSERT_EQ(b.r.size(), 1u);
  EXPECT_EQ(b.r[0].polynomial.degree(), 5);
  EXPECT_EQ(b.r[0].polynomial.degrees(), (std::vector<int>{4}));
}

TEST(SplitCharacteristicPolynomial, TenPoints) {
  const auto split = split_characteristic_polynomial(SubdivisionMatrix(test::ten_point()), 4);
  expect_factors(split.ell, {{"lambda-1/32", 1}, {"lambda-1/64", 1}, {"lambda-1/128", 1}, {"lambda-w", 2}});
  ASSERT_EQ(split.r.size(), 1u);
  EXPECT_EQ(split.r[0].polynomial.degree(), 9);
  EXPECT_TRUE(split.is_symmetric());
}

TEST(SplitCharacteristicPolynomial, AsymmetryIsSeen) {
  EXPECT_FALSE(split_characteristic_polynomial(SubdivisionMatrix(test::three_point()), 1).is_symmetric());
}

TEST(SplitCharacteristicPolynomial, EachPowerOfOneHalfIsDividedOutOnce) {
  // w = 1/8: -w is no power, but 2w = 1/4 is; with m = 2 the root 2w must stay among the factors that are tested.
  const auto split = split_characteristic_polynomial(
      SubdivisionMatrix(test::rule("at(tension(2, hermite(1, f(2,0), f(2,1))), 1/2)", {})), 1);
  int quarter = 0;
  for (const auto& f : split.ell)
    quarter += f.polynomial.at(std::vector<Rational>{1})(Rational(1) / 4) == 0 ? f.multiplicity : 0;
  EXPECT_EQ(quarter, 1);
  // The linear spline: 1/2 is an eigenvalue once more than polynomials ask for.
  const auto hat = split_characteristic_polynomial(SubdivisionMatrix(test::rule("at(f(1,0),1/2)", {}, 4)), 1);
  const std::vector<Rational> one{1};
  int half = 0;
  for (const auto* factors : {&hat.ell, &hat.r}) {
    for (const auto& f : *factors) half += f.polynomial.at(one)(Rational(1) / 2) == 0 ? f.multiplicity : 0;
  }
  EXPECT_EQ(half, 1);
}

TEST(SplitCharacteristicPolynomial, AMissingEigenvalueIsReported) {
  const auto split = split_characteristic_polynomial(SubdivisionMatrix(test::cr1()), 4);
  ASSERT_TRUE(split.missing_eigenvalue);
  EXPECT_EQ(*split.missing_eigenvalue, 2);
}

TEST(CheapFactors, FindsFactorsWithAndWithoutGamma) {
  const LambdaPolynomial a = polynomial("lambda^2*gamma+3*lambda+w+2"), b = polynomial("lambda^3-w*lambda+5");
  const auto factors = cheap_factors(primitive_part(a * b * b).part);
  ASSERT_EQ(factors.size(), 2u);
  for (const auto& f : factors) EXPECT_EQ(f.multiplicity, f.polynomial == a ? 1 : 2);
}

TEST(Mirrored, IsAnInvolution) {
  const LambdaPolynomial a = polynomial("lambda^2*gamma^3+3*lambda*gamma+w+2");
  EXPECT_EQ(mirrored(a), polynomial("lambda^2+3*lambda*gamma^2+(w+2)*gamma^3"));
  EXPECT_EQ(mirrored(mirrored(a)), a);
}

}  // namespace
}  // namespace limes
