#include "reports/tables/compare_table.hpp"

#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"
#include "algebra/number/read_rational.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace limes {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// "-3w - 1/16" -> "-3*w - 1/16"
std::string with_products(const std::string& text) {
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (k > 0 && is_digit(text[k - 1]) && is_letter(text[k])) result += '*';
    result += text[k];
  }
  return result;
}

/// A printed decimal: its value, the exponent of its last digit, and how many digits count.
struct Decimal {
  Rational value;
  int last_exponent = 0;
  int digits = 0;
};

/// "0.0141", "-3.74e-5", "12"; nothing for another text. \throws InputError from the reader, for an absurd exponent
std::optional<Decimal> read_decimal(const std::string& text) {
  if (text.empty() || text.find('/') != std::string::npos || text.find_first_not_of("0123456789.eE+-") != std::string::npos) return std::nullopt;
  Decimal decimal{read_rational(text), 0, 0};
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  if (e < text.size()) decimal.last_exponent = std::stoi(text.substr(e + 1));
  bool after_point = false, leading = true;
  for (const char c : text.substr(0, e)) {
    if (c == '.') after_point = true;
    if (!is_digit(c)) continue;
    if (c != '0') leading = false;
    if (!leading) ++decimal.digits;
    if (after_point) --decimal.last_exponent;
  }
  return decimal;
}

Rational power_of_ten(int exponent) { return power(Rational(10), exponent); }

/// Greatest distance of the printed value from a number in the enclosure.
Rational greatest_gap(const Rational& printed, const Interval& number) {
  return std::max(abs(printed - number.lower), abs(printed - number.upper));
}

Agreement compare_decimal(const Decimal& printed, const Interval& number) {
  Agreement result;
  const Rational gap = greatest_gap(printed.value, number);
  const bool integer = printed.last_exponent >= 0 && denominator(printed.value) == 1;
  if (integer && number.is_point()) return {gap == 0, std::nullopt, 0};
  int last = printed.last_exponent, digits = printed.digits;
  if (integer) last -= 6, digits += 6;
  result.printed_digits = std::max(digits, 1);
  result.agrees = gap < power_of_ten(last);
  int agreeing = result.printed_digits;
  for (int exponent = last; agreeing > 0 && gap >= power_of_ten(exponent); ++exponent) --agreeing;
  result.digits = agreeing;
  return result;
}

std::optional<Agreement> compare_inequality(const std::string& printed, const Interval& number) {
  for (const std::string relation : {"<=", ">=", "<", ">"}) {
    if (!printed.starts_with(relation)) continue;
    const Rational bound = read_rational(trimmed(printed.substr(relation.size())));
    const bool holds = relation == "<=" ? number.upper <= bound
                       : relation == "<" ? number.upper < bound
                       : relation == ">=" ? number.lower >= bound
                                          : number.lower > bound;
    return Agreement{holds, std::nullopt, 0};
  }
  return std::nullopt;
}

/// "mask[-3]" -> {"mask", -3}
std::pair<std::string, std::optional<int>> read_pick(const std::string& pick) {
  const std::size_t bracket = pick.find('[');
  if (bracket == std::string::npos) return {pick, std::nullopt};
  int index = 0;
  const char* begin = pick.data() + bracket + 1;
  const char* end = pick.data() + pick.size() - 1;
  const auto [stopped, error] = std::from_chars(begin, end, index);
  if (pick.back() != ']' || error != std::errc() || stopped != end) throw InputError(fmt::format("pick '{}': expected NAME[INDEX]", pick));
  return {pick.substr(0, bracket), index};
}

