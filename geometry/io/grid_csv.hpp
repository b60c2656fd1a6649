#pragma once

#include "geometry/grid.hpp"
#include "geometry/io/csv.hpp"

namespace limes {

constexpr int max_grid_columns = 1 << 16;

/// The points of a polygon, one a row of the table: a grid of one row with a channel for each coordinate.
Grid curve_from(const NumberTable& table);
/// A heightfield, the table itself: one channel.
Grid heights_from(const NumberTable& table);

/// The same text back, in the shortest decimals that are read back bit by bit. \pre one row; one channel
std::string curve_to_csv(const Grid& curve);
std::string heights_to_csv(const Grid& heights);

}  // namespace limes
