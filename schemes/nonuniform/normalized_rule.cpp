#include "schemes/nonuniform/normalized_rule.hpp"

#include "schemes/nonuniform/rule_definitions.hpp"
#include "schemes/nonuniform/segment_compiler.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace limes {
namespace {

std::string to_text(const RationalFunction& number, const VariableNames& names) {
  const std::string numerator = to_string(number.numerator(), names);
  return number.is_polynomial() ? numerator : fmt::format("({})/({})", numerator, to_string(number.denominator(), names));
}

class Printer {
 public:
  Printer(RuleDefinitions& names, const VariableNames& parameters) : names_(names), parameters_(parameters) {}

  std::string expression(const Expression& e) {
    if (names_.is_number(e)) return to_text(names_.number(e), parameters_);
    if (const auto* name = std::get_if<Expression::Name>(&e.node)) return name->name;
    if (const auto* call = std::get_if<Expression::Call>(&e.node)) {
      return fmt::format("{}({})", call->function, list(call->arguments));
    }
    if (const auto* entries = std::get_if<Expression::List>(&e.node)) return fmt::format("[{}]", list(entries->elements));
    const auto& [op, operands] = std::get<Expression::Operation>(e.node);
    if (op == '~') return "-" + operand(operands[0], 2);
    const int level = op == '+' || op == '-' ? 0 : 1;
    return operand(operands[0], level) + (level == 0 ? fmt::format(" {} ", op) : std::string(1, op)) +
           operand(operands[1], level + 1);
  }

 private:
  /// In parentheses when it binds less than `level`: 0 sums, 1 products, 2 the rest. Numbers that are no natural numbers
  /// count as sums, signs too.
  std::string operand(const Expression& e, int level) {
    const std::string text = expression(e);
    int own = 2;
    if (names_.is_number(e)) {
      own = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }) ? 2 : 0;
    } else if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) {
      own = operation->op == '*' || operation->op == '/' ? 1 : 0;
    }
    return own < level ? "(" + text + ")" : text;
  }
  std::string list(const std::vector<Expression>& elements) {
    std::vector<std::string> texts;
    for (const Expression& element : elements) texts.push_back(expression(element));
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  RuleDefinitions& names_;
  const VariableNames& parameters_;
};

}  // namespace

InsertionRuleText normalized_text(const InsertionRule& rule) {
  const InsertionRuleText& text = rule.text();
  const VariableNames& parameters = rule.parameter_names();
  InsertionRuleText result;
  result.points = rule.points();
  if (!text.coefficients.empty()) {
    VariableNames names = parameters;
    for (const std::string& ratio : ratio_names(rule.points())) names.push_back(ratio);
    for (const RationalFunction& e : rule.symbolic_stencil()) result.coefficients.push_back({to_text(e, names), 0});
    return result;
  }
  RuleDefinitions names(parameters, SegmentCompiler::vocabulary(), [](const Expression&) { return 0; });
  for (const auto& definition : text.let) names.define(definition.name, definition.value);
  names.resolve_all();
  Printer print(names, parameters);
  for (const auto& definition : text.let) {
    const Expression value = read_expression(definition.value.text);
    if (!names.is_number(value)) result.let.push_back({definition.name, {print.expression(value), 0}});
  }
  result.new_point.text = print.expression(read_expression(text.new_point.text));
  return result;
}

}  // namespace limes
