#pragma once

#include "geometry/refine_polygon.hpp"

#include <cstdint>

namespace limes::geometry_impl {

/// The indices first, .., last.
struct Range {
  std::int64_t first = 0;
  std::int64_t last = -1;
  std::int64_t size() const { return last - first + 1; }
};

/// Consecutive points of a bi-infinite sequence.
struct Strip {
  std::int64_t first = 0;
  std::size_t dimension = 1;
  std::vector<double> coordinates;

  std::int64_t last() const { return first + static_cast<std::int64_t>(coordinates.size() / dimension) - 1; }
  const double* operator[](std::int64_t i) const {
    return coordinates.data() + static_cast<std::size_t>(i - first) * dimension;
  }
  double* operator[](std::int64_t i) { return coordinates.data() + static_cast<std::size_t>(i - first) * dimension; }
};

/// Which old points a new one depends on: those j with lowest <= i - arity j <= highest. The new point i belongs at the
/// place (i - centre) / arity of the old polygon; centre is an integer or half of one.
struct Support {
  int arity = 2;
  int lowest = 0;
  int highest = 0;
  int centre_twice = 0;
  /// The greatest number of points in a stencil.
  int points = 1;
  bool interpolatory = false;
  /// Of EndRule::exact: the point beyond an end is the sum of these weights times the points from that end on. Empty: 2, -1.
  std::vector<double> continuation;
};

/// Fills `to`, whose range is set, from the points of `from`; `level` >= 1 is the level that is made.
using Step = std::function<void(const Strip& from, Strip& to, int level)>;

/// Refines by steps, with what refine_polygon says about ends, limits and errors. Of a closed polygon the result is 0,
/// .., size arity^levels - 1.
Strip refined_strip(const Polygon& polygon, const Support& support, const Refinement& refinement, const Stop& stop,
                    const Step& step);

/// One step of a uniform scheme.
void refine_level(const UniformRule& rule, const Strip& from, Strip& to);

}  // namespace limes::geometry_impl
