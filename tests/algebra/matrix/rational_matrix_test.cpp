#include "algebra/matrix/rational_matrix.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

RationalMatrix random_matrix(std::mt19937& random, int rows, int columns) {
  RationalMatrix a(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) a(i, j) = Rational(int(random() % 41) - 20, 1 + int(random() % 6));
  }
  return a;
}

RationalMatrix value_at(const Polynomial& p, const RationalMatrix& a) {
  RationalMatrix result(a.rows(), a.rows());
  for (int k = p.degree(); k >= 0; --k) {
    result = result * a;
    for (int i = 0; i < a.rows(); ++i) result(i, i) += p.coefficient(k);
  }
  return result;
}

TEST(RationalMatrix, Products) {
  std::mt19937 random(9);
  const RationalMatrix a = random_matrix(random, 3, 4), b = random_matrix(random, 4, 2),
                       c = random_matrix(random, 2, 5);
  EXPECT_EQ((a * b) * c, a * (b * c));
  EXPECT_EQ(RationalMatrix::identity(3) * a, a);
  EXPECT_EQ(a * RationalMatrix::identity(4), a);
  const std::vector<Rational> x = {1, Rational(1, 2), -3, 4};
  RationalMatrix column(4, 1);
  for (int i = 0; i < 4; ++i) column(i, 0) = x[std::size_t(i)];
  const auto product = a * x;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(product[std::size_t(i)], (a * column)(i, 0));
  EXPECT_THROW(a * a, DomainError);
  EXPECT_THROW(a * std::vector<Rational>(3), DomainError);
}

TEST(RationalMatrix, CharacteristicPolynomialOfCompanionMatrix) {
  const std::vector<Rational> c = {Rational(3, 7), -2, 0, Rational(-5, 2), 11, 1};
  RationalMatrix a(5, 5);
  for (int i = 0; i < 5; ++i) {
    a(i, 4) = -c[std::size_t(i)];
    if (i > 0) a(i, i - 1) = 1;
  }
  EXPECT_EQ(characteristic_polynomial(a), Polynomial(c));
}

TEST(RationalMatrix, SmallAndDegenerateCharacteristicPolynomials) {
  EXPECT_EQ(characteristic_polynomial(RationalMatrix()), Polynomial::constant(1));
  EXPECT_EQ(characteristic_polynomial(RationalMatrix(3, 3)), Polynomial::monomial(1, 3));
  EXPECT_EQ(characteristic_polynomial(RationalMatrix::identity(2)), Polynomial({1, -2, 1}));
  EXPECT_THROW(characteristic_polynomial(RationalMatrix(2, 3)), DomainError);
}

TEST(RationalMatrix, CayleyHamiltonAndInvariants) {
  std::mt19937 random(10);
  for (int n = 1; n <= 9; ++n) {
    const RationalMatrix a = random_matrix(random, n, n);
    const Polynomial chi = characteristic_polynomial(a);
    EXPECT_EQ(chi.degree(), n);
    EXPECT_EQ(chi.leading_coefficient(), 1);
    EXPECT_EQ(value_at(chi, a), RationalMatrix(n, n));
    Rational trace = 0;
    for (int i = 0; i < n; ++i) trace += a(i, i);
    EXPECT_EQ(chi.coefficient(n - 1), -trace);
    // ab and ba have the same characteristic polynomial, and so have similar matrices.
    const RationalMatrix b = random_matrix(random, n, n);
    EXPECT_EQ(characteristic_polynomial(a * b), characteristic_polynomial(b * a));
    RationalMatrix shear = RationalMatrix::identity(n), inverse = shear;
    shear(0, n - 1) += n > 1 ? Rational(5, 3) : Rational(0);
    inverse(0, n - 1) -= n > 1 ? Rational(5, 3) : Rational(0);
    EXPECT_EQ(characteristic_polynomial(shear * a * inverse), chi);
  }
}

TEST(RationalMatrix, Rank) {
  std::mt19937 random(11);
  EXPECT_EQ(rank(RationalMatrix()), 0);
  EXPECT_EQ(rank(RationalMatrix(3, 2)), 0);
  EXPECT_EQ(rank(RationalMatrix::identity(4)), 4);
  for (int r = 1; r <= 4; ++r) {
    // Random factors of rank r, with identity blocks to be sure of it.
    RationalMatrix a = random_matrix(random, 6, r), b = random_matrix(random, r, 5);
    for (int i = 0; i < r; ++i) {
      for (int j = 0; j < r; ++j) a(i, j) = b(i, j) = i == j ? 1 : 0;
    }
    EXPECT_EQ(rank(a * b), r);
  }
}

}  // namespace
}  // namespace limes
