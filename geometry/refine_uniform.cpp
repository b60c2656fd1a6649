#include "geometry/strip_impl.hpp"

#include "algebra/error.hpp"

#include <cmath>

namespace limes {
namespace {

using geometry_impl::Strip;
using geometry_impl::Support;

/// Weights of the points j + offset, j + offset + 1, .. where j = floor((i - first_index) / arity).
struct Stencil {
  std::int64_t offset = 0;
  std::vector<double> weights;
};

/// One stencil for each residue of i - first_index modulo the arity, without zeros at its ends.
std::vector<Stencil> stencils(const UniformRule& rule) {
  std::vector<Stencil> result(static_cast<std::size_t>(rule.arity));
  const auto p = static_cast<std::size_t>(rule.arity);
  for (std::size_t residue = 0; residue < p; ++residue) {
    Stencil& stencil = result[residue];
    // The coefficient a_{residue + p t} (counted from the first) belongs to the point j - t.
    for (std::size_t k = residue; k < rule.mask.size(); k += p)
      stencil.weights.insert(stencil.weights.begin(), rule.mask[k]);
    while (!stencil.weights.empty() && stencil.weights.back() == 0) {
      stencil.weights.pop_back();
      --stencil.offset;
    }
    const auto nonzero = std::find_if(stencil.weights.begin(), stencil.weights.end(), [](double c) { return c != 0; });
    stencil.weights.erase(stencil.weights.begin(), nonzero);
    stencil.offset -= static_cast<std::int64_t>(stencil.weights.size()) - 1;
  }
  return result;
}

void apply(const std::vector<Stencil>& stencils, int first_index, const Strip& from, Strip& to) {
  const auto p = static_cast<std::int64_t>(stencils.size());
  const std::size_t d = to.dimension;
  for (std::int64_t i = to.first, last = to.last(); i <= last; ++i) {
    std::int64_t residue = (i - first_index) % p;
    if (residue < 0) residue += p;
    const Stencil& stencil = stencils[static_cast<std::size_t>(residue)];
    if (stencil.weights.empty()) continue;
    const double* source = from[(i - first_index - residue) / p + stencil.offset];
    double* target = to[i];
    for (const double weight : stencil.weights) {
      for (std::size_t k = 0; k < d; ++k) target[k] += weight * source[k];
      source += d;
    }
  }
}

}  // namespace

void geometry_impl::refine_level(const UniformRule& rule, const Strip& from, Strip& to) {
  apply(stencils(rule), rule.first_index, from, to);
}

int UniformRule::points() const {
  std::size_t most = 0;
  for (const Stencil& stencil : stencils(*this)) most = std::max(most, stencil.weights.size());
  return static_cast<int>(most);
}

UniformRule approx_uniform_rule(const Mask& mask, std::span<const Rational> parameter_values) {
  const Mask exact = at(mask, parameter_values);
  if (exact.symbol.is_zero()) throw DomainError("the mask is zero at this parameter value");
  UniformRule rule{exact.arity, exact.symbol.lowest(), {}, interpolatory_index(exact)};
  for (const Rational& c : exact.symbol.rational_coefficients()) {
    rule.mask.push_back(approx_double(c));
    if (!std::isfinite(rule.mask.back())) throw DomainError("the mask exceeds the range of double precision");
  }
  return rule;
}

Polygon refine_polygon(const Polygon& polygon, const UniformRule& rule, const Refinement& refinement,
                       const Stop& stop) {
  if (refinement.ends == EndRule::exact) throw DomainError("only nonstationary schemes have exact ends");
  Support support{rule.arity,        rule.first_index,
                  rule.last_index(), rule.first_index + rule.last_index(),
                  rule.points(),     rule.interpolatory_index.has_value(), {}};
  if (rule.interpolatory_index) support.centre_twice = 2 * *rule.interpolatory_index;
  const std::vector<Stencil> level_stencils = stencils(rule);
  Strip strip = geometry_impl::refined_strip(
      polygon, support, refinement, stop,
      [&](const Strip& from, Strip& to, int) { apply(level_stencils, rule.first_index, from, to); });
  return {polygon.dimension(), std::move(strip.coordinates), polygon.closed()};
}

}  // namespace limes
