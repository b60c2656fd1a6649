#include "algebra/polynomial/multivariate_polynomial.hpp"

#include "algebra/error.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace limes {
namespace {

using P = MultivariatePolynomial;

/// Term by term, independent of FLINT's evaluation.
Rational value(const P& p, const std::vector<Rational>& point) {
  Rational sum = 0;
  for (const auto& [exponents, coefficient] : p.terms()) {
    Rational term = coefficient;
    for (std::size_t i = 0; i < point.size(); ++i) term *= power(point[i], exponents[i]);
    sum += term;
  }
  return sum;
}

TEST(MultivariatePolynomial, RingAxiomsAndEvaluation) {
  test::Generator generator(21);
  for (int round = 0; round < 120; ++round) {
    const int n = generator.integer(0, 4);
    const P a = generator.multivariate(n, 4, 6), b = generator.multivariate(n, 4, 6);
    const P c = generator.multivariate(n, 4, 6);
    const auto point = generator.point(n);
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ(a * b, b * a);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_TRUE((a - a).is_zero());
    EXPECT_EQ(a + (-b), a - b);
    EXPECT_EQ(a(point), value(a, point));
    EXPECT_EQ((a * b + c)(point), a(point) * b(point) + c(point));
    EXPECT_EQ(power(a, 3), a * a * a);
    EXPECT_EQ(P::from_terms(n, a.terms()), a);
    EXPECT_EQ(a.terms().size(), a.term_count());
  }
}

TEST(MultivariatePolynomial, TermsDescendLexicographically) {
  test::Generator generator(22);
  for (int round = 0; round < 50; ++round) {
    const auto terms = generator.multivariate(3, 3, 10).terms();
    for (std::size_t i = 1; i < terms.size(); ++i) EXPECT_GT(terms[i - 1].exponents, terms[i].exponents);
    for (const auto& term : terms) EXPECT_NE(term.coefficient, 0);
  }
}

TEST(MultivariatePolynomial, SubstitutionCommutesWithEvaluation) {
  test::Generator generator(23);
  for (int round = 0; round < 80; ++round) {
    const int n = generator.integer(1, 3), index = generator.integer(0, n - 1);
    const P a = generator.multivariate(n, 4, 6), q = generator.multivariate(n, 2, 3);
    const Rational x = generator.rational();
    auto point = generator.point(n);
    auto moved = point;
    moved[static_cast<std::size_t>(index)] = x;
    EXPECT_EQ(a.substitute(index, x)(point), a(moved));
    EXPECT_LE(a.substitute(index, x).degree(index), 0);
    moved[static_cast<std::size_t>(index)] = q(point);
    EXPECT_EQ(a.substitute(index, q)(point), a(moved));
    P sum(n);
    const auto parts = a.coefficients(index);
    EXPECT_EQ(static_cast<int>(parts.size()), a.degree(index) + 1);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_LE(parts[k].degree(index), 0);
      sum += parts[k] * power(P::variable(n, index), static_cast<int>(k));
    }
    EXPECT_EQ(sum, a);
  }
}

TEST(MultivariatePolynomial, Mapped) {
  test::Generator generator(24);
  for (int round = 0; round < 60; ++round) {
    const P a = generator.multivariate(3, 3, 6);
    const auto y = generator.point(5);
    const std::vector<int> injective = {4, 0, 2}, folding = {1, 1, 3};
    EXPECT_EQ(a.mapped(5, injective)(y), a(std::vector<Rational>{y[4], y[0], y[2]}));
    EXPECT_EQ(a.mapped(5, folding)(y), a(std::vector<Rational>{y[1], y[1], y[3]}));
  }
  const P x1 = P::variable(2, 1);
  EXPECT_EQ(x1.mapped(1, std::vector<int>{-1, 0}), P::variable(1, 0));
  EXPECT_THROW(x1.mapped(1, std::vector<int>{0, -1}), DomainError);
  EXPECT_THROW(x1.mapped(1, std::vector<int>{0, 1}), DomainError);
  EXPECT_THROW(x1.mapped(1, std::vector<int>{0}), DomainError);
  EXPECT_EQ(P::constant(2, 3).mapped(0, {}), P::constant(0, 3));
}

TEST(MultivariatePolynomial, GcdAndExactQuotient) {
  test::Generator generator(25);
  for (int round = 0; round < 80; ++round) {
    const int n = generator.integer(0, 3);
    const P a = generator.multivariate(n, 2, 4), b = generator.multivariate(n, 2, 4);
    const P c = generator.multivariate(n, 2, 3);
    if (b.is_zero()) {
      EXPECT_THROW(exact_quotient(a, b), DomainError);
      continue;
    }
    ASSERT_TRUE(exact_quotient(a * b, b));
    EXPECT_EQ(*exact_quotient(a * b, b), a);
    if (!b.is_constant()) {
      EXPECT_FALSE(exact_quotient(a * b + P::constant(n, 1), b));
    }
    const P g = gcd(a * c, b * c);
    if (c.is_zero()) {
      EXPECT_TRUE(g.is_zero());
      continue;
    }
    EXPECT_EQ(g.terms().front().coefficient, 1);
    EXPECT_TRUE(exact_quotient(a * c, g));
    EXPECT_TRUE(exact_quotient(b * c, g));
    EXPECT_TRUE(exact_quotient(g, c));
  }
}

