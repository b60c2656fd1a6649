#pragma once

#include "geometry/pyramid.hpp"

#include <array>
#include <vector>

namespace limes::pyramid_impl {

/// A rectangle of numbers in a larger grid.
struct Area {
  double* data = nullptr;
  std::size_t rows = 0, columns = 0, stride = 0;
  double* row(std::size_t i) const { return data + i * stride; }
};

/// The rectangle of a channel in which level `level` (from 1) works.
inline Area area(Grid& grid, std::size_t channel, int level) {
  return {grid.values.data() + channel * grid.rows * grid.columns, grid.rows == 1 ? 1 : grid.rows >> (level - 1),
          grid.columns == 1 ? 1 : grid.columns >> (level - 1), grid.columns};
}

/// weight times entry (output index + offset) of source 0 or 1.
struct Tap {
  int source = 0, offset = 0;
  double weight = 0;
};

/// Two sequences to two sequences, each output a sum over taps: from even and odd points to coarse points and details, and
/// back.
struct Polyphase {
  std::array<std::vector<Tap>, 2> outputs;
  /// How far offsets reach below 0 and above 0.
  int before = 0, after = 0;
};

/// The filters without zeros at their ends, placed on the integers.
struct PlacedFilter {
  int start = 0;
  std::vector<double> taps;
};

struct PlacedBank {
  explicit PlacedBank(const FilterBank& bank);
  PlacedFilter a, b, p, q;
  Polyphase analysis, synthesis;
};

/// The index in 0 .. size - 1 of the datum that stands at x.
std::size_t continued(long x, std::size_t size, Boundary boundary);

/// Fine points near an end that P and Q do not give: x_fine = sum weights * (coarse points and details) + sum weights *
/// (other fine points).
struct EndSystem {
  std::vector<std::size_t> unknown;
  /// Of the transformed line: coarse points at 0 .. n - 1, details at n .. 2n - 1.
  std::vector<std::size_t> transformed;
  std::vector<std::size_t> known;
  /// unknown x (transformed, then known), row after row.
  std::vector<double> weights;
};

/// None for a periodic boundary. \throws InputError when they are not determined
std::vector<EndSystem> end_systems(const PlacedBank& bank, std::size_t size, Boundary boundary);

}  // namespace limes::pyramid_impl
