#include "apps/limes/multiresolution_json.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/pyramid_data.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "schemes/unity/filter_file.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {

int run_decompose(const DecomposeOptions& options) {
  const Session session(options);
  const FilterBank filters = read_filter_file(options.filters);
  GridData data = read_grid(options.data, options.heights);
  const PyramidTransform transform(filters, boundary_of(options));
  PyramidFile file{{}, data.kind, data.bits, options.homogeneous, filters};
  try {
    Grid grid = options.homogeneous ? with_weights(std::move(data.grid)) : std::move(data.grid);
    file.pyramid = transform.decompose(std::move(grid), options.levels, session.stop());
    // Whoever writes details wants them back: this fails where the ends cannot be inverted.
    transform.check_invertible(file.pyramid);
  } catch (const InputError& error) {
    throw error.located(options.data.string(), 0);
  }
  PyramidReport report{{{options.output.string(), "pyramid"}}, file.pyramid, {}, {}, {}};
  if (!options.coarse.empty()) {
    Grid coarse = coarse_grid(file.pyramid);
    if (options.homogeneous) coarse = divided_by_weights(coarse);
    write_file(options.coarse, grid_text({std::move(coarse), data.kind, data.bits}, options.coarse));
    report.outputs.emplace_back(options.coarse.string(), options.coarse.extension() == ".png" ? "png" : "csv");
  }
  write_file(options.output, to_bytes(file));
  if (options.json) {
    std::cout << pyramid_json(report);
  } else if (!options.quiet) {
    const Pyramid& p = file.pyramid;
    std::cout << fmt::format("{}: {} x {}, {} levels, coarse version {} x {}\n", options.output.string(), p.grid.rows,
                             p.grid.columns, p.levels, p.coarse_rows(), p.coarse_columns());
  }
  return all_as_expected;
}

}  // namespace limes::app
