#include "geometry/pyramid.hpp"

#include "algebra/error.hpp"
#include "geometry/combine_impl.hpp"
#include "geometry/line_transform_impl.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limes {

using pyramid_impl::area;
using pyramid_impl::Area;
using pyramid_impl::continued;
using pyramid_impl::end_systems;
using pyramid_impl::EndSystem;
using pyramid_impl::PlacedBank;
using pyramid_impl::Polyphase;
using pyramid_impl::Tap;

namespace {

/// Outputs per piece of a row, and columns per strip: what the inner loops touch stays in the first-level cache.
constexpr std::size_t block = 512;
/// Rows per task.
constexpr std::size_t rows_per_task = 16;

/// One row through two padded sequences and back.
class RowBuffer {
 public:
  RowBuffer(const Polyphase& phases, std::size_t half) : phases_(phases), half_(half) {
    const std::size_t length = half + static_cast<std::size_t>(phases.before + phases.after);
    for (auto& padded : padded_) padded.resize(length);
    for (std::size_t output : {0u, 1u}) {
      for (const Tap& tap : phases.outputs[output]) weights_[output].push_back(tap.weight);
      sources_[output].resize(weights_[output].size());
    }
  }
  /// Entry i of a source, i from -before to half + after - 1.
  double& at(int source, long i) { return padded_[std::size_t(source)][static_cast<std::size_t>(i + phases_.before)]; }
  double* source(int index) { return padded_[std::size_t(index)].data() + phases_.before; }

  void run(double* output0, double* output1) {
    for (std::size_t first = 0; first < half_; first += block) {
      const std::size_t n = std::min(block, half_ - first);
      for (std::size_t output : {0u, 1u}) {
        const auto& taps = phases_.outputs[output];
        for (std::size_t t = 0; t < taps.size(); ++t)
          sources_[output][t] = source(taps[t].source) + static_cast<long>(first) + taps[t].offset;
        combine((output == 0 ? output0 : output1) + first, sources_[output].data(), weights_[output].data(),
                taps.size(), n);
      }
    }
  }

 private:
  const Polyphase& phases_;
  std::size_t half_;
  std::array<std::vector<double>, 2> padded_;
  std::array<std::vector<double>, 2> weights_;
  std::array<std::vector<const double*>, 2> sources_;
};

class Level {
 public:
  Level(const PlacedBank& bank, Boundary boundary) : bank_(bank), boundary_(boundary) {}

  void rows_to_coarse(const Area& from, const Area& to) const {
    const Polyphase& phases = bank_.analysis;
    const std::size_t half = from.columns / 2;
    const long n = static_cast<long>(half);
    for_row_tasks(from.rows, [&](std::size_t first, std::size_t last) {
      RowBuffer buffer(phases, half);
      for (std::size_t i = first; i < last; ++i) {
        const double* row = from.row(i);
        double *even = buffer.source(0), *odd = buffer.source(1);
        for (std::size_t k = 0; k < half; ++k) even[k] = row[2 * k], odd[k] = row[2 * k + 1];
        const auto fill = [&](long k) {
          even[k] = row[continued(2 * k, from.columns, boundary_)];
          odd[k] = row[continued(2 * k + 1, from.columns, boundary_)];
        };
        for (long k = -phases.before; k < 0; ++k) fill(k);
        for (long k = n; k < n + phases.after; ++k) fill(k);
        buffer.run(to.row(i), to.row(i) + half);
      }
    });
  }

  void rows_to_fine(const Area& from, const Area& to) const {
    const Polyphase& phases = bank_.synthesis;
    const std::size_t half = from.columns / 2;
    const std::vector<EndSystem> ends = end_systems(bank_, from.columns, boundary_);
    for_row_tasks(from.rows, [&](std::size_t first, std::size_t last) {
      RowBuffer buffer(phases, half);
      std::vector<double> fine[2] = {std::vector<double>(half), std::vector<double>(half)};
      for (std::size_t i = first; i < last; ++i) {
        const double* row = from.row(i);
        for (const int source : {0, 1}) {
          const double* part = row + (source == 0 ? 0 : half);
          const long n = static_cast<long>(half);
          std::copy_n(part, half, buffer.source(source));
          const auto fill = [&](long k) {
            buffer.at(source, k) = boundary_ == Boundary::periodic ? part[continued(k, half, boundary_)] : 0;
          };
          for (long k = -phases.before; k < 0; ++k) fill(k);
          for (long k = n; k < n + phases.after; ++k) fill(k);
        }
        buffer.run(fine[0].data(), fine[1].data());
        double* out = to.row(i);
        for (std::size_t k = 0; k < half; ++k) out[2 * k] = fine[0][k], out[2 * k + 1] = fine[1][k];
        for (const EndSystem& end : ends) finish_row(end, row, out);
      }
    });
  }

