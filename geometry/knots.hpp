#pragma once

#include "geometry/polygon.hpp"

#include <optional>
#include <string>

namespace limes {

/// How far apart the knots of neighbouring points are: t_{i+1} - t_i = |p_{i+1} - p_i|^alpha with alpha = 0, 1, 1/2.
enum class KnotSpacing { uniform, chordal, centripetal };

std::string to_string(KnotSpacing spacing);
/// "uniform", "chordal", "centripetal"; nothing for another text.
std::optional<KnotSpacing> read_knot_spacing(const std::string& text);

/// Knots t_0 = 0 < t_1 < .. for the points; a closed polygon gets one more, so that the last minus the first is the
/// period.
/// \throws InputError for chordal and centripetal spacing of neighbours that coincide, or that are so close or so far
/// from each other that the knots do not increase in double precision.
std::vector<double> spaced_knots(const Polygon& polygon, KnotSpacing spacing);

/// The first i such that p_i equals the point after it (cyclically when closed).
std::optional<std::size_t> first_repeated_point(const Polygon& polygon);

}  // namespace limes
