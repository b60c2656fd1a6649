#include "apps/limes/pyramid_data.hpp"

#include "algebra/error.hpp"
#include "geometry/io/grid_csv.hpp"
#include "geometry/io/image.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes::app {

GridData read_grid(const std::filesystem::path& file, bool heights) {
  if (file.extension() == ".png") {
    Image image = read_png_file(file);
    return {std::move(image.grid), DataKind::image, image.bits};
  }
  if (heights) return {heights_from(read_csv_file(file, max_grid_columns)), DataKind::heights, 8};
  return {curve_from(read_csv_file(file)), DataKind::curve, 8};
}

std::string grid_text(const GridData& data, const std::filesystem::path& file) {
  if (file.extension() == ".csv") {
    if (data.kind == DataKind::curve) return curve_to_csv(data.grid);
    if (data.grid.channels == 1) return heights_to_csv(data.grid);
    throw InputError(
        fmt::format("{}: an image with {} channels is no grid of heights", file.string(), data.grid.channels));
  }
  if (file.extension() != ".png") throw InputError(fmt::format("{}: the ending must be .csv or .png", file.string()));
  if (data.kind == DataKind::curve) throw InputError(fmt::format("{}: points are no image", file.string()));
  return to_png(Image{data.grid, data.bits});
}

Boundary boundary_of(const GridOptions& options) {
  if (options.closed) return Boundary::periodic;
  return options.ends == "whole" ? Boundary::whole_sample : Boundary::half_sample;
}

Grid with_weights(Grid grid) {
  grid.values.insert(grid.values.end(), grid.rows * grid.columns, 1.0);
  ++grid.channels;
  return grid;
}

Grid divided_by_weights(const Grid& grid) {
  Grid result{grid.rows, grid.columns, grid.channels - 1, {}};
  const std::size_t size = grid.rows * grid.columns;
  const double* weights = &grid.values[size * result.channels];
  result.values.reserve(size * result.channels);
  for (std::size_t i = 0; i < size * result.channels; ++i) {
    const double x = grid.values[i] / weights[i % size];
    if (!std::isfinite(x)) throw InputError("a weight of the homogeneous data is 0: they have no affine image");
    result.values.push_back(x);
  }
  return result;
}

}  // namespace limes::app
