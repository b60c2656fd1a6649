#include "algebra/error.hpp"
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/subdivision_matrix.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

namespace limes::table_impl {

ComputedResult matrix_values(const TableCommand& command, const Stop&) {
  command.allow({"--param"});
  const Scheme scheme = load_scheme(command.operand());
  if (!scheme.insertion_rule) throw InputError(fmt::format("{} is no non-uniform scheme", scheme.name));
  std::vector<std::string> settings = command.parameters();
  const std::optional<Rational> gamma = take_setting(settings, "gamma");
  if (!gamma || *gamma <= 0) throw InputError("'matrix' in a table needs a positive knot ratio, --param gamma=VALUE");
  const Box region = region_from_settings(scheme, settings);
  if (!is_point(region)) throw InputError("'matrix' in a table needs one value of every parameter");
  std::vector<Rational> point = midpoint(region);
  point.push_back(*gamma);
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*scheme.insertion_rule, region));
  ComputedList modulus, re, im;
  for (const ComplexRoot& root : enclose_complex_roots(characteristic_polynomial(matrix.at(point)))) {
    for (int k = 0; k < root.multiplicity; ++k) {
      modulus.values.push_back({root.modulus, {}});
      re.values.push_back({root.re, {}});
      im.values.push_back({root.im, {}});
    }
  }
  return {{"modulus", modulus}, {"re", re}, {"im", im}, {"size", {0, {ComputedValue::count(matrix.size())}}}};
}

}  // namespace limes::table_impl
