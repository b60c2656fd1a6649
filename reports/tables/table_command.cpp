#include "reports/tables/table_command.hpp"

#include "algebra/error.hpp"
#include "reports/tables/verbs_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace limes {
namespace {

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  bool inside = false;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0 ? c == quote : c == '\'' || c == '"') {
      quote = quote != 0 ? 0 : c;
      if (!inside) result.emplace_back();
      inside = true;
    } else if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      inside = false;
    } else {
      if (!inside) result.emplace_back();
      inside = true;
      result.back() += c;
    }
  }
  if (quote != 0) throw InputError("a quote in the command is not closed");
  return result;
}

}  // namespace

ComputedValue ComputedValue::formula(const RationalFunction& f, const VariableNames& names) {
  if (f.is_constant()) return exact(f.constant_value());
  return {f, names};
}

std::string to_string(const ComputedValue& value) {
  if (const auto* outcome = std::get_if<Outcome>(&value.value)) return to_string(*outcome);
  if (const auto* formula = std::get_if<RationalFunction>(&value.value)) return to_string(*formula, value.names);
  const Interval& number = std::get<Interval>(value.value);
  if (number.is_point()) {
    const std::string exact = to_string(number.lower);
    return exact.size() <= 16 ? exact : to_decimal(number.lower, 12, Rounding::nearest);
  }
  // As many digits as both ends agree to when rounded.
  for (int digits = 12; digits > 1; --digits) {
    const std::string text = to_decimal(number.lower, digits, Rounding::nearest);
    if (text == to_decimal(number.upper, digits, Rounding::nearest)) return text;
  }
  return fmt::format("[{}, {}]", to_decimal(number.lower, 6, Rounding::down), to_decimal(number.upper, 6, Rounding::up));
}

const std::string& TableCommand::operand() const {
  if (operands.size() != 1) throw InputError(fmt::format("'{}' takes one scheme, not {}", verb, operands.size()));
  return operands.front();
}

std::optional<std::string> TableCommand::option(const std::string& name) const {
  const auto place = options.find(name);
  if (place == options.end()) return std::nullopt;
  if (place->second.size() > 1) throw InputError(fmt::format("{} is given twice", name));
  return place->second.front();
}

int TableCommand::integer_option(const std::string& name, int lower, int upper) const {
  const std::optional<std::string> text = option(name);
  if (!text) throw InputError(fmt::format("'{}' needs {}", verb, name));
  int value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc() || end != text->data() + text->size() || value < lower || value > upper) {
    throw InputError(fmt::format("{} {}: expected an integer from {} to {}", name, *text, lower, upper));
  }
  return value;
}

std::vector<std::string> TableCommand::parameters() const {
  const auto place = options.find("--param");
  return place == options.end() ? std::vector<std::string>{} : place->second;
}

void TableCommand::allow(const std::vector<std::string>& names) const {
  for (const auto& [name, values] : options) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw InputError(fmt::format("'{}' in a table takes no {} (but {})", verb, name, fmt::join(names, ", ")));
  }
}

TableCommand read_table_command(std::string_view text) {
  const std::vector<std::string> all = words(text);
  if (all.empty()) throw InputError("the command is empty");
  TableCommand command{.verb = all.front(), .operands = {}, .options = {}};
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (!all[k].starts_with("--")) {
      command.operands.push_back(all[k]);
    } else if (k + 1 == all.size()) {
      throw InputError(fmt::format("{} needs a value", all[k]));
    } else {
      command.options[all[k]].push_back(all[k + 1]);
      ++k;
    }
  }
  return command;
}

const std::vector<TableVerb>& table_verbs() {
  using namespace table_impl;
  static const std::vector<TableVerb> verbs{
      {"derive", derive_values}, {"map", map_values}, {"matrix", matrix_values}, {"norm", norm_values}, {"show", show_values},
      {"spectrum", spectrum_values}, {"verify", verify_values}};
  return verbs;
}

ComputedResult compute(const TableCommand& command, const Stop& stop) {
  std::vector<std::string_view> known;
  for (const TableVerb& verb : table_verbs()) {
    if (verb.name == command.verb) return verb.compute(command, stop);
    known.push_back(verb.name);
  }
  throw InputError(fmt::format("no table can use the verb '{}' (known: {})", command.verb, fmt::join(known, ", ")));
}

}  // namespace limes
