#include "algebra/polynomial/root_clusters.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/complex_roots.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

/// As coefficients without variables.
std::vector<MultivariatePolynomial> constants(const Polynomial& a) {
  std::vector<MultivariatePolynomial> result;
  for (const Rational& c : a.coefficients()) result.push_back(MultivariatePolynomial::constant(0, c));
  return result;
}

bool overlap(const Interval& a, const Interval& b) { return a.lower <= b.upper && b.lower <= a.upper; }
bool inside(const Interval& a, const Interval& b) { return b.lower <= a.lower && a.upper <= b.upper; }

TEST(RootClusters, ContainTheRootsOfRandomPolynomials) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> digit(-9, 9);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Rational> coefficients;
    for (int k = 0; k < 8; ++k) coefficients.emplace_back(digit(random));
    coefficients.emplace_back(1 + trial % 5);
    const Polynomial a(coefficients);
    const std::vector<RootCluster> clusters = enclose_root_clusters(constants(a), {}, 200);
    int count = 0;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      count += clusters[i].count;
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(overlap(clusters[i].re, clusters[k].re) && overlap(clusters[i].im, clusters[k].im));
    }
    EXPECT_EQ(count, 8);
    for (const ComplexRoot& root : enclose_complex_roots(a, 1000)) {
      int found = 0;
      for (const RootCluster& c : clusters) {
        if (!inside(root.re, c.re) || !inside(root.im, c.im)) continue;
        EXPECT_GE(c.count, root.multiplicity);
        EXPECT_TRUE(inside(root.modulus, c.modulus));
        found += 1;
      }
      EXPECT_EQ(found, 1);
    }
  }
}

// x^2 - 2 t for t in [0.99, 1.01]: +-sqrt(2 t); what is real for all t is said to be real.
TEST(RootClusters, HoldForAllCoefficientsOfABox) {
  const MultivariatePolynomial t = MultivariatePolynomial::variable(1, 0), one = MultivariatePolynomial::constant(1, 1), zero(1);
  const Interval near_one{Rational(99) / 100, Rational(101) / 100};
  const Box box{near_one};
  const std::vector<RootCluster> clusters = enclose_root_clusters({Rational(-2) * t, zero, one}, box, 100);
  ASSERT_EQ(clusters.size(), 2u);
  for (const RootCluster& c : clusters) {
    EXPECT_EQ(c.im, Interval::point(0));
    EXPECT_LE(c.modulus.lower * c.modulus.lower, 2 * box[0].lower);
    EXPECT_GE(c.modulus.upper * c.modulus.upper, 2 * box[0].upper);
    EXPECT_LT(c.modulus.width(), Rational(1) / 10);
  }
  const Box around_zero{Interval{Rational(-1), Rational(1)}};
  const std::vector<MultivariatePolynomial> vanishing{one, t};
  EXPECT_THROW(enclose_root_clusters(vanishing, around_zero, 100), DomainError);
}

}  // namespace
}  // namespace limes
