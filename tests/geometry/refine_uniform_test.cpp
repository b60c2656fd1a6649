#include "geometry/refine_polygon.hpp"

#include "algebra/error.hpp"
#include "tests/geometry/data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limes {
namespace {

UniformRule rule(int first_index, std::vector<Rational> mask, int arity = 2) {
  return approx_uniform_rule({arity, LaurentPolynomial::from_rationals(first_index, mask)}, {});
}

Rational over(int p, int q) { return Rational(p) / q; }

const UniformRule chaikin = rule(-2, {over(1, 4), over(3, 4), over(3, 4), over(1, 4)});
const UniformRule cubic_spline = rule(-2, {over(1, 8), over(1, 2), over(3, 4), over(1, 2), over(1, 8)});
const UniformRule four_point = rule(-3, {over(-1, 16), 0, over(9, 16), 1, over(9, 16), 0, over(-1, 16)});
/// The same four-point scheme with indices far from the middle: only places may differ, not points.
const UniformRule shifted_four_point = rule(40, {over(-1, 16), 0, over(9, 16), 1, over(9, 16), 0, over(-1, 16)});
const UniformRule dual_four_point = rule(-4, {over(-5, 128), over(-7, 128), over(35, 128), over(105, 128),
                                              over(105, 128), over(35, 128), over(-7, 128), over(-5, 128)});
/// Interpolatory of arity 3 [Hassan, Ivrissimtzis, Dodgson & Sabin 2002], mu = 1/11.
const UniformRule ternary = [] {
  const Rational mu = over(1, 11), a = -over(1, 18) - mu / 6, b = over(13, 18) + mu / 2, c = over(7, 18) - mu / 2,
                 d = mu / 6 - over(1, 18);
  return rule(-5, {d, a, 0, c, b, 1, b, c, 0, a, d}, 3);
}();
const std::vector<UniformRule> all_rules{chaikin,         cubic_spline, four_point, shifted_four_point,
                                         dual_four_point, ternary};

Polygon reversed(const Polygon& polygon) {
  std::vector<double> coordinates;
  for (std::size_t i = polygon.size(); i-- > 0;)
    coordinates.insert(coordinates.end(), polygon[i].begin(), polygon[i].end());
  return {polygon.dimension(), coordinates, polygon.closed()};
}

/// Whether `part` are consecutive points of `whole`, up to rounding.
bool is_part(const Polygon& part, const Polygon& whole) {
  for (std::size_t k = 0; k + part.size() <= whole.size(); ++k) {
    const auto first = whole.coordinates().begin() + static_cast<std::ptrdiff_t>(k) * whole.dimension();
    if (test::gap({first, first + static_cast<std::ptrdiff_t>(part.coordinates().size())}, part.coordinates()) < 1e-13)
      return true;
  }
  return false;
}

TEST(RefineUniform, CommutesWithAffineMaps) {
  for (const UniformRule& r : all_rules) {
    for (const bool closed : {false, true}) {
      for (const EndRule ends : {EndRule::extend, EndRule::shrink}) {
        const Polygon polygon = test::random_polygon(2, 15, closed, 1);
        const Refinement twice{2, ends};
        EXPECT_LT(test::gap(refine_polygon(test::mapped(polygon), r, twice).coordinates(),
                            test::mapped(refine_polygon(polygon, r, twice)).coordinates()),
                  1e-13);
      }
    }
  }
}

TEST(RefineUniform, ClosedPolygonsRotate) {
  for (const UniformRule& r : all_rules) {
    for (const std::size_t size : {3u, 11u}) {  // fewer points than a stencil has: it goes around
      const Polygon polygon = test::random_polygon(2, size, true, 2);
      const Polygon refined = refine_polygon(polygon, r, {2});
      const auto scale = static_cast<std::size_t>(r.arity * r.arity);
      EXPECT_EQ(refined.size(), size * scale);
      EXPECT_TRUE(refined.closed());
      EXPECT_EQ(refine_polygon(test::rotated(polygon, 2), r, {2}).coordinates(),
                test::rotated(refined, 2 * scale % refined.size()).coordinates());
    }
  }
}

TEST(RefineUniform, InterpolatorySchemesKeepTheOldPoints) {
  for (const UniformRule& r : {four_point, shifted_four_point, ternary}) {
    for (const bool closed : {false, true}) {
      const Polygon polygon = test::random_polygon(3, 9, closed, 3);
      const Polygon refined = refine_polygon(polygon, r, {3});
      const auto scale = static_cast<std::size_t>(r.arity * r.arity * r.arity);
      ASSERT_EQ(refined.size(), polygon.edges() * scale + (closed ? 0 : 1));
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        EXPECT_THAT(refined[i * scale], ::testing::ElementsAreArray(polygon[i].begin(), polygon[i].end()));
      }
    }
  }
}

