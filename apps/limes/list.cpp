#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"

#include "reports/text_table.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {

int run_list(const ListOptions& options) {
  const Catalogue catalogue = Catalogue::find();
  std::vector<Scheme> schemes;
  for (const std::string& name : catalogue.names()) schemes.push_back(catalogue.load(name));
  if (options.json) {
    std::cout << list_json(schemes);
    return all_as_expected;
  }
  if (options.quiet) {
    for (const Scheme& scheme : schemes) std::cout << scheme.name << "\n";
    return all_as_expected;
  }
  TextTable table({{"scheme"}, {"kind"}, {"claims", 0, TextTable::Align::right}, {"title"}});
  for (const Scheme& scheme : schemes) {
    table.fit(0, scheme.name);
    table.fit(1, to_string(scheme.kind));
  }
  std::cout << table.header();
  for (const Scheme& scheme : schemes) {
    std::cout << table.row({scheme.name, to_string(scheme.kind), fmt::format("{}", scheme.claims.size()), scheme.title});
  }
  return all_as_expected;
}

}  // namespace limes::app
