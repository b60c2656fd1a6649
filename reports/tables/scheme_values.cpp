// The verbs that tables use to speak of uniform schemes: show and norm; and verify, of any scheme.
#include "algebra/error.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "proofs/prove.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

namespace limes::table_impl {
namespace {

ComputedList single(ComputedValue value) { return {0, {std::move(value)}}; }

ComputedList coefficients(const LaurentPolynomial& symbol, const VariableNames& names) {
  ComputedList list{symbol.is_zero() ? 0 : symbol.lowest(), {}};
  for (const RationalFunction& c : symbol.coefficients()) list.values.push_back(ComputedValue::formula(c, names));
  return list;
}

}  // namespace

ComputedResult verify_values(const TableCommand& command, const Stop& stop) {
  command.allow({"--claim", "--param"});
  const Scheme scheme = load_scheme(command.operand());
  const std::optional<std::string> text = command.option("--claim");
  if (!text) throw InputError("'verify' in a table needs --claim");
  Claim claim = read_statement(*text);
  claim.region = region_from_settings(scheme, command.parameters());
  if (scheme.sequence) claim.type = type_from_settings(scheme, command.parameters());
  const Verdict verdict = prove(scheme, claim, {}, stop);
  if (verdict.interrupted) throw Interrupted(verdict.reason);
  return {{"verdict", single({verdict.outcome, {}})},
          {"level", single(ComputedValue::count(verdict.level()))},
          {"leaves", single(ComputedValue::count(verdict.leaf_count()))}};
}

ComputedResult norm_values(const TableCommand& command, const Stop& stop) {
  command.allow({"--order", "--level", "--param"});
  const Scheme scheme = load_scheme(command.operand());
  require_one_mask(scheme, "norm");
  const Box region = region_from_settings(scheme, command.parameters());
  if (!is_point(region)) throw InputError("'norm' needs one value of every parameter");
  const Mask mask = at(scheme.mask, midpoint(region));
  const int order = command.integer_option("--order", -1, 64), level = command.integer_option("--level", 1, 40);
  const std::optional<LaurentPolynomial> b = difference_symbol(mask, order + 1);
  if (!b) throw InputError(fmt::format("the symbol of {} has no factor sigma^{} here", scheme.name, order + 1));
  return {{"norm", single(ComputedValue::exact(exact_contractivity_norm(*b, mask.arity, level, stop)))}};
}

ComputedResult show_values(const TableCommand& command, const Stop&) {
  command.allow({"--param"});
  const Scheme scheme = load_scheme(command.operand());
  require_one_mask(scheme, "show");
  const Box region = region_from_settings(scheme, command.parameters());
  const VariableNames names = scheme.parameter_names();
  Mask mask = scheme.mask;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (region[k].is_point()) mask.symbol = mask.symbol.substitute(static_cast<int>(k), region[k].lower);
  }
  const int order = sum_rule_order(mask);
  const PolynomialDegrees degrees = polynomial_degrees(mask);
  return {{"mask", coefficients(mask.symbol, names)},
          {"difference_symbol", coefficients(*difference_symbol(mask, order), names)},
          {"sum_rule_order", single(ComputedValue::count(order))},
          {"generation_degree", single(ComputedValue::count(degrees.generation))},
          {"reproduction_degree", single(ComputedValue::count(degrees.reproduction))}};
}

}  // namespace limes::table_impl
