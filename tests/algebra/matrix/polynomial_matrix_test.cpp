#include "algebra/matrix/polynomial_matrix.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

MultivariatePolynomial random_polynomial(std::mt19937& random, int variables, int degree) {
  std::vector<MultivariatePolynomial::Term> terms;
  for (unsigned i = 0; i < random() % 4; ++i) {
    std::vector<int> exponents;
    for (int k = 0; k < variables; ++k) exponents.push_back(int(random() % unsigned(degree + 1)));
    terms.push_back({exponents, Rational(int(random() % 19) - 9, 1 + int(random() % 4))});
  }
  return MultivariatePolynomial::from_terms(variables, terms);
}

PolynomialMatrix random_matrix(std::mt19937& random, int variables, int size, int degree) {
  PolynomialMatrix a(variables, size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) a(i, j) = random_polynomial(random, variables, degree);
  }
  return a;
}

std::vector<Rational> random_point(std::mt19937& random, int variables) {
  std::vector<Rational> point;
  for (int k = 0; k < variables; ++k) point.emplace_back(int(random() % 201) - 100, 1 + int(random() % 30));
  return point;
}

TEST(PolynomialMatrix, ProductsAgreeAtPoints) {
  std::mt19937 random(12);
  const PolynomialMatrix a = random_matrix(random, 2, 4, 2), b = random_matrix(random, 2, 4, 3);
  for (int trial = 0; trial < 5; ++trial) {
    const auto point = random_point(random, 2);
    EXPECT_EQ((a * b).at(point), a.at(point) * b.at(point));
    EXPECT_EQ((PolynomialMatrix::identity(2, 4) * a).at(point), a.at(point));
  }
  EXPECT_THROW(a * PolynomialMatrix(2, 3, 4), DomainError);
  EXPECT_THROW(a * PolynomialMatrix(1, 4, 4), DomainError);
}

TEST(PolynomialMatrix, CharacteristicPolynomialAgreesAtPoints) {
  std::mt19937 random(13);
  for (int variables = 0; variables <= 3; ++variables) {
    for (int size = 0; size <= (variables == 3 ? 3 : 6); ++size) {
      const PolynomialMatrix a = random_matrix(random, variables, size, 2);
      const auto chi = characteristic_polynomial(a);
      ASSERT_EQ(int(chi.size()), size + 1);
      EXPECT_EQ(chi.back(), MultivariatePolynomial::constant(variables, 1));
      for (int trial = 0; trial < 4; ++trial) {
        const auto point = random_point(random, variables);
        const Polynomial expected = characteristic_polynomial(a.at(point));
        for (int k = 0; k <= size; ++k) EXPECT_EQ(chi[std::size_t(k)](point), expected.coefficient(k));
      }
    }
  }
}

TEST(PolynomialMatrix, DegreesAreReached) {
  // diag(x^2, y, x y): each coefficient attains its bound.
  PolynomialMatrix a(2, 3, 3);
  const auto x = MultivariatePolynomial::variable(2, 0), y = MultivariatePolynomial::variable(2, 1);
  a(0, 0) = x * x;
  a(1, 1) = y;
  a(2, 2) = x * y;
  const auto chi = characteristic_polynomial(a);
  EXPECT_EQ(chi[0], -(power(x, 3) * power(y, 2)));
  EXPECT_EQ(chi[1], power(x, 2) * y + power(x, 3) * y + x * power(y, 2));
  EXPECT_EQ(chi[2], -(x * x + y + x * y));
}

TEST(PolynomialMatrix, SimilarMatricesOverThePolynomials) {
  std::mt19937 random(14);
  const PolynomialMatrix a = random_matrix(random, 1, 5, 1);
  const auto w = MultivariatePolynomial::variable(1, 0);
  PolynomialMatrix shear = PolynomialMatrix::identity(1, 5), inverse = shear;
  shear(0, 3) = w;
  inverse(0, 3) = -w;
  EXPECT_EQ(characteristic_polynomial(shear * a * inverse), characteristic_polynomial(a));
}

TEST(PolynomialMatrix, OnlySquareMatricesHaveOne) {
  EXPECT_THROW(characteristic_polynomial(PolynomialMatrix(1, 2, 3)), DomainError);
}

}  // namespace
}  // namespace limes