  void columns_to_coarse(const Area& from, const Area& to) const {
    const std::size_t half = from.rows / 2;
    std::vector<Lines> lines(from.rows);
    for (std::size_t i = 0; i < from.rows; ++i) {
      const long at = static_cast<long>(i % half);
      for (const Tap& tap : bank_.analysis.outputs[i / half])
        lines[i].add(tap.weight, from.row(continued(2 * (at + tap.offset) + tap.source, from.rows, boundary_)));
    }
    // Coarse row and details beside each other in time: they share their sources.
    for_strips(from.columns, [&](std::size_t first, std::size_t n) {
      for (std::size_t i = 0; i < half; ++i) {
        lines[i].write(to.row(i), first, n);
        lines[half + i].write(to.row(half + i), first, n);
      }
    });
  }

  void columns_to_fine(const Area& from, const Area& to) const {
    const std::size_t half = from.rows / 2;
    const long n = static_cast<long>(half);
    std::vector<std::pair<std::size_t, Lines>> lines(from.rows);
    for (std::size_t i = 0; i < from.rows; ++i) {
      lines[i].first = i;
      for (const Tap& tap : bank_.synthesis.outputs[i % 2]) {
        const long at = static_cast<long>(i / 2) + tap.offset;
        if (boundary_ != Boundary::periodic && (at < 0 || at >= n)) continue;
        lines[i].second.add(tap.weight,
                            from.row(continued(at, half, Boundary::periodic) + (tap.source == 0 ? 0 : half)));
      }
    }
    // Ends last: they need the others.
    for (const EndSystem& end : end_systems(bank_, from.rows, boundary_)) {
      const std::size_t width = end.transformed.size() + end.known.size();
      for (std::size_t u = 0; u < end.unknown.size(); ++u) {
        Lines line;
        for (std::size_t k = 0; k < width; ++k) {
          const bool fine = k >= end.transformed.size();
          line.add(end.weights[u * width + k],
                   fine ? to.row(end.known[k - end.transformed.size()]) : from.row(end.transformed[k]));
        }
        lines.emplace_back(end.unknown[u], std::move(line));
      }
    }
    for_strips(from.columns, [&](std::size_t first, std::size_t count) {
      for (const auto& [row, line] : lines) line.write(to.row(row), first, count);
    });
  }

 private:
  /// A row as a combination of rows.
  struct Lines {
    std::vector<double> weights;
    std::vector<const double*> sources;
    void add(double weight, const double* source) {
      weights.push_back(weight);
      sources.push_back(source);
    }
    void write(double* out, std::size_t first, std::size_t n) const {
      constexpr std::size_t most = 64;
      const double* moved[most];
      if (sources.size() <= most) {
        for (std::size_t t = 0; t < sources.size(); ++t) moved[t] = sources[t] + first;
        return combine(out + first, moved, weights.data(), sources.size(), n);
      }
      std::vector<const double*> many(sources);
      for (const double*& source : many) source += first;
      combine(out + first, many.data(), weights.data(), many.size(), n);
    }
  };

  static void finish_row(const EndSystem& end, const double* transformed, double* fine) {
    const double* weight = end.weights.data();
    for (const std::size_t u : end.unknown) {
      double sum = 0;
      for (const std::size_t k : end.transformed) sum += *weight++ * transformed[k];
      for (const std::size_t k : end.known) sum += *weight++ * fine[k];
      fine[u] = sum;
    }
  }

  template <class Task>
  static void for_row_tasks(std::size_t rows, const Task& task) {
    tbb::parallel_for(std::size_t{0}, (rows + rows_per_task - 1) / rows_per_task,
                      [&](std::size_t k) { task(k * rows_per_task, std::min(rows, (k + 1) * rows_per_task)); });
  }
  template <class Task>
  static void for_strips(std::size_t columns, const Task& task) {
    tbb::parallel_for(std::size_t{0}, (columns + block - 1) / block,
                      [&](std::size_t k) { task(k * block, std::min(block, columns - k * block)); });
  }

  const PlacedBank& bank_;
  Boundary boundary_;
};

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
  const Level level(impl_->bank, impl_->boundary);
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
  const Level level(impl_->bank, impl_->boundary);
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