const ComputedValue& picked(const ComputedResult& result, const PublishedValue& value) {
  const auto [name, index] = read_pick(value.pick);
  const ComputedList* list = name.empty() ? &result.front().second : nullptr;
  std::string known;
  for (const auto& [key, values] : result) {
    if (key == name) list = &values;
    known += (known.empty() ? "" : ", ") + key;
  }
  if (!list) throw InputError(fmt::format("the command computes no '{}' (but {})", name, known));
  const int count = static_cast<int>(list->values.size());
  if (!index && value.place < 0 && count != 1) {
    throw InputError(fmt::format("the command computes {} values: pick one, NAME[{}] to NAME[{}]", count, list->first_index,
                                 list->first_index + count - 1));
  }
  const int place = index ? *index - list->first_index : std::max(value.place, 0);
  if (place < 0 || place >= count) {
    throw InputError(fmt::format("value {} does not exist: the command computes {} from index {} on", index ? *index : place, count,
                                 list->first_index));
  }
  return list->values[static_cast<std::size_t>(place)];
}

TableRow compare_value(const PublishedValue& value, const ComputedValue& computed, const std::string& erratum) {
  TableRow row{.entry = value.label, .published = value.published, .computed = to_string(computed),
               .agreement = compare_with_printed(value.published, computed), .status = RowStatus::match, .reason = {}};
  const bool as_stored = value.computed.empty() || value.computed == row.computed || compare_with_printed(value.computed, computed).agrees;
  if (!as_stored) {
    row.status = RowStatus::regression;
    row.reason = fmt::format("the stored value is {}", value.computed);
  } else if (row.agreement.agrees) {
    row.status = RowStatus::match;
  } else if (!value.computed.empty() && !erratum.empty()) {
    row.status = RowStatus::erratum;
    row.reason = erratum;
  } else {
    row.status = RowStatus::regression;
    row.reason = erratum.empty() ? "differs from the published value, and no erratum says why"
                                 : "differs from the published value, and no computed value is stored beside the erratum";
  }
  return row;
}

}  // namespace

std::string to_string(RowStatus status) {
  return status == RowStatus::match ? "match" : status == RowStatus::erratum ? "erratum" : "regression";
}

Agreement compare_with_printed(const std::string& text, const ComputedValue& computed) {
  const std::string printed = trimmed(text);
  if (const auto* outcome = std::get_if<Outcome>(&computed.value)) {
    for (const Outcome word : {Outcome::certified, Outcome::refuted, Outcome::undecided}) {
      if (printed == to_string(word)) return {*outcome == word, std::nullopt, 0};
    }
    return {*outcome == Outcome::certified, std::nullopt, 0};
  }
  if (const auto* formula = std::get_if<RationalFunction>(&computed.value)) {
    return {read_rational_function(with_products(printed), computed.names) == *formula, std::nullopt, 0};
  }
  const Interval& number = std::get<Interval>(computed.value);
  if (const auto inequality = compare_inequality(printed, number)) return *inequality;
  if (const auto decimal = read_decimal(printed)) return compare_decimal(*decimal, number);
  return {number.is_point() && read_rational_function(with_products(printed), {}).constant_value() == number.lower, std::nullopt, 0};
}

ComparedTable compare_table(const PublishedTable& table, const Stop& stop, const std::function<void(const TableRow&)>& on_row) {
  ComparedTable result{.name = table.name, .title = table.title, .source = table.source, .rows = {}};
  // Entries may share a command.
  std::map<std::string, ComputedResult> known;
  for (const PublishedEntry& entry : table.entries) {
    try {
      if (!known.contains(entry.command)) known.emplace(entry.command, compute(read_table_command(entry.command), stop));
      for (const PublishedValue& value : entry.values) {
        result.rows.push_back(compare_value(value, picked(known.at(entry.command), value), entry.erratum));
        if (on_row) on_row(result.rows.back());
      }
    } catch (const Interrupted&) {
      result.interrupted = true;
      return result;
    } catch (const InputError& error) {
      // What has a file of its own is about a scheme.
      if (!error.position().file.empty()) throw;
      throw error.located(table.file.string(), entry.line);
    } catch (const DomainError& error) {
      throw InputError(error.what(), {table.file.string(), entry.line, 0});
    }
  }
  return result;
}

}  // namespace limes
