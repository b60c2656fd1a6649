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
  explicit RuleEvaluator(const VariableNames& parameters) : parameters_(parameters) {}

  Value evaluate(const Expression& e) const {
    if (const auto* call = std::get_if<Expression::Call>(&e.node)) return evaluate_call(e, *call);
    if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) return evaluate_operation(e, *operation);
    return to_rational_function(e, parameters_);
  }

 private:
  int integer_argument(const Expression& e, int lower, int upper, const char* what) const {
    const Rational value = rational_argument(e);
    if (denominator(value) != 1 || value < lower || value > upper) {
      fail(e, fmt::format("{} must be an integer from {} to {}", what, lower, upper));
    }
    return numerator(value).convert_to<int>();
  }

  Rational rational_argument(const Expression& e) const {
    const RationalFunction value = to_rational_function(e, parameters_);
    if (!value.is_constant()) fail(e, "expected a number without parameters");
    return value.constant_value();
  }

  Value evaluate_call(const Expression& e, const Expression::Call& call) const {
    if (call.function == "f") {
      if (call.arguments.size() != 2) fail(e, "f takes two arguments: f(degree, offset)");
      return Interpolant{integer_argument(call.arguments[0], 0, 63, "the degree of f"),
                         integer_argument(call.arguments[1], -64, 64, "the offset of f")};
    }
    if (call.function == "at") {
      if (call.arguments.size() != 2) fail(e, "at takes two arguments: at(f(k,j), u)");
      const Value g = evaluate(call.arguments[0]);
      if (!std::holds_alternative<Interpolant>(g)) fail(call.arguments[0], "the first argument of at must be an interpolant f(k,j)");
      return sample(std::get<Interpolant>(g), rational_argument(call.arguments[1]));
    }
    fail(e, fmt::format("unknown function '{}' (known: f, at)", call.function));
  }

  /// Lagrange weights of the interpolant at i + u.
  Functional sample(const Interpolant& g, const Rational& u) const {
    const int variables = static_cast<int>(parameters_.size());
    const int first = g.offset - g.degree / 2;
    Functional result;
    for (int s = first; s <= first + g.degree; ++s) {
      Rational weight = 1;
      for (int t = first; t <= first + g.degree; ++t) {
        if (t != s) weight *= Rational(u - t) / (s - t);
      }
      if (weight != 0) result.emplace(s, RationalFunction::constant(variables, weight));
    }
    return result;
  }

  Value evaluate_operation(const Expression& e, const Expression::Operation& operation) const {
    std::vector<Value> values;
    for (const Expression& operand : operation.operands) values.push_back(evaluate(operand));
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::holds_alternative<Interpolant>(values[k])) {
        fail(operation.operands[k], "an interpolant is no number: sample it, at(f(k,j), u)");
      }
    }
    const auto functional = [&](std::size_t k) { return std::get_if<Functional>(&values[k]); };
    const bool any = functional(0) || (values.size() > 1 && functional(1));
    if (!any) return to_rational_function(e, parameters_);
    switch (operation.op) {
      case '~':
        return scaled(*functional(0), RationalFunction::constant(static_cast<int>(parameters_.size()), -1));
      case '+':
      case '-': {
        if (!functional(0) || !functional(1)) fail(e, "cannot add a number to a sampled point");
        const RationalFunction sign =
            RationalFunction::constant(static_cast<int>(parameters_.size()), operation.op == '+' ? 1 : -1);
        Functional result = *functional(0);
        for (const auto& [offset, weight] : *functional(1)) {
          auto [place, fresh] = result.emplace(offset, sign * weight);
          if (!fresh) place->second += sign * weight;
        }
        return result;
      }
      case '*':
        if (functional(0) && functional(1)) fail(e, "cannot multiply two sampled points");
        return functional(0) ? scaled(*functional(0), std::get<RationalFunction>(values[1]))
                             : scaled(*functional(1), std::get<RationalFunction>(values[0]));
      case '/': {
        if (functional(1)) fail(e, "cannot divide by a sampled point");
        const RationalFunction& divisor = std::get<RationalFunction>(values[1]);
        if (divisor.is_zero()) fail(e, "division by zero");
        return scaled(*functional(0), RationalFunction::constant(divisor.variables(), 1) / divisor);
      }
      default:
        throw InternalError("unknown operation in an expression");
    }
  }

  static Functional scaled(Functional f, const RationalFunction& c) {
    for (auto& [offset, weight] : f) weight *= c;
    return f;
  }

  const VariableNames& parameters_;
};

}  // namespace

Mask mask_from_rule(const Expression& rule, const VariableNames& parameters) {
  const Value value = RuleEvaluator(parameters).evaluate(rule);
  if (!std::holds_alternative<Functional>(value)) fail(rule, "a rule must be a combination of sampled interpolants at(f(k,j), u)");
  // The new point 2i+1 takes weight[o] from p_{i+o}: a_{2i+1-2(i+o)} = a_{1-2o} = weight[o].
  const int variables = static_cast<int>(parameters.size());
  LaurentPolynomial symbol(variables, 0, {RationalFunction::constant(variables, 1)});
  for (const auto& [offset, weight] : std::get<Functional>(value)) {
    symbol += LaurentPolynomial(variables, 1 - 2 * offset, {weight});
  }
  return {2, symbol};
}

}  // namespace limes
