#include "reports/plot/characteristic_map_plot.hpp"

#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limes {
namespace {

ApproxCharacteristicMap map_of(const char* name, int n) {
  const RingRule rule = load_scheme(name).surface->rings;
  return {rule, rule.invariant_rings(rule.curve.symbol.highest()), n, std::cos(std::numbers::pi / n)};
}

std::vector<PlotPoint> points(const Plot& plot) {
  std::vector<PlotPoint> result;
  for (const PlotItem& item : plot.items) {
    const auto& curve = std::get<PlotCurve>(item);
    result.insert(result.end(), curve.points.begin(), curve.points.end());
  }
  return result;
}

TEST(CharacteristicMapPlot, LooksTheSameAfterATurn) {
  for (const char* name : {"unified", "catmull-clark", "doo-sabin"}) {
    const int n = 5;
    const std::vector<PlotPoint> all = points(characteristic_map_plot(map_of(name, n), n));
    ASSERT_FALSE(all.empty());
    // The distances from the centre, sorted, come in groups of n.
    std::vector<double> distances;
    for (const PlotPoint& p : all) distances.push_back(std::hypot(p.x, p.y));
    std::sort(distances.begin(), distances.end());
    for (std::size_t k = 0; k + n <= distances.size(); k += n) EXPECT_NEAR(distances[k], distances[k + n - 1], 1e-9) << name;
    EXPECT_GT(distances.front(), 0);
  }
}

TEST(CharacteristicMapPlot, HasSpokesAndLinesForEverySectorAndRing) {
  const CharacteristicMapPlotOptions options{.title = "map", .rings = 2, .lines = 2};
  const Plot plot = characteristic_map_plot(map_of("unified", 6), 6, options);
  // A half sector has 2 lines + 1 lines of one direction, and lines + 1 of the other; the outermost of the former is a point.
  EXPECT_EQ(plot.items.size(), 6u * 2 * (1 + 2 * (3 + 3)));
  EXPECT_NE(to_svg(plot).find("map"), std::string::npos);
  EXPECT_EQ(to_svg(plot), to_svg(plot));
}

TEST(CharacteristicMapPlot, IsTheGridAtRegularVertices) {
  const std::vector<PlotPoint> all = points(characteristic_map_plot(map_of("catmull-clark", 4), 4, {.title = "", .rings = 1, .lines = 1}));
  double unit = 0;
  for (const PlotPoint& p : all) unit = std::max(unit, std::abs(p.x) / 2);
  for (const PlotPoint& p : all) {
    const double x = std::abs(p.x) / unit, y = std::abs(p.y) / unit;
    const auto on_line = [](double t) { return std::abs(t - std::round(t)) < 1e-9; };
    EXPECT_TRUE(on_line(x) || on_line(y)) << x << " " << y;
  }
}

}  // namespace
}  // namespace limes
