// The best bounds where a claim is undecided.
#include "algebra/error.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/hoelder_exponent.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

namespace limes::report_impl {

Blocks undecided_text(const Scheme& scheme, const Claim& claim, const Stop& stop) {
  if (scheme.sequence || scheme.surface || claim.space || claim.subject != ClaimSubject::limits) return {};
  const std::vector<Rational> point = simple_point(claim.region);
  Blocks blocks;
  try {
    const Mask mask = at(scheme.mask, point);
    const int m = claim.smoothness, p = mask.arity;
    const std::optional<LaurentPolynomial> b = difference_symbol(mask, m + 1);
    if (!b || sum_rule_order(mask) < m + 1) return {};
    const std::string where = scheme.parameters.empty() ? "" : fmt::format(" at ${}$", point_latex(scheme.parameter_names(), point));
    DataTable table{.caption = {}, .columns = "l", .header = {rich("level $l$")}, .rows = {{rich("$\\lVert S_b^l\\rVert_\\infty$")}}};
    for (int level = 1; level <= 9; ++level) {
      std::optional<Rational> norm;
      try {
        norm = exact_contractivity_norm(*b, p, level, stop, 4e6);
      } catch (const LimitError&) {
        break;
      }
      table.columns += 'r';
      table.header.push_back(mathematics(std::to_string(level)));
      table.rows.front().push_back(mathematics(to_decimal(*norm, 4, Rounding::up)));
    }
    if (table.header.size() > 1) {
      blocks.push_back(paragraph(fmt::format("With $a(z)={}{}\\,b(z)$ the norms{}{} are", m == 0 ? "" : negative_power(p, m), sigma_power(p, m + 1), where, scheme.insertion_rule ? " for equal intervals" : "")));
      blocks.push_back(std::move(table));
    }
    const SpectralRadiusBounds radius = bound_spectral_radius(difference_sections(mask, m + 1), {.digits = 4, .polytopes = {}}, stop);
    blocks.push_back(paragraph(fmt::format("The joint spectral radius of the sections of $b${} lies in $[{},{}]$; below $1$ it proves $C^{{{}}}$.", where, to_decimal(radius.lower, 6, Rounding::down),
                                           to_decimal(radius.upper, 6, Rounding::up), m)));
  } catch (const DomainError&) {
    return {};  // a pole
  } catch (const LimitError&) {
    return blocks;
  }
  return blocks;
}

}  // namespace limes::report_impl
