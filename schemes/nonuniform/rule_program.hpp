// What the text of an insertion rule is turned into. Included by the sources of this folder only.
#pragma once

#include "schemes/nonuniform/insertion_rule.hpp"

#include <map>

namespace limes {

/// One segment or point of a rule on the interval i: linear in the points. Arguments have smaller numbers, so that
/// there is no cycle.
struct RuleNode {
  enum class Kind {
    interpolant,  ///< f(degree, offset) in Bezier form; divides by differences of its knots
    sample,       ///< the value of f(interpolant_degree, offset) at u; divides by differences of its knots
    map,          ///< numbers times the coefficients of the arguments; divides by nothing
    join,         ///< join(order, argument); divides by t_{k+1} - t_k and t_{k+1} - t_{k-1}
    again,        ///< again(argument); divides by what its argument divides by, on refined knots
  };
  struct Entry {
    int column;
    int number;
  };

  Kind kind = Kind::map;
  /// A point has one coefficient: degree 0 in one piece.
  bool is_point = false;
  int degree = 0;
  int pieces = 1;
  int interpolant_degree = 0;
  int offset = 0;
  int order = 0;
  Rational u = 0;
  std::vector<int> arguments = {};
  /// map: row by row, sparse, over the concatenated coefficients of the arguments.
  std::vector<std::vector<Entry>> rows = {};
  /// The node depends on the knots and points t_{i+lowest} .. t_{i+highest} only.
  int lowest = 0;
  int highest = 1;
  int height = 1;
  int again_depth = 0;

  int size() const { return pieces * (degree + 1); }
};

/// A rule after reading: every mistake of its author has been found.
struct RuleProgram {
  InsertionRuleText text;
  VariableNames parameters;
  int points = 0;
  /// The numbers of the rule, without repetition: functions of the parameters.
  std::vector<RationalFunction> numbers;
  std::vector<RuleNode> nodes;
  std::map<std::string, int> named;
  int new_point = -1;
  /// Instead of nodes: e_1 .. e_2n as functions of the parameters and the ratios.
  std::vector<RationalFunction> coefficients;
  std::vector<MultivariatePolynomial> coefficient_denominators;
};

/// \throws InputError as the constructors of InsertionRule.
RuleProgram compile_rule(const InsertionRuleText& text, const VariableNames& parameters);
RuleProgram compile_rule(const Expression& new_point, const VariableNames& parameters);

}  // namespace limes
