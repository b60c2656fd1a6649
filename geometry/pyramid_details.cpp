// What is done with a pyramid's coarse grid and details.
#include "geometry/pyramid.hpp"

#include "algebra/error.hpp"
#include "geometry/line_transform_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace limes {

using pyramid_impl::area;
using pyramid_impl::Area;

namespace {

/// Calls action(detail, level, whether it is one along the row, along the column), from the coarsest level on.
template <class Action>
void for_details(Pyramid& pyramid, int coarsest, int finest, const Action& action) {
  Grid& grid = pyramid.grid;
  for (std::size_t channel = 0; channel < grid.channels; ++channel) {
    for (int level = coarsest; level >= finest; --level) {
      const Area whole = area(grid, channel, level), inner = area(grid, channel, level + 1);
      for (std::size_t i = 0; i < whole.rows; ++i) {
        for (std::size_t k = i < inner.rows ? inner.columns : 0; k < whole.columns; ++k)
          action(whole.row(i)[k], level, k >= inner.columns, i >= inner.rows);
      }
    }
  }
}

}  // namespace

Grid coarse_grid(const Pyramid& pyramid) {
  Grid coarse{pyramid.coarse_rows(), pyramid.coarse_columns(), pyramid.grid.channels, {}};
  for (std::size_t channel = 0; channel < coarse.channels; ++channel) {
    for (std::size_t i = 0; i < coarse.rows; ++i) {
      for (std::size_t k = 0; k < coarse.columns; ++k) coarse.values.push_back(pyramid.grid.at(channel, i, k));
    }
  }
  return coarse;
}

void replace_coarse_grid(Pyramid& pyramid, const Grid& coarse) {
  if (coarse.rows != pyramid.coarse_rows() || coarse.columns != pyramid.coarse_columns() ||
      coarse.channels != pyramid.grid.channels) {
    throw InputError(fmt::format("coarse data of {} x {} with {} channels, but the pyramid has {} x {} with {}",
                                 coarse.rows, coarse.columns, coarse.channels, pyramid.coarse_rows(),
                                 pyramid.coarse_columns(), pyramid.grid.channels));
  }
  for (std::size_t channel = 0; channel < coarse.channels; ++channel) {
    for (std::size_t i = 0; i < coarse.rows; ++i) {
      for (std::size_t k = 0; k < coarse.columns; ++k) pyramid.grid.at(channel, i, k) = coarse.at(channel, i, k);
    }
  }
}

DetailCount drop_details(Pyramid& pyramid, int levels) {
  DetailCount count;
  const int dropped = std::min(levels, pyramid.levels);
  for_details(pyramid, pyramid.levels, dropped + 1, [&](double, int, bool, bool) { ++count.kept, ++count.total; });
  for_details(pyramid, dropped, 1, [&](double& x, int, bool, bool) { x = 0, ++count.total; });
  return count;
}

namespace {

/// Keeps the details whose modulus, multiplied by a weight, is at least the threshold.
template <class Weight>
DetailCount keep_above(Pyramid& pyramid, double threshold, const Weight& weight) {
  DetailCount count;
  for_details(pyramid, pyramid.levels, 1, [&](double& x, int level, bool along_row, bool along_column) {
    ++count.total;
    if (std::abs(x) * weight(level, along_row, along_column) < threshold)
      x = 0;
    else
      ++count.kept;
  });
  return count;
}

}  // namespace

DetailCount threshold_details(Pyramid& pyramid, double threshold) {
  return keep_above(pyramid, threshold, [](int, bool, bool) { return 1.0; });
}

DetailCount keep_details(Pyramid& pyramid, double fraction, const std::vector<DetailNorms>& norms) {
  const auto weight = [&](int level, bool along_row, bool along_column) {
    const DetailNorms& n = norms[std::size_t(level - 1)];
    return along_row && along_column ? n.both : along_row ? n.along_row : n.along_column;
  };
  std::vector<double> products;
  for_details(pyramid, pyramid.levels, 1, [&](double x, int level, bool along_row, bool along_column) {
    products.push_back(std::abs(x) * weight(level, along_row, along_column));
  });
  const auto kept = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(products.size())));
  if (kept >= products.size()) return {products.size(), products.size()};
  if (kept == 0) return drop_details(pyramid, pyramid.levels);
  const auto place = products.begin() + static_cast<long>(kept) - 1;
  std::nth_element(products.begin(), place, products.end(), std::greater<>());
  return keep_above(pyramid, *place, weight);
}

Difference difference(const Grid& a, const Grid& b, double peak) {
  if (a.rows != b.rows || a.columns != b.columns || a.channels != b.channels) {
    throw InputError(fmt::format("data of {} x {} with {} channels cannot be compared with {} x {} with {}", a.rows,
                                 a.columns, a.channels, b.rows, b.columns, b.channels));
  }
  Difference result;
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double d = a.values[i] - b.values[i];
    sum += d * d;
    result.maximum = std::max(result.maximum, std::abs(d));
  }
  const double mean = sum / static_cast<double>(a.values.size());
  result.psnr = mean == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(peak * peak / mean);
  return result;
}

}  // namespace limes
