#pragma once

#include "algebra/stop.hpp"
#include "geometry/grid.hpp"
#include "schemes/unity/filter_bank.hpp"

#include <memory>
#include <vector>

namespace limes {

/// How data continue beyond their ends: x_{N+i} = x_i; x_{-1-i} = x_i and x_{N+i} = x_{N-1-i}; or x_{-i} = x_i and
/// x_{N-1+i} = x_{N-1-i}.
enum class Boundary { periodic, half_sample, whole_sample };

/// The coarse grid and the details of all levels, in place: after n levels the first rows / 2^n rows and columns / 2^n
/// columns of each channel are the coarse grid, and of level l the details fill the rest of the first rows / 2^{l-1} rows
/// and columns / 2^{l-1} columns. A direction with one row or column is left alone.
struct Pyramid {
  Grid grid;
  int levels = 0;
  Boundary boundary = Boundary::periodic;

  std::size_t coarse_rows() const { return grid.rows == 1 ? 1 : grid.rows >> levels; }
  std::size_t coarse_columns() const { return grid.columns == 1 ? 1 : grid.columns >> levels; }
};

/// ||P^{l-1} q|| and so on, for one level l: the l^2 norm of what a detail of modulus 1 adds to the fine data, away from
/// ends. In two directions it is a detail along the columns (of a row), the rows, or both.
struct DetailNorms {
  double along_row = 0, along_column = 0, both = 0;
};

/// The transform f -> (A f, B f) and its inverse, for one bank of filters.
///
/// The columns of P are placed symmetrically about the fine points 2i (odd masks) or 2i + 1/2 (even ones), those of B about
/// 2i + 1 or 2i + 1/2. With a periodic boundary the inverse is c, d -> P c + Q d. With symmetric boundaries the data are
/// continued for A and B; the inverse is P c + Q d except near the ends, where a small linear system is solved: its matrix is
/// that of A and B on the fine points that P and Q cannot give without knowing c and d beyond the ends.
class PyramidTransform {
 public:
  PyramidTransform(const FilterBank& bank, Boundary boundary);
  ~PyramidTransform();

  /// \pre all numbers are finite. \throws InputError: a direction that is not 1 is no positive multiple of 2^levels;
  /// Interrupted
  Pyramid decompose(Grid data, int levels, const Stop& stop = {}) const;
  /// Undoes the coarsest `levels` levels. \throws InputError: the filters are not invertible with this boundary (up to
  /// rounding); Interrupted
  Pyramid reconstruct(Pyramid pyramid, int levels, const Stop& stop = {}) const;
  /// The pyramid of `levels` levels over a coarse grid, with all details 0. \throws LimitError above 2^31 numbers
  Pyramid without_details(const Grid& coarse, int levels) const;
  /// \throws InputError: the filters are not invertible with this boundary (up to rounding) on a level of the pyramid
  void check_invertible(const Pyramid& pyramid) const;
  /// Of the levels 1 (the finest) to pyramid.levels.
  std::vector<DetailNorms> detail_norms(const Pyramid& pyramid) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

constexpr int max_pyramid_levels = 30;

Grid coarse_grid(const Pyramid& pyramid);
/// \throws InputError: another number of rows, columns or channels
void replace_coarse_grid(Pyramid& pyramid, const Grid& coarse);

struct DetailCount {
  std::size_t kept = 0, total = 0;
};
/// Sets the details of the finest `levels` levels to 0.
DetailCount drop_details(Pyramid& pyramid, int levels);
/// Sets the details of modulus below the threshold to 0.
DetailCount threshold_details(Pyramid& pyramid, double threshold);
/// Keeps the details with the greatest product of modulus and norm: a fraction of them, from 0 to 1, rounded up (and those
/// with the same product).
DetailCount keep_details(Pyramid& pyramid, double fraction, const std::vector<DetailNorms>& norms);

/// 10 log10(peak^2 / mean square of the difference), infinite for equal grids, and the greatest |difference|.
/// \throws InputError: grids of different shape
struct Difference {
  double psnr = 0, maximum = 0;
};
Difference difference(const Grid& a, const Grid& b, double peak);

}  // namespace limes
