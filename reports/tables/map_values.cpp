#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "proofs/map/map_unions.hpp"
#include "proofs/map/parameter_map.hpp"
#include "reports/tables/verbs_impl.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

namespace limes::table_impl {

ComputedResult map_values(const TableCommand& command, const Stop& stop) {
  command.allow({"--claim", "--param", "--tolerance"});
  const Scheme scheme = load_scheme(command.operand());
  const std::optional<std::string> text = command.option("--claim"), tolerance = command.option("--tolerance");
  if (!text || !tolerance) throw InputError("'map' in a table needs --claim and --tolerance");
  const Claim claim = read_statement(*text);
  if (claim.negated || claim.space || claim.subject != ClaimSubject::limits) throw InputError("'map' is about C<m>");
  const Box region = region_from_settings(scheme, command.parameters());
  int free = 0;
  std::size_t axis = 0;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (!region[k].is_point()) ++free, axis = k;
  }
  if (free != 1) throw InputError("'map' in a table needs an interval of one parameter");
  MapOptions options{.tolerance = read_rational(*tolerance)};
  if (options.tolerance <= 0) throw InputError("--tolerance must be positive");
  const ParameterMap map = map_parameters(scheme, claim.smoothness, region, options, {}, stop);
  if (map.interrupted) throw Interrupted("the map was interrupted");
  ComputedList certified, refuted;
  for (const MapUnion& part : map_unions(map.cells, scheme.parameter_names())) {
    ComputedList* list = part.verdict == Outcome::certified ? &certified : part.verdict == Outcome::refuted ? &refuted : nullptr;
    if (!list) continue;
    list->values.push_back(ComputedValue::exact(part.region[axis].lower));
    list->values.push_back(ComputedValue::exact(part.region[axis].upper));
  }
  return {{"certified", certified}, {"refuted", refuted}, {"unknown_measure", {0, {ComputedValue::exact(map.unknown_measure)}}}};
}

}  // namespace limes::table_impl
