#include "geometry/refine_polygon.hpp"

#include "algebra/error.hpp"
#include "geometry/knots.hpp"
#include "tests/geometry/data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

namespace limes {
namespace {

/// The polynomial through all points of the stencil, at the middle.
NonuniformRule lagrange(int points) {
  return {points, [points](std::span<const double> t) {
            const auto size = static_cast<std::size_t>(points);
            const double x = (t[size / 2 - 1] + t[size / 2]) / 2;
            std::vector<double> weights(size, 1.0);
            for (std::size_t j = 0; j < size; ++j) {
              for (std::size_t k = 0; k < size; ++k) {
                if (k != j) weights[j] *= (x - t[k]) / (t[j] - t[k]);
              }
            }
            return weights;
          }};
}

/// A polygon with knots whose intervals differ by a factor of up to 100.
Polygon random_data(std::size_t size, bool closed, unsigned seed) {
  const Polygon polygon = test::random_polygon(2, size, closed, seed);
  const Polygon intervals = test::random_polygon(1, size, false, seed + 100);
  std::vector<double> knots{-3};
  for (std::size_t i = 0; i < polygon.edges(); ++i) knots.push_back(knots.back() + std::pow(10, intervals[i][0]));
  return polygon.with_knots(knots);
}

TEST(RefineNonuniform, CommutesWithAffineMapsOfPointsAndOfKnots) {
  for (const bool closed : {false, true}) {
    for (const EndRule ends : {EndRule::extend, EndRule::shrink}) {
      const Polygon polygon = random_data(14, closed, 1);
      const Polygon refined = refine_polygon(polygon, lagrange(4), {3, ends});
      EXPECT_LT(test::gap(refine_polygon(test::mapped(polygon), lagrange(4), {3, ends}).coordinates(),
                          test::mapped(refined).coordinates()),
                1e-12);
      std::vector<double> knots = polygon.knots();
      for (double& t : knots) t = 1000 * t + 77;
      const Polygon moved = refine_polygon(polygon.with_knots(knots), lagrange(4), {3, ends});
      EXPECT_LT(test::gap(moved.coordinates(), refined.coordinates()), 1e-9);
      for (std::size_t i = 0; i < moved.knots().size(); ++i)
        EXPECT_NEAR(moved.knots()[i], 1000 * refined.knots()[i] + 77, 1e-9);
    }
  }
}

TEST(RefineNonuniform, KnotsAreRefinedByMidpointsAndOldPointsKept) {
  for (const bool closed : {false, true}) {
    const Polygon polygon = random_data(9, closed, 2);
    const Polygon refined = refine_polygon(polygon, lagrange(6), {4});
    ASSERT_EQ(refined.size(), 16 * polygon.edges() + (closed ? 0 : 1));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      EXPECT_THAT(refined[16 * i], ::testing::ElementsAreArray(polygon[i].begin(), polygon[i].end()));
    }
    for (std::size_t i = 0; i < polygon.knots().size(); ++i) EXPECT_EQ(refined.knots()[16 * i], polygon.knots()[i]);
    for (std::size_t i = 1; i + 1 < refined.knots().size(); ++i) {
      if (i % 16 == 0) continue;
      EXPECT_NEAR(refined.knots()[i] - refined.knots()[i - 1], refined.knots()[i + 1] - refined.knots()[i], 1e-12);
    }
  }
}

TEST(RefineNonuniform, ClosedPolygonsRotate) {
  for (const std::size_t size : {3u, 10u}) {
    const Polygon polygon = random_data(size, true, 3);
    const Polygon refined = refine_polygon(polygon, lagrange(6), {3});
    const Polygon other = refine_polygon(test::rotated(polygon, 2), lagrange(6), {3});
    EXPECT_LT(test::gap(other.coordinates(), test::rotated(refined, 16).coordinates()), 1e-6);
    EXPECT_LT(test::gap(other.knots(), test::rotated(refined, 16).knots()), 1e-12);
  }
}

TEST(RefineNonuniform, OneLevelTwiceIsTwoLevels) {
  for (const bool closed : {false, true}) {
    const Polygon polygon = random_data(20, closed, 4);
    const Refinement once{1, EndRule::shrink}, twice{2, EndRule::shrink};
    const Polygon step_by_step = refine_polygon(refine_polygon(polygon, lagrange(4), once), lagrange(4), once);
    const Polygon at_once = refine_polygon(polygon, lagrange(4), twice);
    EXPECT_LT(test::gap(step_by_step.coordinates(), at_once.coordinates()), 1e-12);
    EXPECT_LT(test::gap(step_by_step.knots(), at_once.knots()), 1e-12);
  }
}

TEST(RefineNonuniform, LinearDataStayLinearOverMatchingKnots) {
  std::vector<double> points;
  const std::vector<double> knots{0, 1, 1.5, 6, 6.25, 9};
  for (const double t : knots) points.insert(points.end(), {3 * t + 1, -t});
  const Polygon line(2, points, false, knots);
  const Polygon refined = refine_polygon(line, lagrange(6), {5});
  EXPECT_EQ(refined.size(), 161u);
  for (std::size_t i = 0; i < refined.size(); ++i) {
    EXPECT_NEAR(refined[i][0], 3 * refined.knots()[i] + 1, 1e-11);
    EXPECT_NEAR(refined[i][1], -refined.knots()[i], 1e-11);
  }
}

TEST(RefineNonuniform, ReproducesPolynomialsInside) {
  const Polygon data = random_data(12, false, 5);
  const auto f = [](double t) { return t * (t - 1) * (t + 2); };
  std::vector<double> values;
  for (const double t : data.knots()) values.push_back(f(t));
  const Polygon refined = refine_polygon(Polygon(1, values, false, data.knots()), lagrange(4), {5, EndRule::shrink});
  ASSERT_GT(refined.size(), 100u);
  EXPECT_GE(refined.knots().front(), data.knots()[1]);
  EXPECT_LE(refined.knots().back(), data.knots()[10]);
  for (std::size_t i = 0; i < refined.size(); ++i) EXPECT_NEAR(refined[i][0], f(refined.knots()[i]), 1e-7);
}

TEST(RefineNonuniform, EqualIntervalsGiveTheUniformScheme) {
  const Rational s = Rational(1) / 16;
  const UniformRule uniform =
      approx_uniform_rule({2, LaurentPolynomial::from_rationals(-3, {-s, 0, 9 * s, 1, 9 * s, 0, -s})}, {});
  for (const bool closed : {false, true}) {
    const Polygon polygon = test::random_polygon(2, 12, closed, 6);
    for (const EndRule ends : {EndRule::extend, EndRule::shrink}) {
      const Polygon spaced = polygon.with_knots(spaced_knots(polygon, KnotSpacing::uniform));
      EXPECT_LT(test::gap(refine_polygon(spaced, lagrange(4), {4, ends}).coordinates(),
                          refine_polygon(polygon, uniform, {4, ends}).coordinates()),
                1e-13);
    }
  }
}

TEST(RefineNonuniform, UsesTheInsertionRulesOfSchemes) {
  const InsertionRule cubic(read_expression("16*w*at(f(3,0),1/2) + (1-16*w)*at(f(1,0),1/2)"), {"w"});
  const Polygon polygon = random_data(10, false, 7);
  const std::vector<Rational> sixteenth{Rational(1) / 16}, zero{0};
  EXPECT_LT(test::gap(refine_polygon(polygon, approx_nonuniform_rule(cubic, sixteenth), {3}).coordinates(),
                      refine_polygon(polygon, lagrange(4), {3}).coordinates()),
            1e-12);
  EXPECT_GT(test::gap(refine_polygon(polygon, approx_nonuniform_rule(cubic, zero), {3}).coordinates(),
                      refine_polygon(polygon, lagrange(4), {3}).coordinates()),
            1e-3);
}

TEST(RefineNonuniform, AsksForFewStencils) {
  int calls = 0;
  NonuniformRule counting = lagrange(6);
  counting.stencil = [&calls, ask = counting.stencil](std::span<const double> t) { return ++calls, ask(t); };
  const Polygon refined = refine_polygon(random_data(10, true, 8), counting, {12});
  EXPECT_EQ(refined.size(), 40960u);
  // Two rounds for all windows, then the four patterns around each of ten knots and the uniform one.
  EXPECT_LE(calls, 10 + 20 + 40 + 1);
}

TEST(RefineNonuniform, BadInputIsRejected) {
  EXPECT_THROW(refine_polygon(test::random_polygon(2, 9, false, 1), lagrange(4), {1}), DomainError) << "no knots";
  EXPECT_THROW(refine_polygon(random_data(5, false, 1), lagrange(6), {1}), InputError);
  EXPECT_NO_THROW(refine_polygon(random_data(6, false, 1), lagrange(6), {1}));
  EXPECT_THROW(refine_polygon(random_data(9, false, 1), lagrange(4), {30}), LimitError);
  EXPECT_THROW(refine_polygon(Polygon(1, {0, 1, 2, 3}, false, {0, 1e-300, 1e300, 2e300}), lagrange(4), {1}),
               InputError);
  EXPECT_THROW(refine_polygon(Polygon(1, {0, 1, 2, 3}, false, {1, 1.0000000000000002, 2, 3}), lagrange(4), {3}),
               DomainError);
  const std::atomic<bool> stopped{true};
  EXPECT_THROW(refine_polygon(random_data(9, false, 1), lagrange(4), {3}, Stop(&stopped)), Interrupted);
}

}  // namespace
}  // namespace limes
