#include "geometry/pyramid.hpp"

#include "algebra/error.hpp"
#include "geometry/grid_level_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limes {

using pyramid_impl::area;
using pyramid_impl::Area;
using pyramid_impl::end_systems;
using pyramid_impl::GridLevel;
using pyramid_impl::PlacedBank;

namespace {

void check_length(std::size_t length, const char* what, int levels) {
  if (length == 0) throw InputError(fmt::format("no {}: there is nothing to decompose", what));
  if (length == 1 || length % (std::size_t{1} << levels) == 0) return;
  throw InputError(fmt::format("{} {}: {} level{} need a multiple of {}", length, what, levels, levels == 1 ? "" : "s",
                               std::size_t{1} << levels));
}

double norm(const std::vector<double>& x) {
  double sum = 0;
  for (const double entry : x) sum += entry * entry;
  return std::sqrt(sum);
}

/// P x, x and the result being finite sequences, where they begin being of no interest.
std::vector<double> refined(const std::vector<double>& x, const std::vector<double>& p) {
  std::vector<double> result(2 * x.size() + p.size());
  for (std::size_t j = 0; j < x.size(); ++j) {
    for (std::size_t m = 0; m < p.size(); ++m) result[2 * j + m] += p[m] * x[j];
  }
  return result;
}

}  // namespace

struct PyramidTransform::Impl {
  PlacedBank bank;
  Boundary boundary;
};

PyramidTransform::PyramidTransform(const FilterBank& bank, Boundary boundary)
    : impl_(std::make_unique<Impl>(PlacedBank(bank), boundary)) {}

PyramidTransform::~PyramidTransform() = default;

Pyramid PyramidTransform::decompose(Grid data, int levels, const Stop& stop) const {
  if (levels < 0 || levels > max_pyramid_levels)
    throw InputError(fmt::format("the number of levels must be 0 to {}", max_pyramid_levels));
  check_length(data.columns, data.rows == 1 ? "points" : "columns", levels);
  check_length(data.rows, "rows", levels);
  Pyramid pyramid{std::move(data), levels, impl_->boundary};
  const GridLevel level(impl_->bank, impl_->boundary);
  std::vector<double> scratch(levels > 0 ? pyramid.grid.rows * pyramid.grid.columns : 0);
  for (std::size_t channel = 0; channel < pyramid.grid.channels; ++channel) {
    for (int l = 1; l <= levels; ++l) {
      stop.check();
      const Area fine = area(pyramid.grid, channel, l), between{scratch.data(), fine.rows, fine.columns, fine.columns};
      if (fine.columns > 1) level.rows_to_coarse(fine, fine.rows > 1 ? between : fine);
      if (fine.rows > 1 && fine.columns == 1) std::copy_n(fine.data, fine.rows, between.data);
      if (fine.rows > 1) level.columns_to_coarse(between, fine);
    }
  }
  return pyramid;
}

Pyramid PyramidTransform::reconstruct(Pyramid pyramid, int levels, const Stop& stop) const {
  if (levels < 0 || levels > pyramid.levels)
    throw InputError(fmt::format("--levels {}: the pyramid has {}", levels, pyramid.levels));
  const GridLevel level(impl_->bank, impl_->boundary);
  std::vector<double> scratch(levels > 0 ? pyramid.grid.rows * pyramid.grid.columns : 0);
  for (std::size_t channel = 0; channel < pyramid.grid.channels; ++channel) {
    for (int l = pyramid.levels; l > pyramid.levels - levels; --l) {
      stop.check();
      const Area fine = area(pyramid.grid, channel, l), between{scratch.data(), fine.rows, fine.columns, fine.columns};
      if (fine.rows > 1) {
        level.columns_to_fine(fine, between);
        if (fine.columns > 1)
          level.rows_to_fine(between, fine);
        else
          std::copy_n(between.data, fine.rows, fine.data);
      } else if (fine.columns > 1) {
        std::copy_n(fine.data, fine.columns, between.data);
        level.rows_to_fine(between, fine);
      }
    }
  }
  pyramid.levels -= levels;
  return pyramid;
}

Pyramid PyramidTransform::without_details(const Grid& coarse, int levels) const {
  if (levels < 0 || levels > max_pyramid_levels)
    throw InputError(fmt::format("the number of levels must be 0 to {}", max_pyramid_levels));
  if (coarse.values.empty()) throw InputError("no data: there is nothing to reconstruct");
  Pyramid pyramid{{}, levels, impl_->boundary};
  pyramid.grid.rows = coarse.rows == 1 ? 1 : coarse.rows << levels;
  pyramid.grid.columns = coarse.columns == 1 ? 1 : coarse.columns << levels;
  pyramid.grid.channels = coarse.channels;
  const double size = double(pyramid.grid.rows) * double(pyramid.grid.columns) * double(pyramid.grid.channels);
  if (size > std::numeric_limits<std::int32_t>::max()) throw LimitError("the result would have more than 2^31 numbers");
  pyramid.grid.values.assign(static_cast<std::size_t>(size), 0);
  replace_coarse_grid(pyramid, coarse);
  return pyramid;
}

void PyramidTransform::check_invertible(const Pyramid& pyramid) const {
  for (int l = 0; l < pyramid.levels; ++l) {
    for (const std::size_t length : {pyramid.grid.rows, pyramid.grid.columns}) {
      if (length > 1) end_systems(impl_->bank, length >> l, impl_->boundary);
    }
  }
}

std::vector<DetailNorms> PyramidTransform::detail_norms(const Pyramid& pyramid) const {
  std::vector<DetailNorms> result;
  std::vector<double> coarse{1}, detail;
  for (int level = 1; level <= pyramid.levels; ++level) {
    // Beyond some levels both grow by the factor sqrt(2) per level, closely enough.
    constexpr int most = 12;
    if (level <= most) {
      detail = level == 1 ? impl_->bank.q.taps : refined(detail, impl_->bank.p.taps);
      coarse = refined(coarse, impl_->bank.p.taps);
    }
    const double growth = std::pow(2.0, 0.5 * std::max(0, level - most));
    const double p = growth * norm(coarse), q = growth * norm(detail);
    const bool rows = pyramid.grid.rows > 1, columns = pyramid.grid.columns > 1;
    result.push_back({rows ? q * p : q, columns ? p * q : q, q * q});
  }
  return result;
}

}  // namespace limes
