#include "analysis/unity/filter_norms.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace limes {
namespace {

/// |f_even|^2 + |f_odd|^2 at a frequency, from the definition.
double power_at(const std::vector<Rational>& filter, double omega) {
  std::complex<double> part[2];
  for (std::size_t i = 0; i < filter.size(); ++i)
    part[i % 2] += approx_double(filter[i]) * std::polar(1.0, omega * static_cast<double>(i / 2));
  return std::norm(part[0]) + std::norm(part[1]);
}

TEST(FilterNorms, KnownFilters) {
  // P^T P of Chaikin's scheme has the symbol (10 + 6 cos omega) / 8.
  const std::vector<Rational> chaikin{Rational(1) / 4, Rational(3) / 4, Rational(3) / 4, Rational(1) / 4};
  const SquaredSingularValues s = squared_singular_values(chaikin);
  EXPECT_LE(s.least.bounds.lower, Rational(1) / 2);
  EXPECT_GE(s.least.bounds.upper, Rational(1) / 2);
  EXPECT_LE(s.greatest.bounds.lower, 2);
  EXPECT_GE(s.greatest.bounds.upper, 2);
  EXPECT_LT(s.greatest.bounds.upper - s.greatest.bounds.lower, power(Rational(10), -11));
  EXPECT_EQ(s.least.witness, -1);
  const SquaredSingularValues haar = squared_singular_values({1, 1});  // constant
  EXPECT_LE(haar.greatest.bounds.lower, 2);
  EXPECT_GE(haar.least.bounds.upper, 2);
  EXPECT_THROW(squared_singular_values({0, 0}), DomainError);
}

TEST(FilterNorms, BoundsHoldOnAGridAndAreNarrow) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Rational> filter;
    for (int i = 0; i < 2 + trial; ++i) filter.push_back(Rational(static_cast<int>(random() % 2001) - 1000) / 321);
    filter.push_back(1);
    const SquaredSingularValues s = squared_singular_values(filter);
    for (const ExtremeValue& e : {s.least, s.greatest}) {
      EXPECT_LE(e.bounds.lower, e.bounds.upper);
      EXPECT_LT(e.bounds.upper - e.bounds.lower, s.greatest.bounds.upper * power(Rational(10), -9));
      EXPECT_LE(abs(e.witness), 1);
    }
    const double low = approx_double(s.least.bounds.lower), high = approx_double(s.greatest.bounds.upper);
    double least = high, greatest = 0;
    for (int i = 0; i <= 4000; ++i) {
      const double value = power_at(filter, 3.14159265358979 * i / 4000);
      least = std::min(least, value), greatest = std::max(greatest, value);
    }
    EXPECT_GE(least, low - 1e-9 * high);
    EXPECT_LE(greatest, high * (1 + 1e-9));
    EXPECT_LE(least - low, 1e-3 * high);
    EXPECT_LE(high - greatest, 1e-3 * high);
  }
}

TEST(FilterNorms, SquareRootsAreEnclosed) {
  for (const Rational& x : {Rational(2), Rational(9) / 32, Rational(1) / 1000003, power(Rational(10), 30) + 1,
                            Rational(49) / 64, power(Rational(7), -60)}) {
    const RationalBounds root = sqrt_bounds(x);
    EXPECT_LE(root.lower * root.lower, x);
    EXPECT_GE(root.upper * root.upper, x);
    EXPECT_LE(root.upper - root.lower, root.upper * power(Rational(2), -58));
  }
  EXPECT_EQ(sqrt_bounds(Rational(49) / 64).lower, Rational(7) / 8);
  EXPECT_EQ(sqrt_bounds(Rational(49) / 64).upper, Rational(7) / 8);
}

}  // namespace
}  // namespace limes
