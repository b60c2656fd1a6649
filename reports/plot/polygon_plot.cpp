#include "reports/plot/polygon_plot.hpp"

#include "algebra/error.hpp"
#include "geometry/curvature.hpp"

#include <algorithm>

namespace limes {
namespace {

constexpr Color grey{150, 150, 150};
constexpr std::size_t most_teeth = 300;

std::vector<PlotPoint> first_two(const std::vector<double>& coordinates, int dimension) {
  std::vector<PlotPoint> points;
  for (std::size_t k = 0; k < coordinates.size(); k += static_cast<std::size_t>(dimension)) {
    points.push_back({coordinates[k], coordinates[k + 1]});
  }
  return points;
}

}  // namespace

Plot polygon_plot(const Polygon& data, const Polygon& refined, const PolygonPlotOptions& options) {
  if (data.dimension() < 2 || refined.dimension() < 2)
    throw DomainError("a picture needs points with at least two coordinates");
  const std::vector<PlotPoint> vertices = first_two(data.coordinates(), data.dimension());
  const std::vector<PlotPoint> curve = first_two(refined.coordinates(), refined.dimension());
  Plot plot{.title = options.title, .x = {}, .y = {}, .items = {}, .equal_aspect = true};
  plot.items.push_back(PlotCurve{vertices, {grey, 0.75, Dash::dashed}, data.closed()});
  if (options.comb) {
    const std::vector<PlotPoint> tips = first_two(curvature_comb(refined, *options.comb), refined.dimension());
    plot.items.push_back(PlotComb{curve,
                                  tips,
                                  {palette(2), 0.75, Dash::solid},
                                  refined.closed(),
                                  std::max<std::size_t>(1, curve.size() / most_teeth)});
  }
  plot.items.push_back(PlotCurve{curve, {palette(1), 1.5, Dash::solid}, refined.closed()});
  plot.items.push_back(PlotMarkers{vertices, palette(0), 2});
  return plot;
}

}  // namespace limes
