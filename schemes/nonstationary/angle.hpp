#pragma once

#include "algebra/polynomial/box.hpp"

#include <optional>
#include <string_view>
#include <utility>

namespace limes {

/// Reads an angle, or an interval of angles: an end is an expression a + b pi with rational a, b, such as "1/3", "pi/2",
/// "2*pi/7"; without pi everything is as read_interval reads it. What contains pi is enclosed: a single angle becomes a
/// closed interval narrower than 10^-35 (|a| + |b| pi), an end moves outward by less than that and becomes closed. So what holds for the result
/// holds for the angles that were asked for.
/// \throws InputError with column
Interval read_angles(std::string_view text);

/// The middle of what read_angles makes of a single angle, to work with in floating point; nothing for an interval of angles.
std::optional<Rational> single_angle(const Interval& angles);

/// {a, b} of a single angle a + b pi, exactly. \throws InputError with column
std::pair<Rational, Rational> read_angle(std::string_view text);

}  // namespace limes
