#pragma once

#include <cstddef>
#include <vector>

namespace limes {

/// Numbers on a rectangular grid with some channels: a polygon in R^d has one row and d channels, a heightfield one channel,
/// a colour image three. Stored channel after channel, each row after row.
struct Grid {
  std::size_t rows = 0, columns = 0, channels = 1;
  std::vector<double> values;

  double& at(std::size_t channel, std::size_t row, std::size_t column) {
    return values[(channel * rows + row) * columns + column];
  }
  double at(std::size_t channel, std::size_t row, std::size_t column) const {
    return values[(channel * rows + row) * columns + column];
  }
};

}  // namespace limes
