#include "schemes/nonuniform/rule_definitions.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace limes {
namespace {

constexpr std::size_t max_number_nodes = 100000;
constexpr int max_number_height = 1000;

[[noreturn]] void fail(const Expression& where, const std::string& reason) {
  throw InputError(reason, {.file = "", .line = 0, .column = where.column});
}

bool contains(const VariableNames& names, const std::string& name) {
  return std::count(names.begin(), names.end(), name) > 0;
}

void append_names(const Expression& e, std::vector<std::string>& names) {
  const auto all = [&](const std::vector<Expression>& parts) {
    for (const Expression& part : parts) append_names(part, names);
  };
  if (const auto* name = std::get_if<Expression::Name>(&e.node)) names.push_back(name->name);
  if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) all(operation->operands);
  if (const auto* power = std::get_if<Expression::Power>(&e.node)) all(power->base);
  if (const auto* call = std::get_if<Expression::Call>(&e.node)) all(call->arguments);
  if (const auto* list = std::get_if<Expression::List>(&e.node)) all(list->elements);
}

}  // namespace

void RuleDefinitions::define(const std::string& name, const InsertionRuleText::Line& value) {
  blamed(name, value, [&] {
    if (!limes::is_name(name)) throw InputError(fmt::format("'{}' is no name", name));
    if (contains(number_names_, name)) throw InputError(fmt::format("'{}' names a parameter or a ratio already", name));
    if (contains(reserved_, name)) throw InputError(fmt::format("'{}' is a function of the vocabulary", name));
    if (!definitions_.emplace(name, Definition{.text = value, .expression = read_expression(value.text), .number = {}, .waits_for = {}}).second) {
      throw InputError(fmt::format("'{}' is defined twice", name));
    }
  });
}

void RuleDefinitions::resolve_all() {
  for (const auto& [name, definition] : definitions_) resolve(name);
}

std::map<std::string, int> RuleDefinitions::nodes() const {
  std::map<std::string, int> result;
  for (const auto& [name, definition] : definitions_) {
    if (definition.node >= 0) result.emplace(name, definition.node);
  }
  return result;
}

void RuleDefinitions::resolve(const std::string& first) {
  std::vector<std::string> path{first};  // each waits for the next one: a loop, for a chain of definitions may be long
  while (!path.empty()) {
    const std::string name = path.back();
    Definition& definition = definitions_.at(name);
    if (definition.state == State::waiting) {
      definition.state = State::open;
      append_names(definition.expression, definition.waits_for);
    }
    while (!definition.waits_for.empty() && is_resolved(definition.waits_for.back())) definition.waits_for.pop_back();
    if (definition.state == State::resolved) {
      path.pop_back();
    } else if (definition.waits_for.empty()) {
      blamed(name, definition.text, [&] { compile(definition); });
      definition.state = State::resolved;
    } else {
      const std::string next = definition.waits_for.back();
      blamed(next, definitions_.at(next).text, [&] {
        const auto begin = std::find(path.begin(), path.end(), next);
        if (begin != path.end()) throw InputError(fmt::format("the definitions form a cycle: {} -> {}", fmt::join(begin, path.end(), " -> "), next));
      });
      path.push_back(next);
    }
  }
}

void RuleDefinitions::compile(Definition& definition) {
  if (is_number(definition.expression)) {
    std::size_t budget = max_number_nodes;
    definition.number = inlined(definition.expression, budget, 1);
    to_rational_function(*definition.number, number_names_, arithmetic_);
  } else {
    definition.node = compile_(definition.expression);
  }
}

bool RuleDefinitions::is_resolved(const std::string& name) const {
  const auto found = definitions_.find(name);
  return found == definitions_.end() || found->second.state == State::resolved;
}

bool RuleDefinitions::is_number(const Expression& e) {
  const auto all = [this](const std::vector<Expression>& parts) {
    return std::all_of(parts.begin(), parts.end(), [this](const Expression& part) { return is_number(part); });
  };
  if (std::holds_alternative<Expression::Number>(e.node)) return true;
  if (const auto* name = std::get_if<Expression::Name>(&e.node)) {
    const Definition* definition = find(e, name->name);
    return !definition || definition->number;
  }
  if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) return all(operation->operands);
  if (const auto* power = std::get_if<Expression::Power>(&e.node)) return all(power->base);
  return false;
}

RationalFunction RuleDefinitions::number(const Expression& e) {
  std::size_t budget = max_number_nodes;
  return to_rational_function(inlined(e, budget, 1), number_names_, arithmetic_);
}

int RuleDefinitions::node(const Expression& e, const std::string& name) { return find(e, name)->node; }

const RuleDefinitions::Definition* RuleDefinitions::find(const Expression& e, const std::string& name) {
  if (contains(number_names_, name)) return nullptr;
  const auto found = definitions_.find(name);
  if (found == definitions_.end()) {
    VariableNames known = number_names_;
    for (const auto& [other, definition] : definitions_) known.push_back(other);
    fail(e, known.empty() ? fmt::format("unknown name '{}' (no names are known here)", name)
                          : fmt::format("unknown name '{}' (known: {})", name, fmt::join(known, ", ")));
  }
  if (found->second.state != State::resolved) resolve(name);
  return &found->second;
}

// The definitions are put in for their names, so that the limits of to_rational_function hold for all of a number.
Expression RuleDefinitions::inlined(const Expression& e, std::size_t& budget, int height) {
  if (budget-- == 0 || height > max_number_height) {
    throw LimitError("the definitions make a number too large", {.file = "", .line = 0, .column = e.column});
  }
  const auto all = [&](const std::vector<Expression>& parts) {
    std::vector<Expression> result;
    for (const Expression& part : parts) result.push_back(inlined(part, budget, height + 1));
    return result;
  };
  if (const auto* name = std::get_if<Expression::Name>(&e.node)) {
    const Definition* definition = find(e, name->name);
    if (!definition) return e;
    if (!definition->number) fail(e, fmt::format("'{}' is no number", name->name));
    return inlined(*definition->number, budget, height + 1);
  }
  if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) {
    return {Expression::Operation{operation->op, all(operation->operands)}, e.column};
  }
  if (const auto* power = std::get_if<Expression::Power>(&e.node)) {
    return {Expression::Power{all(power->base), power->exponent}, e.column};
  }
  return e;
}

}  // namespace limes
