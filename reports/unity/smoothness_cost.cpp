#include "reports/unity/smoothness_cost.hpp"

#include "algebra/error.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "proofs/prove.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

bool is_certified(const Scheme& scheme, const Claim& claim, const Stop& stop) {
  const Verdict verdict = prove(scheme, claim, {}, stop);
  if (verdict.interrupted) throw Interrupted(verdict.reason);
  return verdict.outcome == Outcome::certified;
}

/// The greatest n / 100 with norm <= 2^{level (rules - 1 - n / 100)}: floating point proposes, integers decide.
Rational exponent_from_norm(const Rational& norm, int level, int rules) {
  const auto holds = [&](int n) {  // norm^100 <= 2^{level (100 (rules - 1) - n)}
    return power(norm, 100) <= power(Rational(2), level * (100 * (rules - 1) - n));
  };
  int n = static_cast<int>(std::floor(100 * (rules - 1 - std::log2(approx_double(norm)) / level))) + 1;
  while (!holds(n)) --n;
  return Rational(n) / 100;
}

std::optional<Rational> exponent_bound(const Mask& mask, const Stop& stop) {
  constexpr int max_level = 8;
  const int rules = sum_rule_order(mask);
  if (rules == 0 || mask.symbol(1).constant_value() != 2) return std::nullopt;
  const LaurentPolynomial b = *difference_symbol(mask, rules);
  std::optional<Rational> best;
  for (int level = 1; level <= max_level; ++level) {
    const Rational bound = exponent_from_norm(exact_contractivity_norm(b, mask.arity, level, stop), level, rules);
    if (!best || bound > *best) best = bound;
  }
  if (*best <= 0) return std::nullopt;
  return best;
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
  for (int order = 0; order <= max_order; ++order) {
    WeightProblem constrained = problem;
    if (order > 0) constrained.constraints.push_back(fmt::format("sum-rules={}", order));
    std::optional<DerivedMask> derived;
    try {
      derived = derive_mask(constrained, stop);
    } catch (const InputError&) {
      if (order == 0) throw;
      break;  // so many sum rules do not fit the mask
    }
    const Scheme scheme = scheme_of(*derived, fmt::format("sum-rules-{}", order));
    costs.push_back({order, derived->error, provable_claims(scheme, stop), exponent_bound(scheme.mask, stop)});
  }
  return costs;
}

}  // namespace limes
