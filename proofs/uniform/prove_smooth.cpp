// Theorem U1 on a region: bisection, with a level or a polytope of its own on every leaf.

#include "analysis/uniform/difference_symbol.hpp"
#include "proofs/uniform/contraction_prover.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

struct Task {
  Box box;
  int depth;
};

}  // namespace

RestrictedMask restricted(const Mask& mask, const Box& region) {
  RestrictedMask result{mask, common_denominator(mask.symbol)};
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (!region[k].is_point()) continue;
    result.mask.symbol = result.mask.symbol.substitute(static_cast<int>(k), region[k].lower);
    result.denominator = result.denominator.substitute(static_cast<int>(k), region[k].lower);
  }
  return result;
}

std::vector<std::vector<Rational>> sample_points(const Box& region) {
  constexpr std::size_t max_axes_with_corners = 3;
  std::vector<std::vector<Rational>> points{midpoint(region)};
  if (is_point(region) || region.size() > max_axes_with_corners) return points;
  for (unsigned corner = 0; corner < (1u << region.size()); ++corner) {
    std::vector<Rational> point;
    for (std::size_t k = 0; k < region.size(); ++k) {
      const bool upper = (corner >> k) & 1;
      if (upper && region[k].is_point()) break;
      if (upper ? region[k].upper_open : region[k].lower_open) break;
      point.push_back(upper ? region[k].upper : region[k].lower);
    }
    if (point.size() == region.size()) points.push_back(point);
  }
  return points;
}

ProofAttempt prove_smooth(const Mask& mask, int m, const Box& region, const ProofLimits& limits, const Stop& stop) {
  ProofAttempt attempt;
  const auto [scheme, denominator] = restricted(mask, region);
  const int variables = scheme.symbol.variables();
  const auto fail = [&](std::string reason, std::optional<std::vector<Rational>> point = std::nullopt) {
    attempt.reason = std::move(reason);
    attempt.failing_point = std::move(point);
    return attempt;
  };
  if (scheme.symbol.is_zero()) return fail("the mask is zero");
  if (!(scheme.symbol(1) == RationalFunction::constant(variables, scheme.arity))) {
    return fail(fmt::format("a(1) = {} does not hold identically", scheme.arity));
  }
  const std::optional<LaurentPolynomial> b = difference_symbol(scheme, m + 1);
  if (!b) return fail(fmt::format("the symbol has no factor sigma^{}", m + 1));

  const ContractionProver prover(*b, denominator, scheme.arity, limits, stop);
  std::vector<Task> tasks{{region, 0}};
  while (!tasks.empty()) {
    stop.check();
    const Task task = std::move(tasks.back());
    tasks.pop_back();
    ContractionProver::Attempt leaf = prover.attempt(task.box);
    if (leaf.witness) {
      ProofLeaf& proved = attempt.leaves.emplace_back(ProofLeaf{task.box, {}});
      std::visit([&](auto& witness) { proved.witness = std::move(witness); }, *leaf.witness);
      continue;
    }
    if (leaf.failing_point) return fail(std::move(leaf.reason), std::move(leaf.failing_point));
    const int axis = widest_axis(task.box, region);
    if (axis < 0 || task.depth == limits.max_depth) {
      return fail(std::move(leaf.reason), midpoint(task.box));
    }
    if (static_cast<int>(attempt.leaves.size() + tasks.size()) >= limits.max_leaves) {
      return fail(fmt::format("more than {} leaves would be needed", limits.max_leaves), midpoint(task.box));
    }
    const Rational value = prover.cut(task.box, axis);
    Box lower = task.box, upper = task.box;
    lower[static_cast<std::size_t>(axis)].upper = upper[static_cast<std::size_t>(axis)].lower = value;
    lower[static_cast<std::size_t>(axis)].upper_open = upper[static_cast<std::size_t>(axis)].lower_open = false;
    tasks.push_back({std::move(upper), task.depth + 1});
    tasks.push_back({std::move(lower), task.depth + 1});
  }
  attempt.proved = true;
  return attempt;
}

}  // namespace limes
