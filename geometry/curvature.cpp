#include "geometry/curvature.hpp"

#include "algebra/error.hpp"

#include <cmath>

namespace limes {
namespace {

/// K for u = a - b and v = c - b, written to `result`.
void curvature_vector(std::span<const double> a, std::span<const double> b, std::span<const double> c, double* result) {
  double uu = 0, vv = 0, uv = 0, ww = 0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double u = a[k] - b[k], v = c[k] - b[k], w = c[k] - a[k];
    uu += u * u;
    vv += v * v;
    uv += u * v;
    ww += w * w;
  }
  if (uu == 0 || vv == 0 || ww == 0) return;
  const double along_u = 2 * (1 - uv / uu) / ww, along_v = 2 * (1 - uv / vv) / ww;
  for (std::size_t k = 0; k < b.size(); ++k) result[k] = along_u * (a[k] - b[k]) + along_v * (c[k] - b[k]);
}

}  // namespace

std::vector<double> curvature_vectors(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  const auto d = static_cast<std::size_t>(polygon.dimension());
  std::vector<double> vectors(n * d, 0.0);
  if (n < 3) return vectors;
  const std::size_t first = polygon.closed() ? 0 : 1;
  for (std::size_t i = first; i < n - first; ++i) {
    curvature_vector(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n], &vectors[i * d]);
  }
  if (!polygon.closed()) {
    std::copy_n(vectors.begin() + static_cast<std::ptrdiff_t>(d), d, vectors.begin());
    std::copy_n(vectors.end() - 2 * static_cast<std::ptrdiff_t>(d), d, vectors.end() - static_cast<std::ptrdiff_t>(d));
  }
  return vectors;
}

std::vector<double> curvatures(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  const auto d = static_cast<std::size_t>(polygon.dimension());
  const std::vector<double> vectors = curvature_vectors(polygon);
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) {
    double length = 0;
    for (std::size_t k = 0; k < d; ++k) length = std::hypot(length, vectors[i * d + k]);
    values[i] = length;
  }
  if (d != 2 || n < 3) return values;
  const auto turns_right = [&](std::size_t i) {
    const auto a = polygon[(i + n - 1) % n], b = polygon[i], c = polygon[(i + 1) % n];
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) < 0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t inner = polygon.closed() ? i : std::clamp<std::size_t>(i, 1, n - 2);
    if (turns_right(inner)) values[i] = -values[i];
  }
  return values;
}

std::vector<double> curvature_comb(const Polygon& polygon, double scale) {
  std::vector<double> tips = curvature_vectors(polygon);
  for (std::size_t k = 0; k < tips.size(); ++k) {
    tips[k] = polygon.coordinates()[k] - scale * tips[k];
    if (!std::isfinite(tips[k])) throw DomainError("the curvature comb exceeds the range of double precision");
  }
  return tips;
}

}  // namespace limes