TEST(RefineUniform, OneLevelTwiceIsTwoLevels) {
  for (const UniformRule& r : all_rules) {
    for (const bool closed : {false, true}) {
      const Polygon polygon = test::random_polygon(2, 15, closed, 4);
      const Refinement once{1, EndRule::shrink}, twice{2, EndRule::shrink};
      EXPECT_EQ(refine_polygon(refine_polygon(polygon, r, once), r, once).coordinates(),
                refine_polygon(polygon, r, twice).coordinates());
      EXPECT_EQ(refine_polygon(polygon, r, {0}).coordinates(), polygon.coordinates());
    }
  }
}

TEST(RefineUniform, LinearDataStayLinear) {
  std::vector<double> points;
  for (int i = 0; i < 12; ++i) points.insert(points.end(), {2.0 * i, 5.0 - i});
  const Polygon line(2, points);
  for (const UniformRule& r : all_rules) {
    for (const EndRule ends : {EndRule::extend, EndRule::shrink}) {
      const Polygon refined = refine_polygon(line, r, {3, ends});
      const double step = 2.0 / (r.arity * r.arity * r.arity);
      for (std::size_t i = 0; i < refined.size(); ++i) {
        EXPECT_NEAR(refined[i][0] + 2 * refined[i][1], 10, 1e-12);
        if (i > 0) {
          EXPECT_NEAR(refined[i][0] - refined[i - 1][0], step, 1e-12);
        }
      }
      if (ends != EndRule::extend) continue;
      // From end to end, up to the half step by which dual schemes lie off the ends.
      EXPECT_NEAR(refined[0][0], 0, step);
      EXPECT_NEAR(refined[refined.size() - 1][0], 22, step);
    }
  }
}

TEST(RefineUniform, SymmetricSchemesCommuteWithReversal) {
  for (const UniformRule& r : {chaikin, cubic_spline, four_point, shifted_four_point, dual_four_point, ternary}) {
    for (const EndRule ends : {EndRule::automatic, EndRule::extend, EndRule::shrink}) {
      const Polygon polygon = test::random_polygon(2, 12, false, 5);
      EXPECT_LT(test::gap(refine_polygon(reversed(polygon), r, {3, ends}).coordinates(),
                          reversed(refine_polygon(polygon, r, {3, ends})).coordinates()),
                1e-13);
    }
  }
}

TEST(RefineUniform, WhatShrinkingLeavesDoesNotDependOnFurtherPoints) {
  const Polygon whole = test::random_polygon(2, 16, false, 6);
  const Polygon middle(2, {whole.coordinates().begin() + 4, whole.coordinates().end() - 4});
  for (const UniformRule& r : all_rules) {
    const Polygon part = refine_polygon(middle, r, {2, EndRule::shrink});
    EXPECT_TRUE(is_part(part, refine_polygon(whole, r, {2, EndRule::shrink})));
    EXPECT_TRUE(is_part(part, refine_polygon(middle, r, {2, EndRule::extend})));
  }
}

