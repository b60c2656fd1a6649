#include "algebra/matrix/exact_solve.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

TEST(ExactSolve, SolvesRandomSystemsAndKnowsSingularOnes) {
  std::mt19937 random(1);
  const auto number = [&] {
    return Rational(static_cast<int>(random() % 41) - 20) / static_cast<int>(1 + random() % 9);
  };
  for (int trial = 0; trial < 20; ++trial) {
    const int n = 1 + trial % 6;
    RationalMatrix a(n, n), b(n, 3);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) a(i, j) = number();
      for (int j = 0; j < 3; ++j) b(i, j) = number();
    }
    const std::optional<RationalMatrix> x = exact_solve(a, b);
    EXPECT_EQ(x.has_value(), rank(a) == n);
    if (x) {
      EXPECT_EQ(a * *x, b);
    }
    if (n > 1) {
      for (int j = 0; j < n; ++j) a(1, j) = 2 * a(0, j);
      EXPECT_FALSE(exact_solve(a, b));
    }
  }
  EXPECT_THROW(exact_solve(RationalMatrix(2, 3), RationalMatrix(2, 1)), DomainError);
}

}  // namespace
}  // namespace limes
