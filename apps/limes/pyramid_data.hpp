#pragma once

#include "apps/limes/options.hpp"
#include "geometry/io/pyramid_file.hpp"

#include <filesystem>
#include <string>

namespace limes::app {

/// Points, heights or pixels as a file holds them.
struct GridData {
  Grid grid;
  DataKind kind = DataKind::curve;
  int bits = 8;
};

/// A PNG image, a CSV file of heights (if asked for) or of points. \throws InputError
GridData read_grid(const std::filesystem::path& file, bool heights);
/// \throws InputError: the ending is neither .csv nor .png, or does not fit the data
std::string grid_text(const GridData& data, const std::filesystem::path& file);

Boundary boundary_of(const GridOptions& options);

/// With a channel of weights 1 after the others, and back: divided by the weights. \throws InputError: a weight is 0
Grid with_weights(Grid grid);
Grid divided_by_weights(const Grid& grid);

}  // namespace limes::app
