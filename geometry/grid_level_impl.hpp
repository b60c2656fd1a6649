// One level of the transform of a grid. Included by sources of this folder only.
#pragma once

#include "geometry/line_transform_impl.hpp"

namespace limes::pyramid_impl {

/// Between the fine points of an area and its coarse points and details, along its rows (first half: coarse points) or its columns. Rows and strips of
/// columns are shared among threads. The areas have the same size; `from` and `to` may be the same one for rows, not for columns.
class GridLevel {
 public:
  /// \param bank outlives this
  GridLevel(const PlacedBank& bank, Boundary boundary) : bank_(bank), boundary_(boundary) {}

  void rows_to_coarse(const Area& from, const Area& to) const;
  void rows_to_fine(const Area& from, const Area& to) const;
  void columns_to_coarse(const Area& from, const Area& to) const;
  void columns_to_fine(const Area& from, const Area& to) const;

 private:
  const PlacedBank& bank_;
  Boundary boundary_;
};

}  // namespace limes::pyramid_impl
