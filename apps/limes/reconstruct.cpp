#include "apps/limes/multiresolution_json.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/pyramid_data.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "geometry/io/image.hpp"
#include "schemes/unity/filter_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace limes::app {
namespace {

/// The pyramid in the file, or one without details over the coarse data there.
PyramidFile read(const ReconstructOptions& options, const FilterBank& filters) {
  if (!is_pyramid_file(options.data)) {
    GridData data = read_grid(options.data, options.heights);
    const Grid grid = options.homogeneous ? with_weights(std::move(data.grid)) : std::move(data.grid);
    return {PyramidTransform(filters, boundary_of(options)).without_details(grid, options.levels.value_or(1)),
            data.kind, data.bits, options.homogeneous, filters};
  }
  PyramidFile file = read_pyramid_file(options.data);
  const FilterBank& own = file.filters;
  if (own.p != filters.p || own.a != filters.a || own.b != filters.b || own.q != filters.q ||
      own.shift != filters.shift)
    throw InputError(fmt::format("the pyramid was made with other filters than those of {}", options.filters.string()),
                     {options.data.string(), 0, 0});
  return file;
}

void replace_coarse(PyramidFile& file, const ReconstructOptions& options) {
  if (options.coarse.empty()) return;
  GridData coarse = read_grid(options.coarse, file.kind == DataKind::heights);
  try {
    if (coarse.kind != file.kind) throw InputError("points, heights and images cannot stand for each other");
    replace_coarse_grid(file.pyramid, file.homogeneous ? with_weights(std::move(coarse.grid)) : coarse.grid);
  } catch (const InputError& error) {
    throw error.located(options.coarse.string(), 0);
  }
}

std::optional<DetailCount> remove_details(Pyramid& pyramid, const PyramidTransform& transform,
                                          const ReconstructOptions& options) {
  if (options.drop.has_value() + options.threshold.has_value() + options.keep.has_value() > 1)
    throw InputError("--drop, --threshold and --keep exclude each other");
  if (options.drop) return drop_details(pyramid, *options.drop);
  if (options.threshold) return threshold_details(pyramid, *options.threshold);
  if (options.keep) return keep_details(pyramid, *options.keep, transform.detail_norms(pyramid));
  return std::nullopt;
}

/// Of images the greatest sample, of other data their extent.
double peak_of(const GridData& data) {
  if (data.kind == DataKind::image) return std::pow(2.0, data.bits) - 1;
  const auto [low, high] = std::minmax_element(data.grid.values.begin(), data.grid.values.end());
  return *high - *low;
}

void compare(const GridData& result, const ReconstructOptions& options, PyramidReport& report) {
  if (options.compare.empty()) return;
  const GridData original = read_grid(options.compare, result.kind == DataKind::heights);
  Grid written = result.grid;
  if (options.output.extension() == ".png") {  // what the file holds
    const double most = peak_of(original);
    for (double& x : written.values) x = std::clamp(std::round(x), 0.0, most);
  }
  try {
    report.difference = difference(original.grid, written, peak_of(original));
    if (result.kind == DataKind::image && written.channels >= 3)
      report.luminosity_psnr = difference(luminosity(original.grid), luminosity(written), peak_of(original)).psnr;
  } catch (const InputError& error) {
    throw error.located(options.compare.string(), 0);
  }
}

}  // namespace

int run_reconstruct(const ReconstructOptions& options) {
  const Session session(options);
  const FilterBank filters = read_filter_file(options.filters);
  PyramidFile file = read(options, filters);
  replace_coarse(file, options);
  const PyramidTransform transform(filters, file.pyramid.boundary);
  const std::optional<DetailCount> details = remove_details(file.pyramid, transform, options);
  try {
    const int levels = options.levels.value_or(file.pyramid.levels);
    file.pyramid = transform.reconstruct(std::move(file.pyramid), levels, session.stop());
  } catch (const InputError& error) {
    throw error.located(options.data.string(), 0);
  }
  Grid grid = file.pyramid.levels == 0 ? std::move(file.pyramid.grid) : coarse_grid(file.pyramid);
  if (file.homogeneous) grid = divided_by_weights(grid);
  const GridData result{std::move(grid), file.kind, file.bits};
  Pyramid shape{
      {result.grid.rows, result.grid.columns, result.grid.channels, {}}, file.pyramid.levels, file.pyramid.boundary};
  PyramidReport report{
      {{options.output.string(), options.output.extension() == ".png" ? "png" : "csv"}}, shape, details, {}, {}};
  compare(result, options, report);
  write_file(options.output, grid_text(result, options.output));
  if (options.json) {
    std::cout << pyramid_json(report);
  } else if (!options.quiet) {
    std::cout << fmt::format("{}: {} x {}\n", options.output.string(), result.grid.rows, result.grid.columns);
    if (details) std::cout << fmt::format("details kept: {} of {}\n", details->kept, details->total);
    if (report.difference)
      std::cout << fmt::format("PSNR {:.4f} dB, greatest difference {:.6g}\n", report.difference->psnr,
                               report.difference->maximum);
    if (report.luminosity_psnr) std::cout << fmt::format("PSNR of the luminosity {:.4f} dB\n", *report.luminosity_psnr);
  }
  return all_as_expected;
}

}  // namespace limes::app
