// The verb by which tables speak of masks derived from weight functions.
#include "algebra/error.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/unity/derive_mask.hpp"
#include "schemes/unity/weight_problem.hpp"

#include <fmt/format.h>

namespace limes::table_impl {

ComputedResult derive_values(const TableCommand& command, const Stop& stop) {
  command.allow({"--weight", "--domain", "--shifts", "--constraint", "--samples", "--precision", "--method", "--decimals", "--round"});
  if (!command.operands.empty()) throw InputError("'derive' takes its weight function by --weight");
  const std::optional<std::string> weight = command.option("--weight");
  if (!weight) throw InputError("'derive' needs --weight");
  WeightProblem problem{.function = *weight};
  problem.domain = command.option("--domain").value_or("");
  problem.shifts = command.option("--shifts").value_or("");
  if (const auto place = command.options.find("--constraint"); place != command.options.end()) problem.constraints = place->second;
  if (command.option("--samples")) problem.samples = command.integer_option("--samples", 2, max_samples);
  if (command.option("--precision")) problem.precision = command.integer_option("--precision", 53, max_precision);
  if (command.option("--decimals")) problem.decimals = command.integer_option("--decimals", 1, 1000);
  const std::string method = command.option("--method").value_or("samples");
  if (method != "samples" && method != "integrals") throw InputError(fmt::format("--method {}: expected samples or integrals", method));
  problem.integrals = method == "integrals";

  const DerivedMask derived = derive_mask(problem, stop);
  std::vector<Rational> mask = derived.mask;
  if (const auto rounding = command.option("--round")) mask = rounded_mask(mask, *rounding);
  ComputedList coefficients{derived.equation.first_index(), {}};
  Rational sums[2];
  for (std::size_t k = 0; k < mask.size(); ++k) {
    coefficients.values.push_back(ComputedValue::exact(mask[k]));
    sums[(static_cast<unsigned>(derived.equation.first_index()) + k) % 2] += mask[k];
  }
  const auto single = [](const Rational& x) { return ComputedList{0, {ComputedValue::exact(x)}}; };
  return {{"mask", coefficients},
          {"error", single(Rational(derived.error_of(mask)))},
          {"even_sum", single(sums[0])},
          {"odd_sum", single(sums[1])},
          {"condition", single(Rational(derived.condition))}};
}

}  // namespace limes::table_impl
