#include "algebra/polynomial/real_roots.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace limes {
namespace {

Polynomial linear(const Rational& root) { return Polynomial({-root, 1}); }

// Every property that the header promises and that can be checked from outside.
void check_isolation(const Polynomial& a, const Rational& width, int expected_roots) {
  const auto intervals = isolate_real_roots(a, width);
  EXPECT_EQ(int(intervals.size()), expected_roots);
  EXPECT_EQ(count_real_roots(a), expected_roots);
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto& [lower, upper, multiplicity] = intervals[i];
    EXPECT_LE(lower, upper);
    EXPECT_LE(upper - lower, width);
    if (i > 0) {
      EXPECT_LT(intervals[i - 1].upper, lower);
    }
    if (lower == upper) {
      EXPECT_EQ(a(lower), 0);
    } else {
      EXPECT_NE(a(lower), 0);
      EXPECT_NE(a(upper), 0);
      EXPECT_EQ(count_real_roots(a, lower, upper), 1);
    }
    // The multiplicity is the number of derivatives that keep the root.
    Polynomial d = a;
    for (int k = 0; k < multiplicity; ++k, d = derivative(d)) {
      const Polynomial common = gcd(d, square_free_part(a));
      const bool root =
          lower == upper ? common(lower) == 0 : common.degree() > 0 && count_real_roots(common, lower, upper) == 1;
      EXPECT_TRUE(root);
    }
    const Polynomial left = gcd(d, square_free_part(a));
    const bool root =
        lower == upper ? left(lower) == 0 : left.degree() > 0 && count_real_roots(left, lower, upper) == 1;
    EXPECT_FALSE(root);
  }
}

TEST(RealRoots, HalfOpenCounts) {
  const Polynomial a = linear(0) * linear(1) * linear(1) * linear(2);
  EXPECT_EQ(count_real_roots(a), 3);
  EXPECT_EQ(count_real_roots(a, 0, 2), 2);
  EXPECT_EQ(count_real_roots(a, -1, 2), 3);
  EXPECT_EQ(count_real_roots(a, 0, 1), 1);
  EXPECT_EQ(count_real_roots(a, 1, 1), 0);
  EXPECT_EQ(count_real_roots(a, Rational(1, 2), Rational(3, 2)), 1);
  EXPECT_EQ(count_real_roots(a, 2, 100), 0);
  EXPECT_EQ(count_real_roots(-a, -1, 1), 2);
}

TEST(RealRoots, ConstantsAndErrors) {
  EXPECT_EQ(count_real_roots(Polynomial::constant(-3)), 0);
  EXPECT_EQ(count_real_roots(Polynomial::constant(-3), 0, 1), 0);
  EXPECT_TRUE(isolate_real_roots(Polynomial::constant(5), 1).empty());
  EXPECT_THROW(count_real_roots(Polynomial()), DomainError);
  EXPECT_THROW(isolate_real_roots(Polynomial(), 1), DomainError);
  EXPECT_THROW(isolate_real_roots(linear(1), 0), DomainError);
  EXPECT_THROW(count_real_roots(linear(1), 2, 1), DomainError);
}

TEST(RealRoots, SquareRootOfTwo) {
  const auto roots = isolate_real_roots(Polynomial({-2, 0, 1}), Rational(1, Integer(1) << 200));
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_LT(roots[1].lower * roots[1].lower, 2);
  EXPECT_GT(roots[1].upper * roots[1].upper, 2);
  EXPECT_GT(roots[0].lower * roots[0].lower, 2);
  EXPECT_LT(roots[0].upper * roots[0].upper, 2);
}

TEST(RealRoots, RationalRootsBecomePoints) {
  const auto roots =
      isolate_real_roots(linear(Rational(1, 3)) * linear(0) * linear(Rational(-22, 7)), Rational(1, 1000));
  ASSERT_EQ(roots.size(), 3u);
  const Rational expected[] = {Rational(-22, 7), 0, Rational(1, 3)};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(roots[i].lower, expected[i]);
    EXPECT_EQ(roots[i].upper, expected[i]);
  }
}

TEST(RealRoots, WilkinsonAndPerturbed) {
  Polynomial wilkinson = Polynomial::constant(1);
  for (int i = 1; i <= 20; ++i) wilkinson *= linear(i);
  check_isolation(wilkinson, Rational(1, 100), 20);
  // Wilkinson's perturbation x^19 -> x^19 - 2^{-23} x^19 leaves ten real roots.
  check_isolation(wilkinson - Polynomial::monomial(Rational(1, 1 << 23), 19), Rational(1, 100), 10);
}

TEST(RealRoots, ChebyshevHasAllItsRootsInTheUnitInterval) {
  Polynomial before = Polynomial::constant(1), now = Polynomial::monomial(1, 1);
  for (int n = 1; n < 30; ++n) {
    Polynomial next = Polynomial::monomial(2, 1) * now - before;
    before = now;
    now = next;
  }
  check_isolation(now, 1, 30);
  EXPECT_EQ(count_real_roots(now, -1, 1), 30);
}

TEST(RealRoots, MignotteHasTwoVeryCloseRoots) {
  // x^20 - 2 (1000 x - 1)^2: two roots within 10^{-31} of 1/1000.
  const Polynomial a = Polynomial::monomial(1, 20) - Rational(2) * power(Polynomial({-1, 1000}), 2);
  check_isolation(a, 1, 4);
}

TEST(RealRoots, RootsOnCutsOfTheBisection) {
  check_isolation(linear(0) * linear(1) * linear(-1) * linear(Rational(1, 2)) * Polynomial({-2, 0, 1}), 100, 6);
  check_isolation(power(linear(0), 3) * power(Polynomial({-2, 0, 1}), 2), Rational(1, 10), 3);
}

TEST(RealRoots, RandomProductsOfKnownFactors) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    Polynomial a = Polynomial::constant(Rational(int(random() % 9) - 10, 3));
    std::set<Rational> roots;
    for (int i = 0; i < 4; ++i) {
      const Rational root(int(random() % 21) - 10, 1 + int(random() % 6));
      roots.insert(root);
      a *= power(linear(root), 1 + int(random() % 3));
      // x^2 + b x + c with c > b^2 / 4 has no real root.
      const int b = int(random() % 7) - 3;
      a *= Polynomial({Rational(b * b + 1 + int(random() % 5)), Rational(b), 1});
    }
    check_isolation(a, Rational(1, 1 + int(random() % 50)), int(roots.size()));
  }
}

TEST(RealRoots, RandomPolynomialsCountsAddUp) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Rational> coefficients;
    for (unsigned i = 0; i < 3 + random() % 10; ++i) coefficients.emplace_back(int(random() % 41) - 20);
    coefficients.emplace_back(1 + int(random() % 5));
    const Polynomial a(coefficients);
    const int all = count_real_roots(a);
    check_isolation(a, Rational(1, 7), all);
    EXPECT_EQ(count_real_roots(a, -1000, Rational(1, 3)) + count_real_roots(a, Rational(1, 3), 1000), all);
    // x -> -x and x -> 1/x (as a(0) may vanish, count the latter off 0).
    EXPECT_EQ(count_real_roots(compose(a, Polynomial({0, -1}))), all);
    EXPECT_EQ(count_real_roots(reversed(a)), all - (a(0) == 0 ? 1 : 0));
  }
}

}  // namespace
}  // namespace limes