TEST(MultivariatePolynomial, FactorisationMultipliesBack) {
  test::Generator generator(26);
  for (int round = 0; round < 25; ++round) {
    P a = P::constant(2, generator.non_zero_rational());
    for (int i = 0; i < 3; ++i) {
      const P factor = generator.multivariate(2, 2, 3);
      if (!factor.is_zero()) a *= power(factor, generator.integer(1, 2));
    }
    P product = P::constant(2, a.terms().front().coefficient);
    for (const auto& [factor, exponent] : factorisation(a)) {
      EXPECT_FALSE(factor.is_constant());
      EXPECT_EQ(factor.terms().front().coefficient, 1);
      product *= power(factor, exponent);
    }
    EXPECT_EQ(product, a);
  }
  const P x = P::variable(2, 0), y = P::variable(2, 1);
  EXPECT_EQ(factorisation(x * x - y * y).size(), 2u);
  EXPECT_EQ(factorisation(x * x + y * y).size(), 1u);
}

TEST(MultivariatePolynomial, NoVariableMeansConstants) {
  const P two = P::constant(0, 2);
  EXPECT_EQ((two * two + two).constant_value(), 6);
  EXPECT_EQ(two(std::vector<Rational>{}), 2);
  EXPECT_TRUE(two.degrees().empty());
  EXPECT_EQ(two.terms().size(), 1u);
  EXPECT_TRUE(two.terms().front().exponents.empty());
  EXPECT_EQ(gcd(two, two), P::constant(0, 1));
  EXPECT_EQ(to_string(two, {}), "2");
  EXPECT_EQ(*exact_quotient(two, P::constant(0, 4)), P::constant(0, Rational(1) / 2));
}

TEST(MultivariatePolynomial, UnivariateRoundTrip) {
  test::Generator generator(27);
  for (int round = 0; round < 30; ++round) {
    const Polynomial p = generator.polynomial(7);
    EXPECT_EQ(P::from_univariate(3, 1, p).univariate(1), p);
  }
  const P x = P::variable(2, 0), y = P::variable(2, 1);
  EXPECT_THROW((x + y).univariate(0), DomainError);
  EXPECT_THROW(x.univariate(1), DomainError);
  EXPECT_EQ(P::constant(2, 5).univariate(1), Polynomial::constant(5));
}

TEST(MultivariatePolynomial, MismatchesAreErrors) {
  EXPECT_THROW(P::variable(1, 0) + P::variable(2, 0), DomainError);
  EXPECT_THROW(static_cast<void>(P(1) == P(2)), DomainError);
  EXPECT_THROW(P::variable(1, 1), DomainError);
  EXPECT_THROW(P::variable(1, 0).constant_value(), DomainError);
  EXPECT_THROW(P(-1), DomainError);
  EXPECT_THROW(P(65), LimitError);
  EXPECT_THROW(P::variable(1, 0)(std::vector<Rational>{}), DomainError);
  P moved = P::variable(2, 0), target = std::move(moved);
  moved = P::variable(3, 2);
  EXPECT_EQ(moved, P::variable(3, 2));
  target = moved;
  EXPECT_EQ(target.variables(), 3);
}

TEST(MultivariatePolynomial, Prints) {
  const P w = P::variable(2, 0), b = P::variable(2, 1);
  const VariableNames names = {"w", "beta_1"};
  EXPECT_EQ(to_string(P(2), names), "0");
  EXPECT_EQ(to_string(Rational(-3) * w - P::constant(2, Rational(1) / 16), names), "-3*w - 1/16");
  EXPECT_EQ(to_string(-w * w * b + Rational(1) / 2 * w + b, names), "-w^2*beta_1 + 1/2*w + beta_1");
  EXPECT_EQ(to_string(P::constant(2, -1), names), "-1");
  EXPECT_EQ(to_string(-w, names), "-w");
  EXPECT_THROW(to_string(w, {"w"}), DomainError);
}

// Outlives main() and the memory pool of its thread.
const P outliving = power(P::variable(1, 0) + P::constant(1, power(Rational(3), 99)), 20);

TEST(MultivariatePolynomial, ThreadsShareContexts) {
  EXPECT_EQ(outliving.degree(0), 20);
  std::vector<P> results(4);
  std::vector<std::thread> threads;
  for (P& result : results) {
    threads.emplace_back([&result] {
      P sum = P::constant(3, 1);
      for (int i = 0; i < 3; ++i) sum += Rational(1) / (i + 2) * P::variable(3, i);
      result = power(sum, 12);
    });
  }
  for (auto& thread : threads) thread.join();
  for (const P& result : results) EXPECT_EQ(result, results.front());
  EXPECT_EQ(results.front().term_count(), 455u);
}

}  // namespace
}  // namespace limes
