// The names of an insertion rule: numbers, segments and points, resolved by dependency. Included by sources of this
// folder only.
#pragma once

#include "algebra/error.hpp"
#include "algebra/expression/bounded_arithmetic.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace limes {

class RuleDefinitions {
 public:
  /// Makes the node of an expression that is no number.
  using Compile = std::function<int(const Expression&)>;

  /// number_names: the parameters, for rules given by coefficients also the ratios. `reserved` may not be defined.
  RuleDefinitions(VariableNames number_names, VariableNames reserved, Compile compile)
      : number_names_(std::move(number_names)), reserved_(std::move(reserved)), compile_(std::move(compile)) {}

  /// \throws InputError when the name is taken or no name.
  void define(const std::string& name, const InsertionRuleText::Line& value);
  /// Compiles every definition. \throws InputError for a cycle, naming it, and for every mistake in a definition.
  void resolve_all();
  /// The nodes of the segments and points, after resolve_all().
  std::map<std::string, int> nodes() const;

  /// Whether an expression means a number. \throws InputError for an unknown name.
  bool is_number(const Expression& e);
  /// The value of a number. \throws InputError, LimitError as to_rational_function.
  RationalFunction number(const Expression& e);
  /// What the numbers of this rule may cost together.
  BoundedArithmetic& arithmetic() { return arithmetic_; }
  /// The node of a name that is no number.
  int node(const Expression& e, const std::string& name);

  /// Runs a reader of one text; its errors come to carry the name and the line, once.
  template <class Read>
  auto blamed(const std::string& name, const InsertionRuleText::Line& text, Read read) {
    try {
      return read();
    } catch (const LimitError& error) {
      if (std::exchange(blamed_, true)) throw;
      throw LimitError(fmt::format("{}: {}", name, error.located("", 0).reason()), {"", text.line, 0});
    } catch (const InputError& error) {
      if (std::exchange(blamed_, true)) throw;
      throw InputError(fmt::format("{}: {}", name, error.located("", 0).reason()), {"", text.line, 0});
    }
  }

 private:
  enum class State { waiting, open, resolved };
  struct Definition {
    InsertionRuleText::Line text;
    Expression expression;
    /// A number, as an expression without defined names.
    std::optional<Expression> number;
    State state = State::waiting;
    /// Names in the expression; those that are resolved are taken away.
    std::vector<std::string> waits_for;
    int node = -1;
  };

  /// Compiles a definition and what it needs. \throws InputError for a cycle
  void resolve(const std::string& name);
  void compile(Definition& definition);
  bool is_resolved(const std::string& name) const;
  /// The definition of a name, resolved; null for a parameter or a ratio.
  const Definition* find(const Expression& e, const std::string& name);
  Expression inlined(const Expression& e, std::size_t& budget, int height);

  VariableNames number_names_;
  VariableNames reserved_;
  Compile compile_;
  std::map<std::string, Definition> definitions_;
  BoundedArithmetic arithmetic_;
  bool blamed_ = false;
};

}  // namespace limes
