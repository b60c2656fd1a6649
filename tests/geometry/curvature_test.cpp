#include "geometry/curvature.hpp"

#include "algebra/error.hpp"
#include "tests/geometry/data.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace limes {
namespace {

/// Unequally spaced points of a circle, counterclockwise.
Polygon circle(double radius, bool closed) {
  std::vector<double> points;
  for (const double turn : {0.0, 0.03, 0.1, 0.3, 0.45, 0.5, 0.71, 0.9}) {
    const double angle = 2 * std::numbers::pi * turn;
    points.insert(points.end(), {radius * std::cos(angle) + 3, radius * std::sin(angle) - 1});
  }
  return {2, points, closed};
}

TEST(Curvature, OfACircleIsOneOverTheRadius) {
  for (const double radius : {0.01, 1.0, 250.0}) {
    for (const bool closed : {false, true}) {
      for (const double k : curvatures(circle(radius, closed))) EXPECT_NEAR(k * radius, 1, 1e-10);
    }
  }
}

TEST(Curvature, ReversalChangesTheSign) {
  const Polygon forward = test::random_polygon(2, 12, true, 3);
  std::vector<double> points;
  for (std::size_t i = forward.size(); i-- > 0;) points.insert(points.end(), forward[i].begin(), forward[i].end());
  const std::vector<double> there = curvatures(forward), back = curvatures(Polygon(2, points, true));
  double greatest = 0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    EXPECT_NEAR(there[i], -back[there.size() - 1 - i], 1e-10 * std::abs(there[i]));
    greatest = std::max(greatest, there[i]);
  }
  EXPECT_GT(greatest, 0);
}

TEST(Curvature, OfAHelixInSpace) {
  // Radius 2 and slope 1: curvature 2 / (2^2 + 1^2).
  std::vector<double> points;
  for (int i = 0; i < 50; ++i) points.insert(points.end(), {2 * std::cos(0.01 * i), 2 * std::sin(0.01 * i), 0.01 * i});
  for (const double k : curvatures(Polygon(3, points))) EXPECT_NEAR(k, 0.4, 1e-4);
}

TEST(Curvature, VanishesOnLinesAndWhereThereIsNoCircle) {
  for (const double k : curvatures(Polygon(2, {0, 0, 1, 2, 3, 6, 4, 8}))) EXPECT_NEAR(k, 0, 1e-14);
  for (const double k : curvatures(Polygon(2, {0, 0, 0, 0, 1, 1, 0, 0}))) EXPECT_EQ(k, 0);
  EXPECT_EQ(curvatures(Polygon(2, {0, 0, 1, 1})), (std::vector<double>{0, 0}));
}

TEST(Curvature, CombPointsOutwards) {
  const Polygon polygon = circle(2, true);
  const std::vector<double> tips = curvature_comb(polygon, 4);  // teeth of length 4/2 on a circle of radius 2
  for (std::size_t i = 0; i < polygon.size(); ++i)
    EXPECT_NEAR(std::hypot(tips[2 * i] - 3, tips[2 * i + 1] + 1), 4, 1e-10);
  EXPECT_THROW(curvature_comb(polygon, 1e308 * 10), DomainError);
}

}  // namespace
}  // namespace limes
