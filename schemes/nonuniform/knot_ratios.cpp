#include "schemes/nonuniform/knot_ratios.hpp"

#include "algebra/error.hpp"

namespace limes {
namespace {

std::vector<RationalFunction> ones(int points, int variables) {
  if (points < 2 || points % 2 != 0) throw DomainError("the number of points of a rule must be even");
  return std::vector<RationalFunction>(static_cast<std::size_t>(points - 2), RationalFunction::constant(variables, 1));
}

}  // namespace

KnotRatios KnotRatios::uniform(int points, int variables) { return KnotRatios(ones(points, variables)); }

KnotRatios KnotRatios::isolated(int points, int position, const RationalFunction& gamma) {
  std::vector<RationalFunction> ratios = ones(points, gamma.variables());
  if (position < 0 || position >= points - 2) throw DomainError("there is no such ratio");
  ratios[static_cast<std::size_t>(position)] = gamma;
  return KnotRatios(std::move(ratios));
}

KnotRatios KnotRatios::independent(int points, int variables, int first) {
  std::vector<RationalFunction> ratios = ones(points, variables);
  for (int k = 0; k < points - 2; ++k)
    ratios[static_cast<std::size_t>(k)] = RationalFunction::variable(variables, first + k);
  return KnotRatios(std::move(ratios));
}

std::vector<RationalFunction> KnotRatios::knots(int variables) const {
  RationalFunction interval = RationalFunction::constant(variables, 1);
  std::vector<RationalFunction> result{RationalFunction(variables), interval};
  for (const RationalFunction& ratio : ratios_) {
    interval *= ratio;
    result.push_back(result.back() + interval);
  }
  return result;
}

VariableNames ratio_names(int points) {
  VariableNames names;
  for (int k = 1; k <= points - 2; ++k) names.push_back("b" + std::to_string(k));
  return names;
}

}  // namespace limes
