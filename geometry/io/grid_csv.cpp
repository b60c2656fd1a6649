#include "geometry/io/grid_csv.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

/// -0 is written as 0.
void append(fmt::memory_buffer& text, double x, bool last) {
  fmt::format_to(std::back_inserter(text), "{}{}", x + 0.0, last ? '\n' : ',');
}

}  // namespace

Grid curve_from(const NumberTable& table) {
  Grid curve{1, table.rows(), static_cast<std::size_t>(table.columns), std::vector<double>(table.values.size())};
  for (std::size_t i = 0; i < table.values.size(); ++i)
    curve.at(i % curve.channels, 0, i / curve.channels) = table.values[i];
  return curve;
}

Grid heights_from(const NumberTable& table) {
  return {table.rows(), static_cast<std::size_t>(table.columns), 1, table.values};
}

std::string curve_to_csv(const Grid& curve) {
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < curve.columns; ++i) {
    for (std::size_t channel = 0; channel < curve.channels; ++channel)
      append(text, curve.at(channel, 0, i), channel + 1 == curve.channels);
  }
  return fmt::to_string(text);
}

std::string heights_to_csv(const Grid& heights) {
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < heights.rows; ++i) {
    for (std::size_t k = 0; k < heights.columns; ++k) append(text, heights.at(0, i, k), k + 1 == heights.columns);
  }
  return fmt::to_string(text);
}

}  // namespace limes
