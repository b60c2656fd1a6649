#include "geometry/polygon.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

void check_knots(const std::vector<double>& knots, std::size_t expected) {
  if (knots.size() != expected)
    throw DomainError(fmt::format("{} knots where {} are expected", knots.size(), expected));
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) throw DomainError(fmt::format("knot {} is not finite", i + 1));
    if (i > 0 && !(knots[i - 1] < knots[i])) {
      throw DomainError(fmt::format("knots {} and {} are not increasing in double precision", i, i + 1));
    }
  }
}

}  // namespace

Polygon::Polygon(int dimension, std::vector<double> coordinates, bool closed, std::vector<double> knots)
    : dimension_(dimension), closed_(closed), coordinates_(std::move(coordinates)), knots_(std::move(knots)) {
  if (dimension_ < 1) throw DomainError("a polygon needs a dimension of at least 1");
  if (coordinates_.empty()) throw DomainError("a polygon needs at least one point");
  if (coordinates_.size() % static_cast<std::size_t>(dimension_) != 0) {
    throw DomainError(fmt::format("{} coordinates are no points of dimension {}", coordinates_.size(), dimension_));
  }
  for (std::size_t k = 0; k < coordinates_.size(); ++k) {
    if (std::isfinite(coordinates_[k])) continue;
    throw DomainError(fmt::format("point {} is not finite", k / static_cast<std::size_t>(dimension_) + 1));
  }
  if (!knots_.empty()) check_knots(knots_, size() + (closed_ ? 1 : 0));
}

std::span<const double> Polygon::operator[](std::size_t i) const {
  const auto d = static_cast<std::size_t>(dimension_);
  return {coordinates_.data() + i * d, d};
}

Polygon Polygon::with_knots(std::vector<double> knots) const {
  return {dimension_, coordinates_, closed_, std::move(knots)};
}

double distance(std::span<const double> a, std::span<const double> b) {
  double length = 0;
  for (std::size_t k = 0; k < a.size(); ++k) length = std::hypot(length, b[k] - a[k]);
  return length;
}

}  // namespace limes
