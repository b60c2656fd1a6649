#include "geometry/knots.hpp"

#include "algebra/error.hpp"
#include "tests/geometry/data.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

const Polygon rectangle(2, {0, 0, 4, 0, 4, 9, 0, 9});

TEST(Knots, SpacingByDistance) {
  EXPECT_EQ(spaced_knots(rectangle, KnotSpacing::uniform), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(spaced_knots(rectangle, KnotSpacing::chordal), (std::vector<double>{0, 4, 13, 17}));
  EXPECT_EQ(spaced_knots(rectangle, KnotSpacing::centripetal), (std::vector<double>{0, 2, 5, 7}));
}

TEST(Knots, ClosedPolygonsGetThePeriod) {
  const Polygon closed(2, rectangle.coordinates(), true);
  EXPECT_EQ(spaced_knots(closed, KnotSpacing::uniform).back(), 4);
  EXPECT_EQ(spaced_knots(closed, KnotSpacing::chordal), (std::vector<double>{0, 4, 13, 17, 26}));
}

TEST(Knots, ScalingTheDataScalesTheKnots) {
  const Polygon polygon = test::random_polygon(3, 20, true, 7);
  std::vector<double> larger = polygon.coordinates();
  for (double& x : larger) x *= 16;
  for (const auto& [spacing, factor] :
       {std::pair(KnotSpacing::chordal, 16.0), std::pair(KnotSpacing::centripetal, 4.0)}) {
    std::vector<double> expected = spaced_knots(polygon, spacing);
    for (double& t : expected) t *= factor;
    EXPECT_LT(test::gap(spaced_knots(Polygon(3, larger, true), spacing), expected), 1e-12);
  }
}

TEST(Knots, RepeatedPointsAreErrorsUnlessUniform) {
  const Polygon inside(2, {0, 0, 1, 1, 1, 1, 2, 0}), around(2, {0, 0, 1, 1, 0, 0}, true);
  for (const Polygon& polygon : {inside, around}) {
    EXPECT_NO_THROW(spaced_knots(polygon, KnotSpacing::uniform));
    EXPECT_THROW(spaced_knots(polygon, KnotSpacing::chordal), InputError);
    EXPECT_THROW(spaced_knots(polygon, KnotSpacing::centripetal), InputError);
  }
  EXPECT_EQ(first_repeated_point(inside), 1u);
  EXPECT_EQ(first_repeated_point(around), 2u);
  EXPECT_FALSE(first_repeated_point(Polygon(2, {0, 0, 1, 1, 0, 0})));
}

TEST(Knots, DistancesBeyondDoublePrecisionAreErrors) {
  EXPECT_THROW(spaced_knots(Polygon(2, {0, 0, 1e30, 0, 1e30, 1}), KnotSpacing::chordal), InputError);
  EXPECT_THROW(spaced_knots(Polygon(1, {-1.7e308, 1.7e308}), KnotSpacing::chordal), InputError);
}

TEST(Knots, NamesAreReadBack) {
  for (const KnotSpacing spacing : {KnotSpacing::uniform, KnotSpacing::chordal, KnotSpacing::centripetal}) {
    EXPECT_EQ(read_knot_spacing(to_string(spacing)), spacing);
  }
  EXPECT_FALSE(read_knot_spacing("Uniform"));
}

}  // namespace
}  // namespace limes
