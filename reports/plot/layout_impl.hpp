#pragma once

#include "reports/plot/plot.hpp"

#include <string>
#include <vector>

namespace limes::plot_impl {

/// One axis, ready to be drawn: its ends, its ticks, and the map from its values to [0, 1].
struct Scale {
  double lower = 0, upper = 1;
  bool logarithmic = false;
  std::vector<PlotTick> ticks;
  /// \pre value > 0 when logarithmic
  double place(double value) const;
};

/// What all writers agree on: ends and ticks of the axes and the size of the area inside the frame in points.
struct Layout {
  Scale x, y;
  double width = 0, height = 0;
};

/// \throws DomainError as plot.hpp says.
Layout layout(const Plot& plot);

/// The points whose polyline stays within `tolerance` (in points of paper, after mapping) of the whole one: Ramer,
/// Douglas and Peucker. Pictures of refined polygons become small and lose nothing that can be seen.
std::vector<PlotPoint> simplified(const std::vector<PlotPoint>& points, const Layout& layout, bool closed,
                                  double tolerance = 0.02);

/// Legends in the order of the items, of those that have points.
struct LegendEntry {
  std::string text;
  const PlotItem* item = nullptr;
};
std::vector<LegendEntry> legend(const Plot& plot);

/// The text without its dollars; \alpha etc. become Greek letters, or their names.
std::string plain_text(const std::string& text, bool greek);

/// Outside of $...$ the characters that TeX treats specially are escaped; a text with an odd number of dollars has no mathematics.
std::string tex_text(const std::string& text);

/// A number with at most `digits` decimals, without trailing zeros and without "-0".
std::string decimals(double value, int digits);

}  // namespace limes::plot_impl
