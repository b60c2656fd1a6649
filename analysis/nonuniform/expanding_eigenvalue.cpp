#include "analysis/nonuniform/expanding_eigenvalue.hpp"

#include "algebra/error.hpp"

#include <algorithm>

namespace limes {

namespace {

// The middle first, then the ends that belong to the interval, then the rest.
std::vector<Rational> values(const Interval& interval, int steps) {
  std::vector<Rational> result{interval.midpoint()};
  for (int k = 0; k <= steps; ++k) {
    const Rational x = interval.lower + interval.width() * k / steps;
    if (interval.contains(x) && std::find(result.begin(), result.end(), x) == result.end()) result.push_back(x);
  }
  return result;
}

}  // namespace

std::vector<Rational> candidate_ratios() {
  std::vector<Rational> result{1};
  for (int k = 1; k <= 12; ++k) result.push_back(power(Rational(2), -k));
  for (int k = 3; k <= 15; ++k) result.push_back(Rational(k) / 16);
  const std::size_t count = result.size();
  for (std::size_t i = 1; i < count; ++i) result.push_back(1 / result[i]);
  return result;
}

std::optional<ExpandingEigenvalue> expanding_eigenvalue_at(const LambdaPolynomial& chi, int smoothness,
                                                           const std::vector<Rational>& point) {
  Polynomial rest = chi.at(point);
  if (rest.degree() < chi.degree()) throw DomainError("the characteristic polynomial loses its leading coefficient");
  Rational eigenvalue = 1;
  for (int k = 0; k <= smoothness; ++k, eigenvalue /= 2) {
    if (rest(eigenvalue) == 0) rest = divide(rest, Polynomial({-eigenvalue, 1})).first;
  }
  const Rational rho = power(Rational(2), -smoothness);
  if (roots_inside_circle(rest, rho)) return std::nullopt;
  const CircleCount count = count_roots_by_circle(rest, rho);
  return ExpandingEigenvalue{point, std::move(rest), count};
}

std::optional<ExpandingEigenvalue> find_expanding_eigenvalue(const LambdaPolynomial& chi, int smoothness,
                                                             const Box& region, int steps, const Stop& stop) {
  std::vector<std::vector<Rational>> choices;
  for (const Interval& interval : region) choices.push_back(values(interval, steps));
  std::vector<std::size_t> position(region.size(), 0);
  const std::vector<Rational> gammas = candidate_ratios();
  while (true) {
    std::vector<Rational> point;
    for (std::size_t i = 0; i < region.size(); ++i) point.push_back(choices[i][position[i]]);
    point.emplace_back();
    for (const Rational& gamma : gammas) {
      stop.check();
      point.back() = gamma;
      if (chi.leading()(point) == 0) continue;
      if (auto found = expanding_eigenvalue_at(chi, smoothness, point)) return found;
    }
    std::size_t axis = 0;
    while (axis < region.size() && ++position[axis] == choices[axis].size()) position[axis++] = 0;
    if (axis == region.size()) return std::nullopt;
  }
}

}  // namespace limes
