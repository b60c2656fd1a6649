#include "schemes/unity/optimise_weight.hpp"

#include "algebra/error.hpp"

#include <cmath>

namespace limes {
namespace {

/// The multiples of the accuracy next to x, kept in the interval.
std::vector<Rational> neighbours(double x, const Interval& interval, const Rational& accuracy) {
  std::vector<Rational> values;
  for (const double quotient : {std::floor(x / approx_double(accuracy)), std::ceil(x / approx_double(accuracy))}) {
    values.push_back(std::clamp(Rational(Rational(quotient) * accuracy), interval.lower, interval.upper));
  }
  return values;
}

/// The middle of a bracket of the minimum of a unimodal function, shorter than the accuracy.
double golden_section(const std::function<double(double)>& f, double lower, double upper, double accuracy, const Stop& stop) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double left = upper - golden * (upper - lower), right = lower + golden * (upper - lower);
  double at_left = f(left), at_right = f(right);
  while (upper - lower > accuracy) {
    stop.check();
    if (at_left <= at_right) {
      upper = std::exchange(right, left);
      left = upper - golden * (upper - lower);
      at_right = std::exchange(at_left, f(left));
    } else {
      lower = std::exchange(left, right);
      right = lower + golden * (upper - lower);
      at_left = std::exchange(at_right, f(right));
    }
  }
  return (lower + upper) / 2;
}

}  // namespace

OptimalParameter optimise_parameter(const std::function<double(const Rational&)>& error, const Interval& interval, const Rational& accuracy,
                                    int grid, const Stop& stop) {
  if (accuracy <= 0 || accuracy < interval.width() / 1000000000) throw InputError("the accuracy is too small for the interval");
  std::vector<double> values;
  for (int k = 0; k <= grid; ++k) {
    stop.check();
    values.push_back(error(interval.lower + interval.width() * k / grid));
  }
  const auto at = [&](double x) { return error(std::clamp(Rational(x), interval.lower, interval.upper)); };
  const double step = approx_double(interval.width()) / grid, lower = approx_double(interval.lower);
  OptimalParameter best{.parameter = interval.lower, .error = INFINITY, .local_minima = {}};
  for (int k = 0; k <= grid; ++k) {
    if ((k > 0 && values[k - 1] < values[k]) || (k < grid && values[k + 1] <= values[k])) continue;
    const double minimum = golden_section(at, lower + std::max(k - 1, 0) * step, lower + std::min(k + 1, grid) * step,
                                          approx_double(accuracy) / 4, stop);
    best.local_minima.push_back(minimum);
    for (const Rational& parameter : neighbours(minimum, interval, accuracy)) {
      const double value = error(parameter);
      if (value >= best.error) continue;
      best.error = value;
      best.parameter = parameter;
    }
  }
  return best;
}

}  // namespace limes
