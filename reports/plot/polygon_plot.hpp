#pragma once

#include "geometry/polygon.hpp"
#include "reports/plot/plot.hpp"

namespace limes {

struct PolygonPlotOptions {
  std::string title;
  /// The factor from curvature to the length of the comb's teeth; no comb without it.
  std::optional<double> comb;
};

/// The picture of a refined polygon: the data as a grey polygon with markers, the refined polygon as a curve, its
/// curvature comb. Points of more than two dimensions are shown by their first two coordinates (the comb is made
/// before).
/// \throws DomainError for points of dimension 1.
Plot polygon_plot(const Polygon& data, const Polygon& refined, const PolygonPlotOptions& options);

}  // namespace limes
