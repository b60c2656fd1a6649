#pragma once

#include <functional>
#include <span>
#include <vector>

namespace limes {

struct ApproxMinimum {
  std::vector<double> x;
  double value = 0;
};

/// The downhill simplex method: derivative-free and local; a floating hint. The first simplex is x and its neighbours at the
/// distance `step` along the axes; it ends early when the simplex has shrunk to a point. [Nelder & Mead 1965] \pre x is not empty
ApproxMinimum approx_minimum(const std::function<double(std::span<const double>)>& f, std::vector<double> x, double step, int iterations);

}  // namespace limes
