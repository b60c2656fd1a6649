// The text form of weight functions, and piecewise ones from expressions.

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/unity/weight_function.hpp"

#include <fmt/format.h>

#include <map>

namespace limes {
namespace {

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\n");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t\n") - first + 1));
}

/// The parts between commas outside of all brackets.
std::vector<std::string> split_arguments(std::string_view text) {
  std::vector<std::string> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    if (k < text.size()) depth += text[k] == '(' || text[k] == '[' ? 1 : text[k] == ')' || text[k] == ']' ? -1 : 0;
    if (k < text.size() && (text[k] != ',' || depth > 0)) continue;
    parts.push_back(trimmed(text.substr(begin, k - begin)));
    begin = k + 1;
  }
  return parts;
}

std::optional<Polynomial> as_polynomial(const RationalFunction& f) {
  if (!f.denominator().is_constant()) return std::nullopt;
  return Rational(1) / f.denominator().constant_value() * f.numerator().univariate(0);
}

bool calls_functions(const Expression& expression) {
  const auto any = [](const std::vector<Expression>& list) {
    return std::any_of(list.begin(), list.end(), [](const Expression& e) { return calls_functions(e); });
  };
  if (std::holds_alternative<Expression::Call>(expression.node)) return true;
  if (const auto* name = std::get_if<Expression::Name>(&expression.node)) return name->name == "pi";
  if (const auto* operation = std::get_if<Expression::Operation>(&expression.node)) return any(operation->operands);
  if (const auto* power = std::get_if<Expression::Power>(&expression.node)) return any(power->base);
  return false;
}

/// Names and functions of an expression that will be evaluated in floating point.
void check_expression(const Expression& expression) {
  const auto fail = [&](const std::string& reason) { throw InputError(reason, {"", 0, expression.column}); };
  const auto check_all = [](const std::vector<Expression>& list) {
    for (const Expression& e : list) check_expression(e);
  };
  if (const auto* name = std::get_if<Expression::Name>(&expression.node)) {
    if (name->name != "u" && name->name != "pi") fail(fmt::format("unknown name '{}' (known: u, pi)", name->name));
  } else if (const auto* call = std::get_if<Expression::Call>(&expression.node)) {
    static const std::set<std::string> known{"exp", "log", "sin", "cos", "sqrt", "abs"};
    if (!known.contains(call->function)) fail(fmt::format("unknown function '{}' (known: exp, log, sin, cos, sqrt, abs)", call->function));
    if (call->arguments.size() != 1) fail(fmt::format("{} takes one argument", call->function));
    check_all(call->arguments);
  } else if (const auto* operation = std::get_if<Expression::Operation>(&expression.node)) {
    check_all(operation->operands);
  } else if (const auto* power = std::get_if<Expression::Power>(&expression.node)) {
    check_all(power->base);
  } else if (std::holds_alternative<Expression::List>(expression.node)) {
    fail("a list is not allowed here");
  }
}

/// The arguments of 'name(..)' by key; "" is the key of what has none.
class Arguments {
 public:
  Arguments(std::string function, std::string_view list) : function_(std::move(function)) {
    for (const std::string& part : split_arguments(list)) {
      if (part.empty()) continue;
      const std::size_t equals = part.find('=');
      const std::string key = equals == std::string::npos ? (part == "global" ? part : "") : trimmed(part.substr(0, equals));
      const std::string value = equals == std::string::npos ? part : trimmed(part.substr(equals + 1));
      if (values_.emplace(key, value).second) {
        keys_.push_back(key);
      } else {
        throw InputError(fmt::format("{}: {} is given twice", function_, key.empty() ? "the expression" : "'" + key + "'"));
      }
    }
  }

  void set(const std::string& key, const std::string& value) {
    if (values_.insert_or_assign(key, value).second) keys_.push_back(key);
  }

  const std::string& function() const { return function_; }
  /// 'name(..)' with all arguments that were not taken, in their order.
  std::string text() const {
    std::string list;
    for (const std::string& key : keys_) {
      const auto found = values_.find(key);
      if (found == values_.end()) continue;
      list += (list.empty() ? "" : ", ") + (key.empty() || key == "global" ? "" : key + "=") + found->second;
    }
    return function_ + "(" + list + ")";
  }

