#include "geometry/grid_level_impl.hpp"

#include "geometry/combine_impl.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace limes::pyramid_impl {
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

void finish_row(const EndSystem& end, const double* transformed, double* fine) {
  const double* weight = end.weights.data();
  for (const std::size_t u : end.unknown) {
    double sum = 0;
    for (const std::size_t k : end.transformed) sum += *weight++ * transformed[k];
    for (const std::size_t k : end.known) sum += *weight++ * fine[k];
    fine[u] = sum;
  }
}

template <class Task>
void for_row_tasks(std::size_t rows, const Task& task) {
  tbb::parallel_for(std::size_t{0}, (rows + rows_per_task - 1) / rows_per_task,
                    [&](std::size_t k) { task(k * rows_per_task, std::min(rows, (k + 1) * rows_per_task)); });
}
template <class Task>
void for_strips(std::size_t columns, const Task& task) {
  tbb::parallel_for(std::size_t{0}, (columns + block - 1) / block,
                    [&](std::size_t k) { task(k * block, std::min(block, columns - k * block)); });
}

}  // namespace

void GridLevel::rows_to_coarse(const Area& from, const Area& to) const {
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

void GridLevel::rows_to_fine(const Area& from, const Area& to) const {
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

void GridLevel::columns_to_coarse(const Area& from, const Area& to) const {
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

void GridLevel::columns_to_fine(const Area& from, const Area& to) const {
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

}  // namespace limes::pyramid_impl
