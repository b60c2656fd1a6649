// Included by sources of this folder only.
#pragma once

#include "algebra/matrix/rational_matrix.hpp"
#include "schemes/nonuniform/rule_definitions.hpp"
#include "schemes/nonuniform/rule_program.hpp"

namespace limes {

/// Appends nodes to a program; checks kinds, degrees and limits. Errors carry the column.
class SegmentCompiler {
 public:
  SegmentCompiler(RuleProgram& program, RuleDefinitions& names) : program_(program), names_(names) {}

  /// The functions of the vocabulary.
  static const VariableNames& vocabulary();
  /// The node of a segment or a point, nothing for a number.
  std::optional<int> compile(const Expression& e);
  /// The node of a rule's new point.
  int new_point(const Expression& e);

 private:
  RationalFunction number_argument(const Expression& e);
  Rational rational_argument(const Expression& e);
  int integer_argument(const Expression& e, int lower, int upper, const std::string& what);
  int segment_argument(const Expression& e, bool in_one_piece = true);

  const RuleNode& node(int number) const { return program_.nodes[std::size_t(number)]; }
  int add(RuleNode made, const Expression& e);
  /// A map from one argument.
  int add_map(int argument, const RationalMatrix& matrix, int degree, int pieces, const Expression& e);
  RationalFunction constant(const Rational& value) const;
  /// Counts entries of matrices. \throws LimitError when they are too many.
  void spend(std::size_t entries, const Expression& e);
  /// The place of a number in the program's list.
  int pooled(const RationalFunction& value);

  int compile_call(const Expression& e, const Expression::Call& call);
  int compile_interpolant(const Expression& e, const Expression::Call& call);
  int compile_hermite(const Expression& e, const Expression::Call& call);
  int compile_degree(const Expression& e, const Expression::Call& call);
  int compile_tension(const Expression& e, const Expression::Call& call);
  int compile_join(const Expression& e, const Expression::Call& call);
  int compile_split(const Expression& e, const Expression::Call& call);
  int compile_at(const Expression& e, const Expression::Call& call);
  int compile_dot(const Expression& e, const Expression::Call& call);
  int compile_again(const Expression& e, const Expression::Call& call);
  int compile_operation(const Expression& e, const Expression::Operation& operation);
  int scaled(int argument, const RationalFunction& factor, const Expression& e);

  RuleProgram& program_;
  RuleDefinitions& names_;
  std::map<std::string, int> pool_;
  std::size_t entries_ = 0;
};

}  // namespace limes
