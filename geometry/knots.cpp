#include "geometry/knots.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace limes {

std::string to_string(KnotSpacing spacing) {
  switch (spacing) {
    case KnotSpacing::uniform:
      return "uniform";
    case KnotSpacing::chordal:
      return "chordal";
    case KnotSpacing::centripetal:
      return "centripetal";
  }
  throw InternalError("unknown spacing of knots");
}

std::optional<KnotSpacing> read_knot_spacing(const std::string& text) {
  for (const KnotSpacing spacing : {KnotSpacing::uniform, KnotSpacing::chordal, KnotSpacing::centripetal}) {
    if (text == to_string(spacing)) return spacing;
  }
  return std::nullopt;
}

std::optional<std::size_t> first_repeated_point(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.edges(); ++i) {
    if (std::ranges::equal(polygon[i], polygon[(i + 1) % polygon.size()])) return i;
  }
  return std::nullopt;
}

std::vector<double> spaced_knots(const Polygon& polygon, KnotSpacing spacing) {
  const auto number_after = [&](std::size_t i) { return (i + 1) % polygon.size() + 1; };
  if (const std::optional<std::size_t> i = first_repeated_point(polygon); i && spacing != KnotSpacing::uniform) {
    throw InputError(fmt::format("points {} and {} are equal: {} spacing needs neighbours that differ", *i + 1,
                                 number_after(*i), to_string(spacing)));
  }
  std::vector<double> knots{0};
  for (std::size_t i = 0; i < polygon.edges(); ++i) {
    double length = 1;
    if (spacing != KnotSpacing::uniform) length = distance(polygon[i], polygon[(i + 1) % polygon.size()]);
    if (spacing == KnotSpacing::centripetal) length = std::sqrt(length);
    const double next = knots.back() + length;
    if (!std::isfinite(next) || !(knots.back() < next)) {
      throw InputError(fmt::format("the distance {} of points {} and {} is too {} for {} spacing in double precision",
                                   length, i + 1, number_after(i), std::isfinite(next) ? "small" : "large",
                                   to_string(spacing)));
    }
    knots.push_back(next);
  }
  return knots;
}

}  // namespace limes
