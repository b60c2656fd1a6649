#pragma once

#include "algebra/expression/bounded_arithmetic.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace limes {

/// The syntax tree of a user's expression. Grammar (blanks are free between tokens):
///
///     expression = term { ("+" | "-") term }
///     term       = factor { ("*" | "/") factor }
///     factor     = ("+" | "-") factor | power
///     power      = primary [ "^" [ "-" ] digits ]
///     primary    = number | name | name "(" [ expression { "," expression } ] ")" | "(" expression ")"
///                | "[" [ expression { "," expression } ] "]"
///     number     = digits [ "." [ digits ] ] [ ("e"|"E") ["+"|"-"] digits ] | "." digits [ exponent ]
///     name       = letter { letter | digit | "_" }
///
/// "^" binds tighter than unary minus (-w^2 = -(w^2)) and takes an integer literal. Decimals are exact.
struct Expression {
  struct Number { Rational value; };
  struct Name { std::string name; };
  /// op is one of + - * / for two operands, '~' for unary minus with one.
  struct Operation { char op; std::vector<Expression> operands; };
  struct Power { std::vector<Expression> base; int exponent; };
  struct Call { std::string function; std::vector<Expression> arguments; };
  struct List { std::vector<Expression> elements; };

  std::variant<Number, Name, Operation, Power, Call, List> node;
  /// 1-based column of the token that made this node (the operator, the name, the bracket).
  int column = 1;
};

/// Limits that keep hostile input from hurting. Exceeding one is a LimitError that names it.
struct ExpressionLimits {
  std::size_t max_length = 100000;
  int max_depth = 100;
  int max_exponent = 1000;
  int max_digits = 10000;
  std::size_t max_nodes = 100000;
};

/// \throws InputError with the column (1-based) and what was expected.
Expression read_expression(std::string_view text, const ExpressionLimits& limits = {});

/// Evaluates an expression without calls and lists as a rational function of the named variables.
/// \param arithmetic shared by the expressions of one input, limits what all of them may cost
/// \throws InputError with the column for an unknown name (the known ones are listed), a call, a list, or a division by zero;
/// LimitError as BoundedArithmetic.
RationalFunction to_rational_function(const Expression& expression, const VariableNames& names, BoundedArithmetic& arithmetic);
/// The same for a single expression.
RationalFunction to_rational_function(const Expression& expression, const VariableNames& names);

/// read_expression, then to_rational_function.
RationalFunction read_rational_function(std::string_view text, const VariableNames& names);

/// Whether a text is a name of the grammar above (and so may name a parameter).
bool is_name(std::string_view text);

}  // namespace limes
