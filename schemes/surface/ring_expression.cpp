#include "schemes/surface/ring_expression.hpp"

#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"

#include <fmt/format.h>

#include <charconv>

namespace limes {
namespace {

constexpr int largest_index = 16;

[[noreturn]] void fail(const std::string& reason, int column) { throw InputError(reason, {"", 0, column}); }

void check(RingPoint point, bool dual, int column) {
  const bool centre = !dual && point == RingPoint{};
  if (!centre && (point.a < (dual ? 0 : 1) || point.b < 0))
    fail(fmt::format("{} is no point of a sector (a >= {}, b >= 0{})", to_string(point), dual ? 0 : 1, dual ? "" : ", or 0,0"), column);
  if (std::max(point.a, point.b) > largest_index) fail(fmt::format("coordinates are at most {}", largest_index), column);
}

using Terms = std::vector<RingTerm>;
using Value = std::variant<RationalFunction, Terms>;

/// Values are coefficients or combinations of points.
class Evaluator {
 public:
  Evaluator(bool dual, const VariableNames& names) : dual_(dual), names_(names) {}

  Value operator()(const Expression& e) {
    if (const auto* call = std::get_if<Expression::Call>(&e.node)) return Terms{term(*call, e.column)};
    if (const auto* operation = std::get_if<Expression::Operation>(&e.node)) return evaluate(*operation, e.column);
    return to_rational_function(e, names_, arithmetic_);
  }

 private:
  Value evaluate(const Expression::Operation& operation, int column) {
    Value a = (*this)(operation.operands.front());
    Terms* points = std::get_if<Terms>(&a);
    if (operation.op == '~') {
      if (!points) return -std::get<RationalFunction>(a);
      for (RingTerm& t : *points) t.weight = -t.weight;
      return a;
    }
    Value b = (*this)(operation.operands.back());
    Terms* others = std::get_if<Terms>(&b);
    if (!points && !others)
      return arithmetic_.apply(operation.op, std::get<RationalFunction>(a), std::get<RationalFunction>(b), column);
    if (operation.op == '+' || operation.op == '-') {
      if (!points || !others) fail("cannot add a number to a combination of points", column);
      for (const RingTerm& t : *others) add(*points, t, operation.op, column);
      return a;
    }
    if (others && (points || operation.op == '/')) fail("points can be multiplied with numbers and divided by numbers only", column);
    const RationalFunction factor = std::get<RationalFunction>(points ? b : a);
    Terms result = points ? std::move(*points) : std::move(*others);
    for (RingTerm& t : result) t.weight = arithmetic_.apply(operation.op, t.weight, factor, column);
    return result;
  }

  void add(Terms& sum, const RingTerm& t, char sign, int column) {
    for (RingTerm& known : sum) {
      if (known.point != t.point || known.sector != t.sector || known.harmonic != t.harmonic) continue;
      known.weight = arithmetic_.apply(sign, known.weight, t.weight, column);
      return;
    }
    sum.push_back(t);
    if (sign == '-') sum.back().weight = -t.weight;
  }

  int integer(const Expression& e) {
    const RationalFunction value = to_rational_function(e, {}, arithmetic_);
    const Rational c = value.constant_value();
    if (denominator(c) != 1 || abs(c) > largest_index) fail(fmt::format("expected an integer from -{} to {}", largest_index, largest_index), e.column);
    return static_cast<int>(numerator(c));
  }

  RingTerm term(const Expression::Call& call, int column) {
    std::vector<int> n;
    for (const Expression& argument : call.arguments) n.push_back(integer(argument));
    RingTerm t;
    t.weight = RationalFunction::constant(2, 1);
    if (call.function == "at" && (n.size() == 2 || n.size() == 3)) {
      t.point = {n[0], n[1]};
      if (n.size() == 3) t.sector = n[2];
      if (!dual_ && t.point == RingPoint{} && t.sector != 0) fail("the vertex 0,0 belongs to all sectors: at(0,0)", column);
    } else if (call.function == "mean" && n.size() == 2) {
      t.point = {n[0], n[1]};
      t.harmonic = 0;
    } else if (call.function == "harmonic" && n.size() == 3) {
      t.point = {n[1], n[2]};
      t.harmonic = n[0];
      if (n[0] < 0) fail("a harmonic is at least 0", column);
    } else {
      fail(fmt::format("unknown '{}' with {} arguments (known: at(a,b), at(a,b,sector), mean(a,b), harmonic(k,a,b))", call.function, n.size()), column);
    }
    check(t.point, dual_, column);
    if (!dual_ && t.point == RingPoint{} && t.harmonic >= 0) fail("the vertex 0,0 has no mean: at(0,0)", column);
    return t;
  }

  const bool dual_;
  const VariableNames& names_;
  BoundedArithmetic arithmetic_;
};

}  // namespace

std::vector<RingTerm> read_ring_expression(std::string_view text, bool dual, const std::string& level_parameter) {
  const VariableNames names{level_parameter, "n"};
  Value value = Evaluator(dual, names)(read_expression(text));
  Terms* terms = std::get_if<Terms>(&value);
  if (!terms) throw InputError("expected a combination of points such as at(0,0) and mean(1,0)");
  std::erase_if(*terms, [](const RingTerm& t) { return t.weight.is_zero(); });
  return std::move(*terms);
}

RingPoint read_ring_point(std::string_view text, bool dual) {
  RingPoint point;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, point.a);
  const bool comma = first.ec == std::errc() && first.ptr != end && *first.ptr == ',';
  const auto second = comma ? std::from_chars(first.ptr + 1, end, point.b) : first;
  if (!comma || second.ec != std::errc() || second.ptr != end) throw InputError(fmt::format("expected a point such as \"1,0\", not \"{}\"", text));
  check(point, dual, 0);
  return point;
}

std::string to_string(RingPoint point) { return fmt::format("{},{}", point.a, point.b); }

std::string to_string(const std::vector<RingTerm>& terms, const std::string& level_parameter) {
  const VariableNames names{level_parameter, "n"};
  std::string text;
  for (const RingTerm& t : terms) {
    const std::string weight = to_string(t.weight, names);
    const bool plain = t.weight.is_constant() || (t.weight.is_polynomial() && t.weight.numerator().term_count() == 1);
    const bool negative = plain && weight.starts_with('-');
    text += text.empty() ? (negative ? "-" : "") : negative ? " - " : " + ";
    const std::string size = negative ? weight.substr(1) : weight;
    if (size != "1") text += (plain ? size : "(" + size + ")") + "*";
    if (t.harmonic > 0) text += fmt::format("harmonic({},{})", t.harmonic, to_string(t.point));
    else if (t.harmonic == 0) text += fmt::format("mean({})", to_string(t.point));
    else if (t.sector != 0) text += fmt::format("at({},{})", to_string(t.point), t.sector);
    else text += fmt::format("at({})", to_string(t.point));
  }
  return text.empty() ? "0" : text;
}

}  // namespace limes
