#include "algebra/polynomial/polynomial.hpp"

#include "algebra/error.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

Polynomial integers(std::initializer_list<int> coefficients) {
  return Polynomial(std::vector<Rational>(coefficients.begin(), coefficients.end()));
}

/// Horner's rule on the coefficients, independent of FLINT's evaluation.
Rational value(const Polynomial& p, const Rational& x) {
  Rational result = 0;
  for (int i = p.degree(); i >= 0; --i) result = result * x + p.coefficient(i);
  return result;
}

TEST(Polynomial, DropsTrailingZeros) {
  EXPECT_EQ(Polynomial().degree(), -1);
  EXPECT_EQ(integers({0, 0}).degree(), -1);
  EXPECT_EQ(integers({1, 2, 0}).degree(), 1);
  EXPECT_EQ(Polynomial({Rational(1) / 6, Rational(0), Rational(-3) / 4}).coefficients(),
            (std::vector<Rational>{Rational(1) / 6, 0, Rational(-3) / 4}));
  EXPECT_EQ(integers({1, 2}).coefficient(7), 0);
  EXPECT_EQ(integers({1, 2}).leading_coefficient(), 2);
  EXPECT_EQ(Polynomial::monomial(0, 5).degree(), -1);
  EXPECT_THROW(Polynomial::monomial(1, -1), DomainError);
}

TEST(Polynomial, RingAxiomsAndEvaluation) {
  test::Generator generator(11);
  for (int round = 0; round < 100; ++round) {
    const Polynomial a = generator.polynomial(6), b = generator.polynomial(6), c = generator.polynomial(6);
    const Rational x = generator.rational();
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ(a * b, b * a);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_TRUE((a - a).is_zero());
    EXPECT_EQ(a + (-b), a - b);
    EXPECT_EQ(a(x), value(a, x));
    EXPECT_EQ((a * b)(x), a(x) * b(x));
    EXPECT_EQ((x * a + b)(x), x * a(x) + b(x));
    EXPECT_EQ(compose(a, b)(x), a(b(x)));
    EXPECT_EQ(power(a, 3), a * a * a);
    EXPECT_EQ(derivative(a * b), derivative(a) * b + a * derivative(b));
    EXPECT_EQ(Polynomial(a.coefficients()), a);
  }
}

TEST(Polynomial, DivisionAndGcdIdentities) {
  test::Generator generator(12);
  for (int round = 0; round < 100; ++round) {
    const Polynomial a = generator.polynomial(8), b = generator.polynomial(5), c = generator.polynomial(3);
    if (b.is_zero()) {
      EXPECT_THROW(divide(a, b), DomainError);
      continue;
    }
    const auto [quotient, remainder] = divide(a, b);
    EXPECT_EQ(quotient * b + remainder, a);
    EXPECT_LT(remainder.degree(), b.degree());
    const Polynomial g = gcd(a * c, b * c);
    if (c.is_zero()) {
      EXPECT_TRUE(g.is_zero());
      continue;
    }
    EXPECT_EQ(g.leading_coefficient(), 1);
    EXPECT_TRUE(divide(b * c, g).second.is_zero());
    EXPECT_TRUE(divide(a * c, g).second.is_zero());
    EXPECT_TRUE(divide(g, c).second.is_zero());
  }
  EXPECT_TRUE(gcd(Polynomial(), Polynomial()).is_zero());
}

TEST(Polynomial, CopiesAreIndependentAndMovesReusable) {
  Polynomial a = integers({1, 1});
  Polynomial b = a;
  b += a;
  EXPECT_EQ(a, integers({1, 1}));
  Polynomial c = std::move(b);
  b = a;
  EXPECT_EQ(b, a);
  EXPECT_EQ(c, integers({2, 2}));
  a *= a;
  a += a;
  EXPECT_EQ(a, integers({2, 4, 2}));
}

TEST(Polynomial, Reversed) {
  EXPECT_EQ(reversed(integers({0, 0, 1, 2})), integers({2, 1}));
  EXPECT_EQ(reversed(integers({3, 1, 2})), integers({2, 1, 3}));
  EXPECT_TRUE(reversed(Polynomial()).is_zero());
}

TEST(Polynomial, SquareFreeFactorisationMultipliesBack) {
  test::Generator generator(13);
  for (int round = 0; round < 60; ++round) {
    Polynomial a = Polynomial::constant(generator.non_zero_rational());
    for (int i = 1; i <= 4; ++i) {
      const Polynomial factor = generator.polynomial(2);
      if (!factor.is_zero()) a *= power(factor, generator.integer(0, 3));
    }
    Polynomial product = Polynomial::constant(a.leading_coefficient()), radical = Polynomial::constant(1);
    for (const auto& [factor, multiplicity] : square_free_factorisation(a)) {
      EXPECT_GT(factor.degree(), 0);
      EXPECT_EQ(factor.leading_coefficient(), 1);
      EXPECT_EQ(gcd(factor, derivative(factor)).degree(), 0);
      EXPECT_EQ(gcd(factor, radical).degree(), 0);
      product *= power(factor, multiplicity);
      radical *= factor;
    }
    EXPECT_EQ(product, a);
    EXPECT_EQ(square_free_part(a), radical);
  }
  EXPECT_THROW(square_free_part(Polynomial()), DomainError);
}

TEST(Polynomial, CyclotomicProductIsOneMinusPower) {
  for (int n = 1; n <= 30; ++n) {
    Polynomial product = Polynomial::constant(1);
    for (int d = 1; d <= n; ++d) {
      if (n % d == 0) product *= cyclotomic(d);
    }
    EXPECT_EQ(product, Polynomial::monomial(1, n) - Polynomial::constant(1));
  }
  EXPECT_THROW(cyclotomic(0), DomainError);
}

TEST(Polynomial, Prints) {
  EXPECT_EQ(to_string(Polynomial(), "x"), "0");
  EXPECT_EQ(to_string(Polynomial({Rational(-1) / 16, Rational(-3), Rational(1)}), "w"), "w^2 - 3*w - 1/16");
  EXPECT_EQ(to_string(Polynomial({Rational(1), Rational(-1) / 2}), "lambda"), "-1/2*lambda + 1");
}

}  // namespace
}  // namespace limes
