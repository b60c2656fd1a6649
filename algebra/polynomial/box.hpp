#pragma once

#include "algebra/number/rational.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limes {

/// A non-empty bounded interval of rationals with open or closed ends. lower < upper, or lower == upper with both ends closed.
struct Interval {
  Rational lower;
  Rational upper;
  bool lower_open = false;
  bool upper_open = false;

  static Interval point(const Rational& x) { return {x, x, false, false}; }
  bool is_point() const { return lower == upper; }
  bool contains(const Rational& x) const;
  /// Set inclusion, ends included: (0,1) is in [0,1], not the other way round.
  bool contains(const Interval& other) const;
  Rational midpoint() const { return (lower + upper) / 2; }
  Rational width() const { return upper - lower; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// A product of intervals, one per parameter; no interval at all is the box of no parameters (one point).
using Box = std::vector<Interval>;

/// Reads "[0, 1/4]", "(0, 21/500]", "(1/15, 1/9)", "{1/16}", or a bare rational (a point). Ends are expressions of digits only
/// (read_rational). \throws InputError with column: wrong bracket, lower > upper, empty interval such as (1,1].
Interval read_interval(std::string_view text);
/// "[0, 1/4]", "(0, 21/500]"; a point prints as the bare rational.
std::string to_string(const Interval& interval);

bool contains(const Box& box, std::span<const Rational> point);
bool contains(const Box& box, const Box& other);
std::vector<Rational> midpoint(const Box& box);
bool is_point(const Box& box);
/// The two halves along an axis; both contain the cut: [a, m] and [m, b], outer ends as they were. \pre the axis is no point
std::pair<Box, Box> bisect(const Box& box, int axis);
/// The axis of greatest width relative to `reference` (same shape; a point axis never wins); -1 if all are points.
int widest_axis(const Box& box, const Box& reference);

}  // namespace limes
