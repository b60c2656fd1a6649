#include "algebra/expression/expression.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace limes {

namespace {

class Evaluator {
 public:
  Evaluator(const VariableNames& names, BoundedArithmetic& arithmetic)
      : names_(names), variables_(int(names.size())), arithmetic_(arithmetic) {}

  RationalFunction operator()(const Expression& expression) {
    return std::visit([&](const auto& node) { return evaluate(node, expression.column); }, expression.node);
  }

 private:
  RationalFunction evaluate(const Expression::Number& node, int) {
    return RationalFunction::constant(variables_, node.value);
  }

  RationalFunction evaluate(const Expression::Name& node, int column) {
    const auto found = std::find(names_.begin(), names_.end(), node.name);
    if (found == names_.end()) {
      fail(names_.empty() ? fmt::format("unknown name '{}' (no names are known here)", node.name)
                          : fmt::format("unknown name '{}' (known: {})", node.name, fmt::join(names_, ", ")),
           column);
    }
    return RationalFunction::variable(variables_, int(found - names_.begin()));
  }

  RationalFunction evaluate(const Expression::Call& node, int column) {
    fail(fmt::format("a function such as '{}' is not allowed here", node.function), column);
  }

  RationalFunction evaluate(const Expression::List&, int column) { fail("a list is not allowed here", column); }

  RationalFunction evaluate(const Expression::Operation& node, int column) {
    const RationalFunction a = (*this)(node.operands.front());
    if (node.op == '~') return -a;
    return arithmetic_.apply(node.op, a, (*this)(node.operands.back()), column);
  }

  RationalFunction evaluate(const Expression::Power& node, int column) {
    return arithmetic_.power((*this)(node.base.front()), node.exponent, column);
  }

  [[noreturn]] static void fail(const std::string& reason, int column) { throw InputError(reason, {"", 0, column}); }

  const VariableNames& names_;
  int variables_;
  BoundedArithmetic& arithmetic_;
};

}  // namespace

RationalFunction to_rational_function(const Expression& expression, const VariableNames& names, BoundedArithmetic& arithmetic) {
  return Evaluator(names, arithmetic)(expression);
}

RationalFunction to_rational_function(const Expression& expression, const VariableNames& names) {
  BoundedArithmetic arithmetic;
  return to_rational_function(expression, names, arithmetic);
}

RationalFunction read_rational_function(std::string_view text, const VariableNames& names) {
  return to_rational_function(read_expression(text), names);
}

}  // namespace limes