TEST(RefineUniform, ShrinkingKeepsTheCurveOverTheDeterminedPart) {
  // A 2n-point scheme keeps t from 2n-2 to M-2n+2, the cubic B-spline from 1 to M-1.
  std::vector<double> parameter;
  for (int i = 0; i <= 10; ++i) parameter.push_back(i);
  const Polygon line(1, parameter);
  const Polygon interpolated = refine_polygon(line, four_point, {8, EndRule::shrink});
  EXPECT_NEAR(interpolated[0][0], 2, 0.02);
  EXPECT_NEAR(interpolated[interpolated.size() - 1][0], 8, 0.02);
  const Polygon spline = refine_polygon(line, cubic_spline, {8});
  EXPECT_NEAR(spline[0][0], 1, 0.01);
  EXPECT_NEAR(spline[spline.size() - 1][0], 9, 0.01);
}

TEST(RefineUniform, CubicBSplinesConvergeToTheCurveAtSecondOrder) {
  const Polygon polygon = test::random_polygon(2, 8, true, 8);
  const auto curve = [&](double t, std::size_t k) {
    const auto i = static_cast<std::size_t>(t);
    const double u = t - static_cast<double>(i), v = 1 - u;
    const auto p = [&](std::size_t j) { return polygon[(i + j + polygon.size() - 1) % polygon.size()][k]; };
    return (v * v * v * p(0) + (3 * u * u * u - 6 * u * u + 4) * p(1) + (3 * v * v * v - 6 * v * v + 4) * p(2) +
            u * u * u * p(3)) /
           6;
  };
  double before = 0;
  for (int levels = 2; levels <= 8; ++levels) {
    const Polygon refined = refine_polygon(polygon, cubic_spline, {levels});
    double error = 0;
    for (std::size_t i = 0; i < refined.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        error = std::max(error, std::abs(refined[i][k] - curve(std::ldexp(static_cast<double>(i), -levels), k)));
      }
    }
    if (levels > 3) {
      EXPECT_NEAR(before / error, 4, 0.3);
    }
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(RefineUniform, FourPointReproducesCubicsInside) {
  std::vector<double> values;
  for (int i = 0; i <= 8; ++i) values.push_back(i * i * i - 5.0 * i * i);
  const Polygon refined = refine_polygon(Polygon(1, values), four_point, {4, EndRule::shrink});
  const auto f = [](double t) { return t * t * t - 5 * t * t; };
  ASSERT_EQ(refined.size(), 69u);
  for (std::size_t i = 0; i < refined.size(); ++i) {
    // The first index of the fourth level that is determined is 30.
    EXPECT_NEAR(refined[i][0], f(static_cast<double>(30 + i) / 16), 1e-10) << i;
  }
}

TEST(RefineUniform, BadInputIsRejected) {
  EXPECT_THROW(refine_polygon(test::random_polygon(2, 3, false, 1), four_point, {1}), InputError);
  EXPECT_NO_THROW(refine_polygon(test::random_polygon(2, 4, false, 1), four_point, {1}));
  EXPECT_THROW(refine_polygon(test::random_polygon(2, 4, false, 1), four_point, {5, EndRule::shrink}), InputError);
  EXPECT_THROW(refine_polygon(test::random_polygon(2, 2, true, 1), four_point, {1}), InputError);
  EXPECT_THROW(refine_polygon(test::random_polygon(2, 4, true, 1), four_point, {21}), LimitError);
  EXPECT_EQ(refine_polygon(test::random_polygon(1, 4, true, 1), four_point, {8}).size(), 1024u);
  EXPECT_THROW(refine_polygon(test::random_polygon(1, 4, true, 1), four_point, {8, EndRule::automatic, 1023}),
               LimitError);
  // Three points of a cubic spline shrink to three points at each level.
  EXPECT_EQ(refine_polygon(test::random_polygon(2, 3, false, 1), cubic_spline, {20}).size(), 3u);
  EXPECT_THROW(refine_polygon(test::random_polygon(2, 3, false, 1), cubic_spline, {1000}), LimitError);
  EXPECT_THROW(refine_polygon(Polygon(1, {0, 1.7e308, 1.7e308, -1.7e308}, true), rule(0, {4, 4}), {2}), DomainError);
  EXPECT_THROW(rule(0, {0}), DomainError);
}

}  // namespace
}  // namespace limes
