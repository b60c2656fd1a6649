#pragma once

#include "reports/tables/published_table.hpp"
#include "reports/tables/table_command.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limes {

/// match: the published value agrees with the computed one to its last digit. erratum: it does not, and the file says why.
/// regression: the computed value is not the stored one any more, or differs from the published one without an explanation.
enum class RowStatus { match, erratum, regression };

std::string to_string(RowStatus status);

/// How a printed value compares with a computed one.
struct Agreement {
  bool agrees = false;
  /// Decimals: leading digits that agree, of so many printed.
  std::optional<int> digits;
  int printed_digits = 0;
};

/// - a verdict agrees when it is the printed word, or certified when something else is printed (the claim itself);
/// - a printed fraction or formula agrees when it is the same number or function ("-3w - 1/16" may lack its product signs);
/// - a printed decimal agrees when it differs from the number by less than one unit of its last digit, so that rounding and truncation
///   both pass; an integer counts as exact, or, against a number that is only enclosed, as printed with six decimals;
/// - "< x", "<= x", "> x", ">= x" agree when the number satisfies it.
/// \throws InputError when the printed text is nothing of this.
Agreement compare_with_printed(const std::string& printed, const ComputedValue& computed);

struct TableRow {
  std::string entry, published, computed;
  Agreement agreement;
  RowStatus status = RowStatus::match;
  std::string reason;
};

struct ComparedTable {
  std::string name, title, source;
  std::vector<TableRow> rows;
  /// The work was stopped, and the last rows are missing.
  bool interrupted = false;
};

/// Computes a table, row by row. \param on_row is called after each row, if set. \throws InputError with file and line
ComparedTable compare_table(const PublishedTable& table, const Stop& stop, const std::function<void(const TableRow&)>& on_row = {});

}  // namespace limes
