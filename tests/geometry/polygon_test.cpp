#include "geometry/polygon.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

TEST(Polygon, HoldsPointsOfAnyDimension) {
  const Polygon polygon(3, {0, 1, 2, 3, 4, 5}, false, {0, 1});
  EXPECT_EQ(polygon.size(), 2u);
  EXPECT_EQ(polygon.edges(), 1u);
  EXPECT_EQ(polygon[1][2], 5);
  EXPECT_EQ(Polygon(1, {1, 2, 3}, true).edges(), 3u);
}

TEST(Polygon, RejectsWhatIsNoPolygon) {
  EXPECT_THROW(Polygon(2, {}), DomainError);
  EXPECT_THROW(Polygon(2, {1, 2, 3}), DomainError);
  EXPECT_THROW(Polygon(0, {1}), DomainError);
  EXPECT_THROW(Polygon(2, {1, NAN}), DomainError);
  EXPECT_THROW(Polygon(2, {1, INFINITY}), DomainError);
  EXPECT_THROW(Polygon(1, {1, 2}, false, {0}), DomainError);
  EXPECT_THROW(Polygon(1, {1, 2}, false, {0, 0}), DomainError);
  EXPECT_THROW(Polygon(1, {1, 2}, false, {1, 0}), DomainError);
  EXPECT_THROW(Polygon(1, {1, 2}, false, {0, NAN}), DomainError);
  EXPECT_THROW(Polygon(1, {1, 2}, true, {0, 1}), DomainError) << "a closed polygon needs its period";
  EXPECT_NO_THROW(Polygon(1, {1, 2}, true, {0, 1, 3}));
}

TEST(Polygon, DistanceDoesNotOverflow) {
  const double far[] = {3e200, 4e200}, origin[] = {0, 0};
  EXPECT_DOUBLE_EQ(distance(far, origin), 5e200);
}

}  // namespace
}  // namespace limes
