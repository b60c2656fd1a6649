#include "geometry/io/csv.hpp"

#include "algebra/error.hpp"
#include "algebra/text_file.hpp"
#include "algebra/number/read_rational.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace limes {
namespace {

constexpr std::size_t max_file_size = std::size_t{256} << 20;
constexpr std::size_t max_rows = std::size_t{1} << 22;
constexpr std::size_t max_field = 1000;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// nan and inf in all their spellings, so that they get an error of their own.
bool names_no_finite_number(std::string_view text) {
  std::string word(text.substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0));
  for (char& c : word) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return word == "inf" || word == "infinity" || word.starts_with("nan");
}

double read_number(std::string_view field, const SourcePosition& where) {
  const std::string shown(field.substr(0, 40));
  if (field.empty()) throw InputError("a number is missing", where);
  if (names_no_finite_number(field)) throw InputError(fmt::format("'{}' is not a finite number", shown), where);
  if (field.size() > max_field) throw LimitError(fmt::format("a number of more than {} characters", max_field), where);
  // Plain decimals, ties to even as they were printed; all else, errors too, is the exact reader's.
  double value = 0;
  const auto [end, error_code] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error_code == std::errc() && end == field.data() + field.size()) return value;
  try {
    value = approx_double(read_rational(field));
  } catch (const LimitError& error) {
    throw LimitError(fmt::format("'{}': {}", shown, error.reason()), where);
  } catch (const InputError&) {
    throw InputError(fmt::format("'{}' is not a number (comments start with #)", shown), where);
  }
  if (!std::isfinite(value)) throw InputError(fmt::format("'{}' exceeds the range of double precision", shown), where);
  return value;
}

/// The numbers of one line, appended to the table.
void read_row(std::string_view line, int number, int max_columns, NumberTable& table) {
  const std::string name = table.file.string();
  int columns = 0;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    if (columns == max_columns) throw LimitError(fmt::format("more than {} columns", max_columns), {name, number, 0});
    const int column = static_cast<int>(begin) + 1;
    table.values.push_back(read_number(trimmed(line.substr(begin, end - begin)), {name, number, column}));
    ++columns;
    if (end == line.size()) break;
    begin = end + 1;
  }
  if (table.rows() == 0) table.columns = columns;
  if (columns != table.columns) {
    throw InputError(fmt::format("{} columns, but line {} has {}", columns, table.lines.front(), table.columns),
                     {name, number, 0});
  }
  if (table.rows() == max_rows) throw LimitError(fmt::format("more than {} rows", max_rows), {name, number, 0});
  table.lines.push_back(number);
}

}  // namespace

NumberTable read_csv(std::string_view text, const std::filesystem::path& file, int max_columns) {
  NumberTable table{0, {}, {}, file};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const std::string_view content = trimmed(line);
    if (!content.empty() && content.front() != '#') read_row(line, number, max_columns, table);
  }
  if (table.rows() == 0) throw InputError("the file has no numbers", {file.string(), 0, 0});
  return table;
}

NumberTable read_csv_file(const std::filesystem::path& file, int max_columns) {
  return read_csv(read_text_file(file, max_file_size), file, max_columns);
}

Polygon polygon_from(const NumberTable& table, bool closed) { return {table.columns, table.values, closed}; }

std::vector<double> knots_from(const NumberTable& table, const Polygon& polygon) {
  const std::string name = table.file.string();
  if (table.columns != 1)
    throw InputError(fmt::format("{} columns, but knots are one number a line", table.columns),
                     {name, table.lines.front(), 0});
  for (std::size_t i = 1; i < table.rows(); ++i) {
    if (table.values[i - 1] < table.values[i]) continue;
    throw InputError(
        fmt::format("knots must increase strictly, but {} follows {}", table.values[i], table.values[i - 1]),
        {name, table.lines[i], 0});
  }
  const std::size_t expected = polygon.size() + (polygon.closed() ? 1 : 0);
  if (table.rows() != expected) {
    throw InputError(fmt::format("{} knots, but the {} polygon of {} points needs {}{}", table.rows(),
                                 polygon.closed() ? "closed" : "open", polygon.size(), expected,
                                 polygon.closed() ? " (the last one ends the period)" : ""),
                     {name, 0, 0});
  }
  return table.values;
}

std::string to_csv(const Polygon& polygon) {
  fmt::memory_buffer text;
  const auto d = static_cast<std::size_t>(polygon.dimension());
  const std::vector<double>& x = polygon.coordinates();
  for (std::size_t k = 0; k < x.size(); ++k) {
    // + 0.0 turns -0 into 0.
    fmt::format_to(std::back_inserter(text), "{}{}", x[k] + 0.0, (k + 1) % d == 0 ? '\n' : ',');
  }
  return fmt::to_string(text);
}

}  // namespace limes
