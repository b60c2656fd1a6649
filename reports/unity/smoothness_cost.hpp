#pragma once

#include "algebra/stop.hpp"
#include "schemes/scheme.hpp"
#include "schemes/unity/weight_problem.hpp"

#include <optional>
#include <vector>

namespace limes {

/// A uniform scheme with the mask and nothing else.
Scheme scheme_of(const DerivedMask& derived, const std::string& name);

/// Claims about a scheme without parameters that Limes proves: with the first sum rule the greatest certified C^m and, if it is proved, "not C^{m+1}";
/// otherwise "only zero limits" and what is proved of the projective scheme.
std::vector<Claim> provable_claims(const Scheme& scheme, const Stop& stop);

/// What the sum rules of one order cost, and what is proved for them.
struct SmoothnessCost {
  int sum_rules = 0;
  double error = 0;
  std::vector<Claim> claims;
  /// A lower bound of the Hoelder exponent, k - 1 - log2(||S_b^l||) / l for the k sum rules of the mask and some l, rounded down to hundredths.
  std::optional<Rational> exponent;
};

/// One row for each order of sum rules from 0 to `max_order`, as far as the constraints are feasible.
std::vector<SmoothnessCost> smoothness_costs(const WeightProblem& problem, int max_order, const Stop& stop);

}  // namespace limes
