#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {

int run_norm(const NormOptions& options) {
  const Session session(options);
  const Scheme scheme = load_scheme(options.scheme);
  require_one_mask(scheme, "norm");
  const Mask mask = at(scheme.mask, point_from_settings(scheme, options.parameters, "the norm needs"));
  const std::optional<LaurentPolynomial> b = difference_symbol(mask, options.order + 1);
  if (!b) {
    throw InputError(fmt::format("the symbol of {} has no factor sigma^{} here: its sum rules have order {}", scheme.name,
                                 options.order + 1, sum_rule_order(mask)));
  }
  const Rational norm = exact_contractivity_norm(*b, mask.arity, options.level, session.stop());
  if (options.json) {
    std::cout << norm_json(norm, options.order, options.level);
  } else if (options.quiet) {
    std::cout << to_string(norm) << "\n";
  } else {
    std::cout << fmt::format("||S_b^{}|| = {}\n", options.level, to_string(norm));
    std::cout << fmt::format("{} {} ({} 1)\n", denominator(norm) == 1 ? "=" : "<=", to_decimal(norm, 12, Rounding::up),
                             norm < 1 ? "below" : "not below");
  }
  return all_as_expected;
}

}  // namespace limes::app
