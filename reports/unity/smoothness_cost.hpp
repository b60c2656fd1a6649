#pragma once

#include "algebra/stop.hpp"
#include "analysis/uniform/hoelder_exponent.hpp"
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
  std::vector<Rational> mask = {};
  double error = 0;
  std::vector<Claim> claims = {};
  /// Of the Hoelder exponent, thousandths to two tenths apart: what can be had quickly; the certificate is accepted by the checker.
  ExponentBounds exponent = {};
  std::string exponent_certificate = {};
};

/// "1.97", ">= 1.97", "[1.97, 1.99]"; "" without a lower end.
std::string exponent_range(const ExponentBounds& bounds, const char* at_least = ">= ", const char* comma = ", ");

/// One row for each order of sum rules from 0 to `max_order`, as far as the constraints are feasible; constraints of the problem about sum rules
/// do not count. Orders that come for nothing (symmetric masks) have the mask of the order before.
std::vector<SmoothnessCost> smoothness_costs(const WeightProblem& problem, int max_order, const Stop& stop);

}  // namespace limes
