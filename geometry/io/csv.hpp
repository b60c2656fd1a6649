#pragma once

#include "geometry/polygon.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace limes {

/// A table of numbers as a file holds it: the same number of columns in each row.
struct NumberTable {
  int columns = 0;
  /// Row after row.
  std::vector<double> values;
  /// The line of the file, from 1, of each row.
  std::vector<int> lines;
  std::filesystem::path file;

  std::size_t rows() const { return lines.size(); }
};

/// Reads comma-separated numbers, one row a line: decimals or fractions p/q, read exactly and rounded once. Blank lines
/// and lines that start with # are skipped.
/// \throws InputError "file:line: reason": the file cannot be read, something is no number, is nan, infinite or beyond
/// double precision; a row has another number of columns than the first one; there is no row. LimitError: more than 256
/// MiB, 2^22 rows or `max_columns` columns.
NumberTable read_csv_file(const std::filesystem::path& file, int max_columns = 64);
/// The same from a text; `file` only names it in messages.
NumberTable read_csv(std::string_view text, const std::filesystem::path& file, int max_columns = 64);

/// The polygon whose points are the rows.
Polygon polygon_from(const NumberTable& table, bool closed);

/// The table's one column as knots of a polygon. \throws InputError naming the line: more than one column, not strictly
/// increasing, not one knot for each point (and one more, the end of the period, for a closed polygon).
std::vector<double> knots_from(const NumberTable& table, const Polygon& polygon);

/// Points, one a line, in the shortest decimals that read_csv reads back bit by bit.
std::string to_csv(const Polygon& polygon);

}  // namespace limes
