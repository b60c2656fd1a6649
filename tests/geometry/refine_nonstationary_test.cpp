#include "geometry/refine_polygon.hpp"

#include "algebra/error.hpp"
#include "algebra/number/elementary.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

MaskSequence load(const char* name) {
  return *Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name).sequence;
}

const double pi = approx_double(pi_enclosure().lower);
constexpr auto trigonometric = AngleType::trigonometric;

Polygon circle(int corners, int points, bool closed) {
  std::vector<double> coordinates;
  for (int k = 0; k < points; ++k) {
    coordinates.push_back(std::cos(2 * pi * k / corners));
    coordinates.push_back(std::sin(2 * pi * k / corners));
  }
  return {2, coordinates, closed};
}

NonstationaryRule circle_rule(const char* name, int corners, int levels) {
  return approx_nonstationary_rule(load(name), trigonometric, pi_enclosure().lower * 2 / corners, levels);
}

double distance_from_circle(const Polygon& polygon) {
  double worst = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    worst = std::max(worst, std::abs(std::hypot(polygon[i][0], polygon[i][1]) - 1));
  return worst;
}

TEST(RefineNonstationary, ClosedPolygonsStayOnTheirCircle) {
  for (const char* name : {"unified-curve", "six-point-nonstationary"}) {
    for (const int corners : {3, 4, 5, 7, 12, 100}) {
      const Polygon result = refine_polygon(circle(corners, corners, true), circle_rule(name, corners, 10), {10});
      EXPECT_EQ(result.size(), static_cast<std::size_t>(corners) << 10);
      EXPECT_LT(distance_from_circle(result), 1e-13) << name << " " << corners;
      EXPECT_NEAR(result[512][0], std::cos(pi / corners), 1e-13);
    }
  }
}

TEST(RefineNonstationary, TheWrongAngleLeavesTheCircle) {
  const Polygon result = refine_polygon(circle(7, 7, true), circle_rule("unified-curve", 8, 6), {6});
  EXPECT_GT(distance_from_circle(result), 1e-3);
}

TEST(RefineNonstationary, ArcsKeepTheirCircleWithExactEndsOnly) {
  NonstationaryRule rule = circle_rule("unified-curve", 9, 8);
  rule.continuation = approx_continuation(read_exponential_functions("{1, y, cos, sin}"), 2 * pi / 9);
  const Polygon arc = circle(9, 5, false);
  const Polygon exact = refine_polygon(arc, rule, {8, EndRule::exact});
  EXPECT_EQ(exact.size(), 4u * 256 + 1);
  EXPECT_LT(distance_from_circle(exact), 1e-13);
  const Polygon linear = refine_polygon(arc, rule, {8, EndRule::extend});
  EXPECT_EQ(linear.size(), exact.size());
  EXPECT_GT(distance_from_circle(linear), 1e-3);
  EXPECT_LT(distance_from_circle(refine_polygon(circle(9, 9, false), rule, {8, EndRule::shrink})), 1e-13);
}

// Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, section 2.4: the first new point with q_{-1} = 2 q_0 - q_1.
TEST(RefineNonstationary, LinearEndsHaveThePublishedWeights) {
  const double theta = 0.8, mu = std::cos(theta / 2), d = 8 * mu * (mu + 1), s = (2 * mu + 1) * (2 * mu + 1);
  const NonstationaryRule rule = approx_nonstationary_rule(load("unified-curve"), trigonometric, Rational(4) / 5, 1);
  for (int j = 0; j < 5; ++j) {
    std::vector<double> unit(5);
    unit[static_cast<std::size_t>(j)] = 1;
    const Polygon result = refine_polygon(Polygon(1, unit), rule, {1, EndRule::extend});
    const double weights[] = {(s - 2) / d, (s + 1) / d, -1 / d, 0, 0};
    EXPECT_NEAR(result[1][0], weights[j], 1e-15) << j;
  }
}

TEST(RefineNonstationary, TheContinuationOfTheUnifiedSpace) {
  for (const auto& [text, c] : {std::pair{"{1, y, cos, sin}", std::cos(0.7)}, {"{1, y, cosh, sinh}", std::cosh(0.7)}}) {
    const std::vector<double> weights = approx_continuation(read_exponential_functions(text), 0.7);
    ASSERT_EQ(weights.size(), 4u);
    const double expected[] = {2 + 2 * c, -2 - 4 * c, 2 + 2 * c, -1};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(weights[k], expected[k], 1e-14);
  }
}

TEST(RefineNonstationary, CatenariesAndCubics) {
  std::vector<double> catenary, cubic;
  for (int k = -3; k <= 3; ++k) {
    catenary.push_back(std::cosh(0.9 * k));
    cubic.push_back(k * k * k - 2.0 * k);
  }
  NonstationaryRule hyperbolic =
      approx_nonstationary_rule(load("unified-curve"), AngleType::hyperbolic, Rational(9) / 10, 6);
  hyperbolic.continuation = approx_continuation(read_exponential_functions("{1, y, cosh, sinh}"), 0.9);
  const Polygon fine = refine_polygon(Polygon(1, catenary), hyperbolic, {6, EndRule::exact});
  for (std::size_t i = 0; i < fine.size(); ++i)
    EXPECT_NEAR(fine[i][0], std::cosh(0.9 * (static_cast<double>(i) / 64 - 3)), 1e-12);
  NonstationaryRule polynomial = approx_nonstationary_rule(load("unified-curve"), trigonometric, 0, 6);
  polynomial.continuation = approx_continuation(read_exponential_functions("{1, y, y^2, y^3}"), 0);
  const Polygon curve = refine_polygon(Polygon(1, cubic), polynomial, {6, EndRule::exact});
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double y = static_cast<double>(i) / 64 - 3;
    EXPECT_NEAR(curve[i][0], y * y * y - 2 * y, 1e-12);
  }
}

TEST(RefineNonstationary, AngleZeroIsTheFourPointScheme) {
  const Catalogue catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue");
  const UniformRule four_point =
      approx_uniform_rule(catalogue.load("four-point").mask, std::vector<Rational>{Rational(1) / 16});
  const NonstationaryRule rule = approx_nonstationary_rule(load("unified-curve"), trigonometric, 0, 5);
  const Polygon polygon = circle(5, 5, true);
  EXPECT_EQ(refine_polygon(polygon, rule, {5}).coordinates(), refine_polygon(polygon, four_point, {5}).coordinates());
}

TEST(RefineNonstationary, SplinesOfRegularPolygonsAreCircles) {
  for (const char* name : {"exponential-b-spline-3", "exponential-b-spline-4"}) {
    const Polygon result = refine_polygon(circle(6, 6, true), circle_rule(name, 6, 7), {7});
    const double radius = std::hypot(result[0][0], result[0][1]);
    for (std::size_t i = 0; i < result.size(); ++i)
      EXPECT_NEAR(std::hypot(result[i][0], result[i][1]), radius, 1e-13) << name;
    EXPECT_LT(radius, 1);
  }
}

TEST(RefineNonstationary, WhatCannotBeDone) {
  const NonstationaryRule rule = circle_rule("unified-curve", 7, 3);
  EXPECT_THROW(refine_polygon(circle(7, 7, true), rule, {4}), DomainError);
  EXPECT_THROW(refine_polygon(circle(7, 5, false), rule, {3, EndRule::exact}), DomainError);  // no continuation
  EXPECT_THROW(refine_polygon(circle(7, 3, false), rule, {3}), InputError);
  EXPECT_EQ(refine_polygon(circle(7, 7, true), rule, {0}).size(), 7u);
}

}  // namespace
}  // namespace limes
