#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/rational_function.hpp"
#include "algebra/stop.hpp"
#include "schemes/claim.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace limes {

/// A value that a command computes: a verdict; a real number, enclosed (a point when it is exact); or a formula in parameters.
struct ComputedValue {
  std::variant<Outcome, Interval, RationalFunction> value;
  /// Of the formula's parameters.
  VariableNames names;

  static ComputedValue exact(const Rational& x) { return {Interval::point(x), {}}; }
  static ComputedValue count(int n) { return exact(Rational(n)); }
  /// A number when the function is constant.
  static ComputedValue formula(const RationalFunction& f, const VariableNames& names);
};

/// "certified", "3/4", "0.409735123456" (so many digits are right), "[0.19, 0.21]", "-3*w - 1/16".
std::string to_string(const ComputedValue& value);

/// Values that belong together, numbered from `first_index`.
struct ComputedList {
  int first_index = 0;
  std::vector<ComputedValue> values;
};

/// All that a command computes, by name; the first one is its main value.
using ComputedResult = std::vector<std::pair<std::string, ComputedList>>;

/// A verb of the command line with its arguments, taken apart.
struct TableCommand {
  std::string verb;
  std::vector<std::string> operands;
  /// "--param" -> {"w=1/16", ..}
  std::map<std::string, std::vector<std::string>> options;

  /// The one operand. \throws InputError
  const std::string& operand() const;
  /// The option's value, if it is given. \throws InputError when it is given more than once
  std::optional<std::string> option(const std::string& name) const;
  int integer_option(const std::string& name, int lower, int upper) const;
  std::vector<std::string> parameters() const;
  /// \throws InputError for options that are not in the list
  void allow(const std::vector<std::string>& names) const;
};

/// Words are separated by blanks; '..' and ".." keep blanks inside. Options take one value. \throws InputError
TableCommand read_table_command(std::string_view text);

/// Computes what a command says with the library, not with a shell: a verb's entry in the list of verbs (docs/published-tables.md).
/// \throws InputError for an unknown verb or wrong arguments; Interrupted.
ComputedResult compute(const TableCommand& command, const Stop& stop);

/// The verbs that tables can use. To add one: a source of its own with the function, and a line in table_command.cpp.
struct TableVerb {
  std::string_view name;
  ComputedResult (*compute)(const TableCommand&, const Stop&);
};
const std::vector<TableVerb>& table_verbs();

}  // namespace limes
