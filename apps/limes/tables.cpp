#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "reports/text_table.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

std::string digits_text(const Agreement& agreement) {
  if (agreement.digits) return fmt::format("{}/{}", *agreement.digits, agreement.printed_digits);
  return agreement.agrees ? "exact" : "-";
}

TextTable text_table(const PublishedTable& table) {
  TextTable text({{"entry"}, {"published"}, {"computed", 14}, {"digits"}, {"verdict"}});
  for (const PublishedEntry& entry : table.entries) {
    for (const PublishedValue& value : entry.values) {
      text.fit(0, value.label);
      text.fit(1, value.published);
      text.fit(2, value.computed.empty() ? value.published : value.computed);
    }
  }
  return text;
}

/// Compares one table and prints its rows as they are found.
ComparedTable compare_and_print(const PublishedTable& table, const TablesOptions& options, const Stop& stop) {
  if (options.json) return compare_table(table, stop);
  const TextTable text = text_table(table);
  if (!options.quiet) std::cout << fmt::format("{}: {} [{}]\n{}", table.name, table.title, table.source, text.header());
  const bool colour = colour_on_stdout();
  return compare_table(table, stop, [&](const TableRow& row) {
    const bool regression = row.status == RowStatus::regression;
    if (options.quiet && !regression) return;
    std::string line = text.row({row.entry, row.published, row.computed, digits_text(row.agreement), regression ? "REGRESSION" : to_string(row.status)});
    if (regression && colour) line = "\x1b[31m" + line.substr(0, line.size() - 1) + "\x1b[0m\n";
    std::cout << line;
    if (!row.reason.empty()) std::cout << "    " << row.reason << "\n";
    std::cout.flush();
  });
}

std::vector<PublishedTable> load(const std::vector<std::string>& names) {
  if (names.empty()) return load_published_tables(published_directory().string());
  std::vector<PublishedTable> tables;
  for (const std::string& name : names) {
    for (PublishedTable& table : load_published_tables(name)) tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace

int run_tables(const TablesOptions& options) {
  const Session session(options);
  std::vector<ComparedTable> compared;
  int counts[3] = {0, 0, 0};
  bool interrupted = false;
  for (const PublishedTable& table : load(options.tables)) {
    if (interrupted) break;
    compared.push_back(compare_and_print(table, options, session.stop()));
    interrupted = compared.back().interrupted;
    for (const TableRow& row : compared.back().rows) ++counts[static_cast<int>(row.status)];
    if (!options.json && !options.quiet) std::cout << "\n";
  }
  const int regressions = counts[static_cast<int>(RowStatus::regression)];
  if (options.json) {
    std::cout << tables_json(compared);
  } else if (!options.quiet || regressions > 0 || interrupted) {
    std::cout << fmt::format("{} values: match {}, errata {}, regressions {}{}\n", counts[0] + counts[1] + counts[2], counts[0], counts[1],
                             regressions, interrupted ? "; stopped before the end" : "");
  }
  return regressions > 0 ? against_expectation : interrupted ? undecided_or_interrupted : all_as_expected;
}

}  // namespace limes::app