  std::optional<std::string> take(const std::string& key) {
    const auto found = values_.find(key);
    if (found == values_.end()) return std::nullopt;
    std::string value = std::move(found->second);
    values_.erase(found);
    return value;
  }
  std::string require(const std::string& key) {
    if (auto value = take(key)) return *value;
    throw InputError(fmt::format("{} needs {}", function_, key.empty() ? "an expression in u" : "'" + key + "=..'"));
  }
  template <class Read>
  auto located(const std::string& key, Read read) {
    const std::string value = require(key);
    try {
      return read(value);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {} '{}': {}", function_, key, value, error.reason()));
    }
  }
  Rational number(const std::string& key) {
    return located(key, [&](const std::string& text) { return read_rational(text); });
  }
  void finish() const {
    if (values_.empty()) return;
    const auto& [key, value] = *values_.begin();
    throw InputError(fmt::format("{} has no argument '{}'", function_, key.empty() ? value : key));
  }

 private:
  std::string function_;
  std::map<std::string, std::string> values_;
  std::vector<std::string> keys_;
};

WeightFunction read_shape(Arguments& arguments) {
  const std::string& name = arguments.function();
  if (name == "bspline") {
    const Rational degree = arguments.number("degree");
    if (denominator(degree) != 1 || abs(degree) > 1000) throw InputError("bspline: the degree must be an integer from 0 to 30");
    return bspline_weight(static_cast<int>(numerator(degree)));
  }
  if (name == "polynomial") {
    const std::string text = arguments.require("");
    const std::optional<Polynomial> polynomial = as_polynomial(read_rational_function(text, {"u"}));
    if (!polynomial) throw InputError(fmt::format("polynomial: '{}' is no polynomial in u", text));
    const Interval domain = arguments.located("domain", [](const std::string& value) { return read_interval(value); });
    return polynomial_weight(*polynomial, domain, arguments.take("global").has_value());
  }
  const Rational radius = arguments.number("c");
  return cinpact_weight(radius, arguments.number("sigma"), name == "interpolating-cinpact");
}

Arguments read_arguments(const std::string& text) {
  const std::size_t open = text.find('(');
  const std::string name = trimmed(text.substr(0, open));
  if (name != "bspline" && name != "polynomial" && name != "cinpact" && name != "interpolating-cinpact") {
    throw InputError(fmt::format("unknown weight function '{}' (known: bspline(degree=d), polynomial(p, domain=[a,b]), cinpact(c=c, "
                                 "sigma=s), interpolating-cinpact(c=c, sigma=s))", name));
  }
  const std::string rest = trimmed(std::string_view(text).substr(std::min(open, text.size())));
  if (rest.size() < 2 || rest.back() != ')') throw InputError(fmt::format("{}: expected arguments in parentheses", name));
  return {name, std::string_view(rest).substr(1, rest.size() - 2)};
}

}  // namespace

WeightFunction read_weight(const std::string& text) {
  Arguments arguments = read_arguments(text);
  WeightFunction weight = read_shape(arguments);
  if (const auto centre = arguments.take("centre")) weight.centre = read_rational(*centre);
  arguments.finish();
  return weight;
}

std::string with_argument(const std::string& text, const std::string& name, const Rational& value) {
  Arguments arguments = read_arguments(text);
  arguments.set(name, to_string(value));
  return arguments.text();
}

WeightFunction piecewise_weight(std::vector<Rational> breaks, std::vector<Expression> pieces) {
  if (pieces.empty() || breaks.size() != pieces.size() + 1) throw DomainError("piecewise_weight: one break more than pieces");
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (breaks[k] >= breaks[k + 1]) throw InputError("the pieces of a weight function follow one another from left to right");
  }
  PiecewisePolynomial exact{.breaks = breaks, .pieces = {}};
  for (const Expression& piece : pieces) {
    check_expression(piece);
    if (calls_functions(piece)) continue;
    const auto polynomial = as_polynomial(to_rational_function(piece, {"u"}));
    if (polynomial) exact.pieces.push_back(compose(*polynomial, Polynomial({breaks[exact.pieces.size()], Rational(1)})));
  }
  if (exact.pieces.size() == pieces.size()) return {std::move(exact), 0};
  return {PiecewiseExpression{std::move(breaks), std::move(pieces)}, 0};
}

}  // namespace limes
