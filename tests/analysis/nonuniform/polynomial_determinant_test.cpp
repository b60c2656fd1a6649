#include "analysis/nonuniform/polynomial_determinant.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

MultivariatePolynomial random_polynomial(std::mt19937& random, int variables, int degree) {
  std::vector<MultivariatePolynomial::Term> terms;
  for (int k = 0; k < 3; ++k) {
    std::vector<int> exponents;
    for (int i = 0; i < variables; ++i)
      exponents.push_back(static_cast<int>(random() % static_cast<unsigned>(degree + 1)));
    terms.push_back({exponents, (Rational(static_cast<int>(random() % 19)) - 9) / static_cast<int>(1 + random() % 4)});
  }
  return MultivariatePolynomial::from_terms(variables, terms);
}

MultivariatePolynomial expansion(const PolynomialMatrix& a, std::vector<int> columns, int row) {
  if (row == a.rows()) return MultivariatePolynomial::constant(a.variables(), 1);
  MultivariatePolynomial sum(a.variables());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<int> others = columns;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    sum += Rational(k % 2 == 0 ? 1 : -1) * (a(row, columns[k]) * expansion(a, others, row + 1));
  }
  return sum;
}

TEST(Determinant, AgreesWithLaplaceExpansion) {
  std::mt19937 random(20130101);
  for (int variables = 0; variables <= 3; ++variables) {
    for (int size = 0; size <= 4; ++size) {
      PolynomialMatrix a(variables, size, size);
      std::vector<int> columns;
      for (int i = 0; i < size; ++i) {
        columns.push_back(i);
        // Some zeros: a bound that is not attained.
        for (int j = 0; j < size; ++j) {
          if ((i + 2 * j) % 5 != 1) a(i, j) = random_polynomial(random, variables, 2);
        }
      }
      EXPECT_EQ(determinant(a), expansion(a, columns, 0)) << variables << " variables, size " << size;
    }
  }
}

TEST(Determinant, OfEqualRowsIsZero) {
  std::mt19937 random(7);
  PolynomialMatrix a(2, 3, 3);
  for (int j = 0; j < 3; ++j) {
    a(0, j) = a(2, j) = random_polynomial(random, 2, 3);
    a(1, j) = random_polynomial(random, 2, 3);
  }
  EXPECT_TRUE(determinant(a).is_zero());
}

}  // namespace
}  // namespace limes
