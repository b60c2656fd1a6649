#include "reports/unity/smoothness_cost.hpp"

#include "algebra/error.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/hoelder_exponent.hpp"
#include "proofs/prove.hpp"
#include "proofs/spectral_radius/radius_certificate.hpp"
#include "schemes/unity/derive_mask.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

bool is_certified(const Scheme& scheme, const Claim& claim, const Stop& stop) {
  const Verdict verdict = prove(scheme, claim, {}, stop);
  if (verdict.interrupted) throw Interrupted(verdict.reason);
  return verdict.outcome == Outcome::certified;
}

/// With few vectors first: hundredths are enough for a table, more vectors are tried for them only.
void enclose_exponent(const Scheme& scheme, SmoothnessCost& cost, const Stop& stop) {
  constexpr int digits = 2;
  const Rational enough(2, 100);
  for (const std::size_t max_vectors : {60, 250}) {
    PolytopeLimits limits;
    limits.max_vectors = max_vectors;
    limits.max_degree = 1;
    const HoelderExponent exponent = bound_hoelder_exponent(scheme.mask, digits, limits, stop);
    if (exponent.radius.interrupted) stop.check();
    if (!exponent.bounds.lower) return;
    try {
      cost.exponent_certificate = prove_hoelder_exponent(scheme, {}, exponent);
      cost.exponent = exponent.bounds;
    } catch (const LimitError&) {
      return;
    }
    if (exponent.radius.upper <= exponent.radius.lower * (1 + enough)) return;
  }
}

}  // namespace

Scheme scheme_of(const DerivedMask& derived, const std::string& name) {
  Scheme scheme;
  scheme.name = name;
  scheme.mask = {2, LaurentPolynomial::from_rationals(derived.equation.first_index(), derived.mask)};
  return scheme;
}

std::vector<Claim> provable_claims(const Scheme& scheme, const Stop& stop) {
  std::vector<Claim> claims;
  const auto add = [&](const std::string& text) {
    const Claim claim = read_statement(text);
    if (!is_certified(scheme, claim, stop)) return false;
    claims.push_back(claim);
    return true;
  };
  if (add("only zero limits")) {
    add("projective C0");
    add("not projective C1");
    return claims;
  }
  for (int m = sum_rule_order(scheme.mask) - 1; m >= 0; --m) {
    if (!add(fmt::format("C{}", m))) continue;
    add(fmt::format("not C{}", m + 1));
    break;
  }
  return claims;
}

std::vector<SmoothnessCost> smoothness_costs(const WeightProblem& problem, int max_order, const Stop& stop) {
  std::vector<SmoothnessCost> costs;
  WeightProblem unconstrained = problem;
  std::erase_if(unconstrained.constraints, [](const std::string& text) { return text.starts_with("sum-rules="); });
  int satisfied = 0;
  for (int order = 0; order <= max_order; ++order) {
    if (order > 1 && satisfied >= order) {
      costs.push_back(costs.back());
      costs.back().sum_rules = order;
      continue;
    }
    WeightProblem constrained = unconstrained;
    if (order > 0) constrained.constraints.push_back(fmt::format("sum-rules={}", order));
    std::optional<DerivedMask> derived;
    try {
      derived = derive_mask(constrained, stop);
    } catch (const InputError&) {
      if (order == 0) throw;
      break;  // so many sum rules do not fit the mask
    }
    const Scheme scheme = scheme_of(*derived, fmt::format("sum-rules-{}", order));
    costs.push_back({.sum_rules = order, .mask = derived->mask, .error = derived->error, .claims = provable_claims(scheme, stop)});
    satisfied = sum_rule_order(scheme.mask);
    enclose_exponent(scheme, costs.back(), stop);
  }
  return costs;
}

}  // namespace limes
