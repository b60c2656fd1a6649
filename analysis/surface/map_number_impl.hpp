// Arithmetic of ApproxMapNumber. Included by sources only.
#pragma once

#include "analysis/surface/characteristic_map.hpp"

#include <algorithm>
#include <cmath>

namespace limes::approx_map {

using Number = ApproxMapNumber;

inline Number operator+(const Number& x, const Number& y) { return {x.value + y.value, x.slope + y.slope, x.error + y.error}; }
inline Number operator-(const Number& x, const Number& y) { return {x.value - y.value, x.slope - y.slope, x.error + y.error}; }
inline Number operator-(const Number& x) { return {-x.value, -x.slope, x.error}; }
inline Number operator*(double c, const Number& x) { return {c * x.value, c * x.slope, std::abs(c) * x.error}; }
inline double magnitude(const Number& x) { return std::abs(x.value) + std::abs(x.slope) + x.error; }
inline Number operator*(const Number& x, const Number& y) {
  const double product = std::abs(x.slope * y.slope);
  return {x.value * y.value, x.value * y.slope + x.slope * y.value, product + magnitude(x) * y.error + magnitude(y) * x.error};
}
/// 1/(v + w s + e) = (1 - w s/v)/v + ...
inline Number inverse(const Number& x) {
  const double slope = -x.slope / (x.value * x.value), least = std::abs(x.value) - std::abs(x.slope) - x.error;
  const double rest = x.slope * x.slope / (x.value * x.value * least) + x.error / (least * least);
  return {1 / x.value, slope, rest};
}

struct Ends {
  double lower, upper;
};
inline Ends ends(const Number& x) {
  const double r = std::abs(x.slope) + x.error;
  return {x.value - r, x.value + r};
}
inline Ends product(const Ends& x, const Ends& y) {
  const auto [low, high] = std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
  return {low, high};
}

}  // namespace limes::approx_map
