#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace limes {

/// Points p_0, .., p_{N-1} of R^d in order: the vertices of an open polygon, or of a closed one, where p_0 follows
/// p_{N-1}. Optionally each point has a knot. All numbers are finite, knots are strictly increasing.
class Polygon {
 public:
  /// `coordinates` is point after point. `knots` is empty, or t_0 < .. < t_{N-1}, and t_N of p_0's return when closed:
  /// t_N - t_0 is the period. \throws DomainError when something of this does not hold, or there is no point.
  Polygon(int dimension, std::vector<double> coordinates, bool closed = false, std::vector<double> knots = {});

  int dimension() const { return dimension_; }
  std::size_t size() const { return coordinates_.size() / static_cast<std::size_t>(dimension_); }
  bool closed() const { return closed_; }
  /// Number of edges: size() when closed, else one less.
  std::size_t edges() const { return closed_ ? size() : size() - 1; }
  /// Point i. \pre i < size()
  std::span<const double> operator[](std::size_t i) const;
  const std::vector<double>& coordinates() const { return coordinates_; }
  const std::vector<double>& knots() const { return knots_; }

  /// The same points with knots. \throws DomainError
  Polygon with_knots(std::vector<double> knots) const;

 private:
  int dimension_;
  bool closed_;
  std::vector<double> coordinates_;
  std::vector<double> knots_;
};

/// Euclidean distance of two points of the same dimension, without overflow in between.
double distance(std::span<const double> a, std::span<const double> b);

}  // namespace limes
