#pragma once

#include "schemes/unity/derive_mask.hpp"

#include <functional>

namespace limes {

/// A least value of E over an interval of one parameter.
struct OptimalParameter {
  /// A multiple of the accuracy, the better one of the two next to the minimum (or an end of the interval).
  Rational parameter;
  double error = 0;
  /// Parameters of all local minima that were seen, in rising order.
  std::vector<double> local_minima;
};

/// Minimises E over the interval: E on an even grid of `grid` + 1 points, then golden sections around every local minimum of the grid until the
/// bracket is shorter than the accuracy. A minimum narrower than a step of the grid can be missed; of several
/// in one bracket one is found.
/// \param error E of a parameter \pre accuracy > 0, grid >= 2 \throws Interrupted, what `error` throws
OptimalParameter optimise_parameter(const std::function<double(const Rational&)>& error, const Interval& interval, const Rational& accuracy,
                                    int grid, const Stop& stop);

}  // namespace limes
