#include "schemes/unity/refinement_equation.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

constexpr int max_shifts = 64;

Integer floor_of(const Rational& x) {
  const Integer quotient = numerator(x) / denominator(x);
  return x < 0 && quotient * denominator(x) != numerator(x) ? quotient - 1 : quotient;
}

/// The least element of offset + Z that is not less than x.
Rational next_in_lattice(const Rational& x, const Rational& offset) { return offset - Rational(floor_of(offset - x)); }

/// sum_i w(u - i) over one period keeps away from zero: else Q(u) has the indeterminate form 0/0 somewhere.
void check_sum_of_weights(const WeightFunction& weight) {
  constexpr int points = 512;
  const auto* polynomial = std::get_if<PiecewisePolynomial>(&weight.shape);
  if (polynomial && polynomial->global) return;  // no compact support: no sum
  const double lower = approx_double(weight.support().lower);
  const int shifts = static_cast<int>(std::ceil(approx_double(weight.support().width()))) + 1;
  double least = INFINITY, greatest = -INFINITY;
  for (int k = 0; k < points; ++k) {
    std::vector<double> u;
    for (int i = 0; i < shifts; ++i) u.push_back(lower + i + (k + 0.5) / points);
    double sum = 0;
    for (const double value : approx_values(weight, u)) sum += value;
    least = std::min(least, sum);
    greatest = std::max(greatest, sum);
  }
  const double size = std::max(std::abs(least), std::abs(greatest));
  if (std::min(std::abs(least), std::abs(greatest)) <= 1e-12 * size || least * greatest <= 0) {
    throw InputError("the sum of the weights, sum_i w(u - i), vanishes somewhere: the curve has the indeterminate form 0/0 there");
  }
}

}  // namespace

int RefinementEquation::first_index() const { return static_cast<int>(floor_of(first_shift)); }

RefinementEquation refinement_equation(const WeightFunction& weight, const std::optional<Interval>& domain,
                                       const std::optional<std::pair<Rational, Rational>>& shifts) {
  RefinementEquation equation{.weight = weight, .domain = domain.value_or(weight.support()), .first_shift = {}};
  if (equation.domain.is_point() || abs(equation.domain.lower) > 4096 || abs(equation.domain.upper) > 4096) {
    throw InputError("the equation is asked for on an interval with interior points within [-4096, 4096]");
  }
  const Interval support = weight.support();
  if (abs(support.lower) > 4096 || abs(support.upper) > 4096) throw InputError("the weight's support is not within [-4096, 4096]");
  check_sum_of_weights(weight);
  Rational first, last;
  if (shifts) {
    std::tie(first, last) = *shifts;
    if (first > last) throw InputError(fmt::format("no shifts from {} to {}", to_string(first), to_string(last)));
    if (denominator(last - first) != 1) throw InputError("the shifts from first to last are a whole number apart");
  } else {
    const std::optional<Rational> axis = weight.axis();
    const Rational width = support.width();
    const bool odd = denominator(width) == 1 && numerator(width) % 2 != 0;
    const Rational offset = axis ? *axis + Rational(odd ? 1 : 0) / 2 : support.lower;
    first = next_in_lattice(2 * equation.domain.lower - support.lower, offset);
    last = -next_in_lattice(support.upper - 2 * equation.domain.upper, -offset);
    if (first > last) {
      throw InputError(fmt::format("no dilate w(2u - s) has its support inside of {}", to_string(equation.domain)));
    }
  }
  if (last - first >= max_shifts) throw LimitError(fmt::format("more than {} shifts", max_shifts));
  equation.first_shift = first;
  equation.count = static_cast<int>(numerator(Rational(last - first))) + 1;
  return equation;
}

}  // namespace limes
