#include "algebra/polynomial/factorisation.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

using namespace limes;

TEST(Factorisation, FactorsMultiplyUpAndAreOrdered) {
  const Polynomial x2({-2, 0, 1}), x1({Rational(-1, 3), 1}), x3({1, 1, 0, 1});
  const Polynomial a = Rational(5) * x2 * x2 * x1 * x3;
  const auto factors = irreducible_factors(a);
  ASSERT_EQ(factors.size(), 3u);
  EXPECT_EQ(factors[0].first, x1);
  EXPECT_EQ(factors[1], (std::pair<Polynomial, int>(x2, 2)));
  EXPECT_EQ(factors[2].first, x3);
  Polynomial product = Polynomial::constant(5);
  for (const auto& [f, m] : factors) product *= power(f, m);
  EXPECT_EQ(product, a);
}

TEST(Factorisation, Constants) {
  EXPECT_TRUE(irreducible_factors(Polynomial::constant(7)).empty());
  EXPECT_THROW(irreducible_factors(Polynomial()), DomainError);
}
