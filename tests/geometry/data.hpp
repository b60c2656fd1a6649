#pragma once

#include "geometry/polygon.hpp"

#include <cmath>
#include <random>

namespace limes::test {

/// Points with coordinates in [-1, 1], the same ones for the same seed.
inline Polygon random_polygon(int dimension, std::size_t size, bool closed, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> coordinates;
  for (std::size_t k = 0; k < size * static_cast<std::size_t>(dimension); ++k) {
    coordinates.push_back(static_cast<double>(random()) / 2147483648.0 - 1);
  }
  return {dimension, coordinates, closed};
}

/// The greatest difference of two coordinates; infinite for polygons of different shape.
inline double gap(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return INFINITY;
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}

/// An affine map of the plane.
inline Polygon mapped(const Polygon& polygon) {
  std::vector<double> coordinates;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double x = polygon[i][0], y = polygon[i][1];
    coordinates.insert(coordinates.end(), {2 * x - 3 * y + 7, 0.5 * x + y - 4});
  }
  return {2, coordinates, polygon.closed(), polygon.knots()};
}

/// Of a closed polygon with or without knots: point k first.
inline Polygon rotated(const Polygon& polygon, std::size_t k) {
  std::vector<double> coordinates, knots;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto p = polygon[(i + k) % polygon.size()];
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  }
  const std::vector<double>& t = polygon.knots();
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool wraps = i + k >= polygon.size();
    knots.push_back(wraps ? t[i + k - polygon.size()] + (t.back() - t.front()) : t[i + k]);
  }
  return {polygon.dimension(), coordinates, true, knots};
}

}  // namespace limes::test
