#include "schemes/uniform/interpolant_rule.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <map>

namespace limes {
namespace {

/// A linear functional of the points: sum over offsets o of weights[o] p_{i+o}.
using Functional = std::map<int, RationalFunction>;
struct Interpolant {
  int degree;
  int offset;
};
using Value = std::variant<RationalFunction, Functional, Interpolant>;

[[noreturn]] void fail(const Expression& where, const std::string& reason) {
  throw InputError(reason, {.file = "", .line = 0, .column = where.column});
}

class RuleEvaluator {
 public:
  explicit RuleEvaluator(const VariableNames& parameters)
      : parameters_(parameters), variables_(static_cast<int>(parameters.size())) {}

  Value evaluate(const Expression& e) {
    if (const auto* call = std::get_if<Expression::Call>(&e.node)) return evaluate_call(e, *call);
    if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) return evaluate_operation(e, *operation);
    return to_rational_function(e, parameters_, arithmetic_);
  }

 private:
  int integer_argument(const Expression& e, int lower, int upper, const char* what) {
    const Rational value = rational_argument(e);
    if (denominator(value) != 1 || value < lower || value > upper) {
      fail(e, fmt::format("{} must be an integer from {} to {}", what, lower, upper));
    }
    return numerator(value).convert_to<int>();
  }

  Rational rational_argument(const Expression& e) {
    const RationalFunction value = to_rational_function(e, parameters_, arithmetic_);
    if (!value.is_constant()) fail(e, "expected a number without parameters");
    return value.constant_value();
  }

  Value evaluate_call(const Expression& e, const Expression::Call& call) {
    if (call.function == "f") {
      if (call.arguments.size() != 2) fail(e, "f takes two arguments: f(degree, offset)");
      return Interpolant{integer_argument(call.arguments[0], 0, 63, "the degree of f"),
                         integer_argument(call.arguments[1], -64, 64, "the offset of f")};
    }
    if (call.function == "at") {
      if (call.arguments.size() != 2) fail(e, "at takes two arguments: at(f(k,j), u)");
      const Value g = evaluate(call.arguments[0]);
      if (!std::holds_alternative<Interpolant>(g)) fail(call.arguments[0], "the first argument of at must be an interpolant f(k,j)");
      return sample(std::get<Interpolant>(g), rational_argument(call.arguments[1]), e.column);
    }
    fail(e, fmt::format("unknown function '{}' (known: f, at)", call.function));
  }

  RationalFunction constant(const Rational& x) const { return RationalFunction::constant(variables_, x); }

  /// Lagrange weights of the interpolant at i + u.
  Functional sample(const Interpolant& g, const Rational& u, int column) {
    const int first = g.offset - g.degree / 2;
    Functional result;
    for (int s = first; s <= first + g.degree; ++s) {
      RationalFunction weight = constant(1);
      for (int t = first; t <= first + g.degree; ++t) {
        if (t != s) weight = arithmetic_.apply('*', weight, constant(Rational(u - t) / (s - t)), column);
      }
      if (!weight.is_zero()) result.emplace(s, std::move(weight));
    }
    return result;
  }

  Value evaluate_operation(const Expression& e, const Expression::Operation& operation) {
    std::vector<Value> values;
    for (const Expression& operand : operation.operands) {
      values.push_back(evaluate(operand));
      if (std::holds_alternative<Interpolant>(values.back())) {
        fail(operand, "an interpolant is no number: sample it, at(f(k,j), u)");
      }
    }
    Functional* const left = std::get_if<Functional>(&values.front());
    if (operation.op == '~') {
      if (left) return scaled(std::move(*left), '*', constant(-1), e.column);
      return -std::get<RationalFunction>(values.front());
    }
    Functional* const right = std::get_if<Functional>(&values.back());
    if (!left && !right) {
      return arithmetic_.apply(operation.op, std::get<RationalFunction>(values[0]), std::get<RationalFunction>(values[1]), e.column);
    }
    if (operation.op == '+' || operation.op == '-') {
      if (!left || !right) fail(e, "cannot add a number to a sampled point");
      for (const auto& [offset, weight] : *right) {
        RationalFunction& place = left->emplace(offset, constant(0)).first->second;
        place = arithmetic_.apply(operation.op, place, weight, e.column);
      }
      return std::move(*left);
    }
    if (left && right) {
      fail(e, operation.op == '*' ? "cannot multiply two sampled points" : "cannot divide by a sampled point");
    }
    if (left) return scaled(std::move(*left), operation.op, std::get<RationalFunction>(values[1]), e.column);
    if (operation.op == '/') fail(e, "cannot divide by a sampled point");
    return scaled(std::move(*right), '*', std::get<RationalFunction>(values[0]), e.column);
  }

  /// f * c or f / c.
  Functional scaled(Functional f, char op, const RationalFunction& c, int column) {
    for (auto& [offset, weight] : f) weight = arithmetic_.apply(op, weight, c, column);
    return f;
  }

  const VariableNames& parameters_;
  int variables_;
  BoundedArithmetic arithmetic_;
};

}  // namespace

Mask mask_from_rule(const Expression& rule, const VariableNames& parameters) {
  const Value value = RuleEvaluator(parameters).evaluate(rule);
  if (!std::holds_alternative<Functional>(value)) fail(rule, "a rule must be a combination of sampled interpolants at(f(k,j), u)");
  // The new point 2i+1 takes weight[o] from p_{i+o}: a_{2i+1-2(i+o)} = a_{1-2o} = weight[o], and a_0 = 1.
  const Functional& weights = std::get<Functional>(value);
  const int variables = static_cast<int>(parameters.size());
  int lowest = 0;
  int highest = 0;
  for (const auto& [offset, weight] : weights) {
    lowest = std::min(lowest, 1 - 2 * offset);
    highest = std::max(highest, 1 - 2 * offset);
  }
  std::vector<RationalFunction> symbol(highest - lowest + 1, RationalFunction(variables));
  symbol[-lowest] = RationalFunction::constant(variables, 1);
  for (const auto& [offset, weight] : weights) symbol[1 - 2 * offset - lowest] = weight;
  return {2, LaurentPolynomial(variables, lowest, std::move(symbol))};
}

}  // namespace limes
