#include "analysis/nonstationary/asymptotic_bound.hpp"

#include "analysis/uniform/difference_symbol.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

MaskSequence load(const char* name) {
  return *Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name).sequence;
}

/// ||S_{c(mu)} - S_{c(1)}||, c = 2^j a / (1+z)^j, exactly.
Rational distance_to_limit(const MaskSequence& sequence, int factors, const Rational& mu) {
  const LaurentPolynomial c = RationalFunction::constant(1, 2) * *difference_symbol(sequence.mask, factors);
  const LaurentPolynomial difference = c.at(std::array<Rational, 1>{mu}) - c.at(std::array<Rational, 1>{1});
  Rational sums[2] = {0, 0};
  for (int i = difference.is_zero() ? 1 : difference.lowest(); !difference.is_zero() && i <= difference.highest();
       ++i) {
    sums[std::abs(i) % 2] += abs(difference.coefficient(i).constant_value());
  }
  return std::max(sums[0], sums[1]);
}

TEST(AsymptoticBound, HoldsAtSampledAnglesAndLevels) {
  for (const auto& [name, m] : {std::pair{"unified-curve", 1},
                                {"exponential-b-spline-3", 1},
                                {"exponential-b-spline-4", 2},
                                {"six-point-nonstationary", 2}}) {
    const MaskSequence sequence = load(name);
    for (const MaskSequence::Range& range : sequence.types) {
      const auto attempt = bound_difference_to_limit(sequence, range.type, range.angles, m);
      ASSERT_TRUE(attempt.bound) << name << ": " << attempt.reason;
      const AsymptoticBound& bound = *attempt.bound;
      EXPECT_EQ(bound.order, 2) << name;
      EXPECT_GT(bound.order, m - bound.factors);
      double closest = 0;
      for (int k = bound.from_level; k < bound.from_level + 10; ++k) {
        for (int s = 1; s <= 8; ++s) {
          const double x = approx_double(range.angles.upper) * s / 8 / std::exp2(k + 1);
          const double mu = range.type == AngleType::trigonometric ? std::cos(x) : std::cosh(x);
          const double distance = approx_double(distance_to_limit(sequence, bound.factors, Rational(mu)));
          EXPECT_LE(distance, approx_double(bound.constant) * x * x * (1 + 1e-6)) << name << " " << k << " " << s;
          closest = std::max(closest, distance / (approx_double(bound.constant) * x * x));
        }
      }
      EXPECT_GT(closest, range.type == AngleType::trigonometric ? 0.2 : 1e-6) << name << ": the bound is of no use";
    }
  }
}

TEST(AsymptoticBound, AStationaryMaskIsItsOwnLimit) {
  const MaskSequence sequence{
      .types = {{AngleType::trigonometric, {0, 3}}},
      .mask = {2, LaurentPolynomial(1, 0, {RationalFunction::constant(1, 1), RationalFunction::constant(1, 1)})},
      .first_levels = {},
      .interpolated = {}};
  const auto attempt = bound_difference_to_limit(sequence, AngleType::trigonometric, {0, 3}, 5);
  ASSERT_TRUE(attempt.bound);
  EXPECT_GT(attempt.bound->order, 5);
  EXPECT_LT(attempt.bound->constant, Rational(1) / 100000);
}

TEST(AsymptoticBound, TooSlowWithoutFactors) {
  // mu in the centre only: no factor 1 + z unless mu = 1.
  const MultivariatePolynomial mu = MultivariatePolynomial::variable(1, 0);
  const RationalFunction half = RationalFunction::constant(1, Rational(1) / 2);
  const MaskSequence sequence{.types = {{AngleType::trigonometric, {0, 3}}},
                              .mask = {2, LaurentPolynomial(1, -1, {half, RationalFunction(mu), half})},
                              .first_levels = {},
                              .interpolated = {}};
  EXPECT_TRUE(bound_difference_to_limit(sequence, AngleType::trigonometric, {0, 1}, 1).bound);
  const auto attempt = bound_difference_to_limit(sequence, AngleType::trigonometric, {0, 1}, 2);
  EXPECT_FALSE(attempt.bound);
  EXPECT_FALSE(attempt.reason.empty());
}

TEST(LevelRange, ContainsTheLevelParameter) {
  for (int k = 0; k < 8; ++k) {
    for (const double theta : {0.2, 1.0, 3.1}) {
      const Rational exact(theta);
      const double x = theta / std::exp2(k + 1);
      const Interval range = level_range(2, AngleType::trigonometric, {0, 3.2, true, false}, k);
      EXPECT_TRUE(range.contains(Rational(std::cos(x)))) << k;
      EXPECT_FALSE(range.contains(Rational(1)));
      EXPECT_TRUE(tail_range(2, AngleType::hyperbolic, {0, exact}, 0).contains(Rational(std::cosh(x * (1 - 1e-9)))));
    }
  }
  EXPECT_EQ(level_range(2, AngleType::trigonometric, Interval::point(0), 3), Interval::point(1));
}

/// The 4-point scheme with w_k = 1/(8+k) is C^1 although its limit, the polygon (w = 0), is not: the second differences of the first
/// divided differences decay so fast that they are summable. So nothing about a nonstationary scheme follows from its limit not
/// being C^m. Exact norms of products of the difference schemes with a = (1+z)^2/2 b.
TEST(AsymptoticBound, ALimitThatIsNotC1RefutesNothing) {
  const auto b = [](const Rational& w) {
    return LaurentPolynomial::from_rationals(0, {-2 * w, 4 * w, 1 - 4 * w, 4 * w, -2 * w});
  };
  const auto norm = [&](int levels, auto tension) {
    LaurentPolynomial product = LaurentPolynomial::from_rationals(0, {1});
    for (int k = 0; k < levels; ++k)
      product = b(tension(k)) * product.dilated(2);  // the step 0 acts first, with the widest spacing
    std::vector<Rational> sums(std::size_t{1} << levels);
    for (int i = 0; i <= product.highest(); ++i)
      sums[static_cast<std::size_t>(i) % sums.size()] += abs(product.coefficient(i).constant_value());
    return approx_double(*std::max_element(sums.begin(), sums.end()));
  };
  const auto slow = [](int k) { return Rational(1) / (8 + k); };
  const auto zero = [](int) { return Rational(0); };
  EXPECT_EQ(norm(8, zero), 1);
  // The norms fall at least like (8 + k)^-1.5, while w = 0 would keep them at 1.
  const double at4 = norm(4, slow), at8 = norm(8, slow), at12 = norm(12, slow);
  EXPECT_LT(at8, at4 * std::pow(16.0 / 12, -1.5));
  EXPECT_LT(at12, at8 * std::pow(20.0 / 16, -1.5));
}

}  // namespace
}  // namespace limes
