#include "reports/plot/map_plot.hpp"

namespace limes {
namespace {

/// Okabe and Ito's bluish green, vermilion and yellow.
Color colour_of(Outcome verdict) {
  switch (verdict) {
    case Outcome::certified: return {0, 158, 115};
    case Outcome::refuted: return {213, 94, 0};
    case Outcome::undecided: break;
  }
  return {240, 228, 66};
}

std::string legend_of(Outcome verdict) { return verdict == Outcome::undecided ? "unknown" : to_string(verdict); }

}  // namespace

Plot map_plot(const std::vector<MapUnion>& unions, const Box& region, const VariableNames& parameters, const std::string& title) {
  std::vector<std::size_t> axes;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (!region[k].is_point()) axes.push_back(k);
  }
  const bool is_bar = axes.size() == 1;
  const auto ends = [&](const Box& box, std::size_t axis) {
    return std::pair{approx_double(box[axes[axis]].lower), approx_double(box[axes[axis]].upper)};
  };
  Plot plot{.title = title, .x = {}, .y = {}, .items = {}};
  std::tie(plot.x.lower, plot.x.upper) = ends(region, 0);
  plot.x.label = parameters[axes[0]];
  if (is_bar) {
    plot.y.lower = 0;
    plot.y.upper = 1;
    plot.height = 60;
    plot.y.ticks.emplace();
  } else {
    std::tie(plot.y.lower, plot.y.upper) = ends(region, 1);
    plot.y.label = parameters[axes[1]];
  }
  for (const Outcome verdict : {Outcome::certified, Outcome::refuted, Outcome::undecided}) {
    PlotRegion part{.outlines = {}, .fill = colour_of(verdict), .legend = legend_of(verdict)};
    for (const MapUnion& one : unions) {
      if (one.verdict != verdict) continue;
      const auto [left, right] = ends(one.region, 0);
      const auto [low, high] = is_bar ? std::pair{0.0, 1.0} : ends(one.region, 1);
      if (left < right && low < high) part.outlines.push_back({{left, low}, {right, low}, {right, high}, {left, high}});
    }
    if (!part.outlines.empty()) plot.items.emplace_back(std::move(part));
  }
  return plot;
}

}  // namespace limes
