#pragma once

#include "analysis/surface/characteristic_map.hpp"
#include "reports/plot/plot.hpp"

namespace limes {

struct CharacteristicMapPlotOptions {
  std::string title;
  /// Self-similar rings around the centre, and lines of the grid across each.
  int rings = 3, lines = 4;
  Color color = {0x00, 0x72, 0xb2};
};

/// The images of grid lines under the characteristic map of an extraordinary point of valence n, sector by sector; the spokes are drawn
/// darker. The map is injective when no two lines of one direction meet.
/// \pre map is for cos(pi/n)
Plot characteristic_map_plot(const ApproxCharacteristicMap& map, int valence, const CharacteristicMapPlotOptions& options = {});

}  // namespace limes
