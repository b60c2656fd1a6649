// The vocabulary of insertion rules: expressions of segments and points become nodes of a RuleProgram.
#include "schemes/nonuniform/segment_compiler.hpp"

#include "schemes/nonuniform/bezier_maps.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace limes {
namespace {

constexpr int max_degree = 64;
constexpr int max_order = 15;
constexpr int max_height = 1000;
constexpr int max_again_depth = 3;
constexpr int max_reach = 1024;
constexpr std::size_t max_nodes = 100000;
constexpr std::size_t max_entries = 200000;
constexpr std::size_t max_bits = 33000;  // about 10000 digits

[[noreturn]] void fail(const Expression& where, const std::string& reason) {
  throw InputError(reason, {.file = "", .line = 0, .column = where.column});
}

void require_arguments(const Expression& e, const Expression::Call& call, std::size_t count, const char* form) {
  static const char* const words[] = {"no argument", "one argument", "two arguments", "three arguments"};
  if (call.arguments.size() != count) fail(e, fmt::format("{} takes {}: {}", call.function, words[count], form));
}

}  // namespace

const VariableNames& SegmentCompiler::vocabulary() {
  static const VariableNames names{"f", "hermite", "degree", "tension", "join", "split", "at", "dot", "again"};
  return names;
}

int SegmentCompiler::new_point(const Expression& e) {
  const auto made = compile(e);
  if (!made || !node(*made).is_point) {
    fail(e, "a rule must be a point: a combination of sampled interpolants at(S,u), and of dot([..],S) and again(E)");
  }
  return *made;
}

RationalFunction SegmentCompiler::number_argument(const Expression& e) {
  if (!names_.is_number(e)) fail(e, "expected a number");
  return names_.number(e);
}

Rational SegmentCompiler::rational_argument(const Expression& e) {
  const RationalFunction value = number_argument(e);
  if (!value.is_constant()) fail(e, "expected a number without parameters");
  return value.constant_value();
}

int SegmentCompiler::integer_argument(const Expression& e, int lower, int upper, const std::string& what) {
  const Rational value = rational_argument(e);
  if (denominator(value) != 1 || value < lower || value > upper) {
    fail(e, fmt::format("{} must be an integer from {} to {}", what, lower, upper));
  }
  return numerator(value).convert_to<int>();
}

std::optional<int> SegmentCompiler::compile(const Expression& e) {
  if (const auto* call = std::get_if<Expression::Call>(&e.node)) return compile_call(e, *call);
  if (std::holds_alternative<Expression::List>(e.node)) fail(e, "a list stands in dot([..], S) only");
  if (names_.is_number(e)) return std::nullopt;
  if (const auto* name = std::get_if<Expression::Name>(&e.node)) return names_.node(e, name->name);
  if (std::holds_alternative<Expression::Power>(e.node)) fail(e, "a power of a segment or a point makes no sense");
  return compile_operation(e, std::get<Expression::Operation>(e.node));
}

int SegmentCompiler::segment_argument(const Expression& e, bool in_one_piece) {
  const auto number = compile(e);
  if (!number) fail(e, "expected a segment, not a number");
  if (node(*number).is_point) fail(e, "expected a segment, not a point");
  if (in_one_piece && node(*number).pieces > 1)
    fail(e, fmt::format("expected a segment in one piece, not in {}", node(*number).pieces));
  return *number;
}

void SegmentCompiler::spend(std::size_t entries, const Expression& e) {
  entries_ += entries;
  if (entries_ > max_entries) throw LimitError("the rule is too large", {.file = "", .line = 0, .column = e.column});
}

int SegmentCompiler::add(RuleNode made, const Expression& e) {
  for (const int argument : made.arguments) {
    made.height = std::max(made.height, node(argument).height + 1);
    made.again_depth = std::max(made.again_depth, node(argument).again_depth + (made.kind == RuleNode::Kind::again));
    if (made.kind == RuleNode::Kind::join || made.kind == RuleNode::Kind::again) continue;
    made.lowest = std::min(made.lowest, node(argument).lowest);
    made.highest = std::max(made.highest, node(argument).highest);
  }
  const SourcePosition here{.file = "", .line = 0, .column = e.column};
  if (made.height > max_height) throw LimitError(fmt::format("the rule is nested more than {} deep", max_height), here);
  if (made.again_depth > max_again_depth)
    throw LimitError(fmt::format("again is nested more than {} deep", max_again_depth), here);
  if (made.highest - made.lowest >= max_reach)
    throw LimitError(fmt::format("the rule needs more than {} points", max_reach), here);
  if (program_.nodes.size() >= max_nodes) throw LimitError("the rule is too large", here);
  program_.nodes.push_back(std::move(made));
  return static_cast<int>(program_.nodes.size()) - 1;
}

int SegmentCompiler::add_map(int argument, const RationalMatrix& matrix, int degree, int pieces, const Expression& e) {
  RuleNode made{.degree = degree, .pieces = pieces, .arguments = {argument}};
  for (int i = 0; i < matrix.rows(); ++i) {
    auto& row = made.rows.emplace_back();
    for (int j = 0; j < matrix.columns(); ++j) {
      if (matrix(i, j) != 0) row.push_back({j, pooled(constant(matrix(i, j)))});
    }
  }
  return add(std::move(made), e);
}

RationalFunction SegmentCompiler::constant(const Rational& value) const {
  return RationalFunction::constant(static_cast<int>(program_.parameters.size()), value);
}

int SegmentCompiler::pooled(const RationalFunction& value) {
  const auto [place, fresh] =
      pool_.emplace(to_string(value, program_.parameters), static_cast<int>(program_.numbers.size()));
  if (fresh) program_.numbers.push_back(value);
  return place->second;
}

int SegmentCompiler::compile_call(const Expression& e, const Expression::Call& call) {
  const std::string& name = call.function;
  if (name == "f") return compile_interpolant(e, call);
  if (name == "hermite") return compile_hermite(e, call);
  if (name == "degree") return compile_degree(e, call);
  if (name == "tension") return compile_tension(e, call);
  if (name == "join") return compile_join(e, call);
  if (name == "split") return compile_split(e, call);
  if (name == "at") return compile_at(e, call);
  if (name == "dot") return compile_dot(e, call);
  if (name == "again") return compile_again(e, call);
  fail(e, fmt::format("unknown function '{}' (known: {})", name, fmt::join(vocabulary(), ", ")));
}

int SegmentCompiler::compile_interpolant(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 2, "f(degree, offset)");
  const int degree = integer_argument(call.arguments[0], 0, 63, "the degree of f");
  const int offset = integer_argument(call.arguments[1], -64, 64, "the offset of f");
  const int first = offset - degree / 2;
  return add({.kind = RuleNode::Kind::interpolant,
              .degree = degree,
              .interpolant_degree = degree,
              .offset = offset,
              .lowest = std::min(first, 0),
              .highest = std::max(first + degree, 1)},
             e);
}

int SegmentCompiler::compile_hermite(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 3, "hermite(r, A, B)");
  const int r = integer_argument(call.arguments[0], 0, max_order, "the order of hermite");
  const int a = segment_argument(call.arguments[1]);
  const int b = segment_argument(call.arguments[2]);
  RuleNode made{.degree = 2 * r + 1, .arguments = {a, b}};
  spend(std::size_t((r + 1) * (node(a).size() + node(b).size())), e);
  made.rows.resize(std::size_t(2 * r + 2));
  const RationalMatrix left = jet_in_degree(node(a).degree, 2 * r + 1, r);
  const RationalMatrix right = jet_in_degree(node(b).degree, 2 * r + 1, r);
  const int last = node(a).size() + node(b).size() - 1;
  for (int i = 0; i <= r; ++i) {
    for (int j = 0; j < left.columns(); ++j) {
      if (left(i, j) != 0) made.rows[std::size_t(i)].push_back({j, pooled(constant(left(i, j)))});
    }
    for (int j = 0; j < right.columns(); ++j) {
      if (right(i, j) != 0) made.rows[std::size_t(2 * r + 1 - i)].push_back({last - j, pooled(constant(right(i, j)))});
    }
  }
  return add(std::move(made), e);
}

int SegmentCompiler::compile_degree(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 2, "degree(d, S)");
  const int degree = integer_argument(call.arguments[0], 0, max_degree, "the degree");
  const int s = segment_argument(call.arguments[1], false);
  const int from = node(s).degree, pieces = node(s).pieces;
  if (degree < from) fail(call.arguments[0], fmt::format("the segment has degree {} already", from));
  spend(std::size_t((degree + 1) * (from + 1) * pieces * pieces), e);
  const RationalMatrix raising = degree_raising(from, degree);
  RationalMatrix all(pieces * (degree + 1), pieces * (from + 1));
  for (int k = 0; k < pieces; ++k) {
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; j <= from; ++j) all(k * (degree + 1) + i, k * (from + 1) + j) = raising(i, j);
    }
  }
  return add_map(s, all, degree, pieces, e);
}

// Karciauskas & Peters 2013, eq. (8), at both ends.
int SegmentCompiler::compile_tension(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 2, "tension(c, S)");
  const RationalFunction c = number_argument(call.arguments[0]);
  const int s = segment_argument(call.arguments[1]);
  const int degree = node(s).degree, r = degree / 2;
  if (degree % 2 == 0) fail(call.arguments[1], fmt::format("tension needs a segment of odd degree, not {}", degree));
  BoundedArithmetic& arithmetic = names_.arithmetic();
  const RationalFunction rest = arithmetic.apply('-', constant(1), c, e.column);
  const auto weight_of = [&](int i, int k) {  // binomial (1-c)^{i-k} c^k
    const RationalFunction product =
        arithmetic.apply('*', arithmetic.power(rest, i - k, e.column), arithmetic.power(c, k, e.column), e.column);
    return constant(binomial(i, k)) * product;
  };
  RuleNode made{.degree = degree, .arguments = {s}};
  made.rows.resize(std::size_t(degree + 1));
  spend(std::size_t((r + 1) * (r + 1)), e);
  for (int i = 0; i <= r; ++i) {
    for (int k = 0; k <= i; ++k) {
      const RationalFunction weight = weight_of(i, k);
      if (weight.is_zero()) continue;
      const int number = pooled(weight);
      made.rows[std::size_t(i)].push_back({k, number});
      made.rows[std::size_t(degree - i)].push_back({degree - k, number});
    }
  }
  return add(std::move(made), e);
}

int SegmentCompiler::compile_join(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 2, "join(r, S)");
  const int r = integer_argument(call.arguments[0], 1, 3, "the order of join");
  const int s = segment_argument(call.arguments[1]);
  const int degree = node(s).degree;
  if (degree < 2 * r) {
    fail(call.arguments[1], fmt::format("join({}, S) needs a segment of degree {} at least, not {}: degree({}, S)", r,
                                        2 * r, degree, 2 * r));
  }
  return add({.kind = RuleNode::Kind::join,
              .degree = degree,
              .order = r,
              .arguments = {s},
              .lowest = node(s).lowest - 1,
              .highest = node(s).highest + 1},
             e);
}

int SegmentCompiler::compile_split(const Expression& e, const Expression::Call& call) {
  if (call.arguments.size() != 3) require_arguments(e, call, 2, "split(r, S), or three: split(r, S, pieces)");
  const int r = integer_argument(call.arguments[0], 1, max_order, "the order of split");
  const int s = segment_argument(call.arguments[1]);
  const int pieces =
      call.arguments.size() == 2 ? r + 1 : integer_argument(call.arguments[2], 1, r + 1, "the number of pieces");
  spend(std::size_t(pieces * (r + 2) * (r + 2) * node(s).size() / 4), e);  // the operations, against those of one entry
  const RationalMatrix map = split_in_pieces(node(s).degree, r, pieces);
  if (map.rows() == 0) {
    fail(e, fmt::format("{} pieces of degree {} that join C{} do not suffice for the {}-jets of a segment of degree "
                        "{}: split({}, S)",
                        pieces, r + 1, r, r, node(s).degree, r));
  }
  return add_map(s, map, r + 1, pieces, e);
}

int SegmentCompiler::compile_at(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 2, "at(S, u)");
  const int s = segment_argument(call.arguments[0], false);
  const Rational u = rational_argument(call.arguments[1]);
  const RuleNode& segment = node(s);
  if (segment.kind == RuleNode::Kind::interpolant) {
    return add({.kind = RuleNode::Kind::sample,
                .is_point = true,
                .interpolant_degree = segment.interpolant_degree,
                .offset = segment.offset,
                .u = u,
                .lowest = segment.lowest,
                .highest = segment.highest},
               e);
  }
  spend(std::size_t(segment.size()), e);
  // The weights are products of `degree` factors u and 1 - u.
  const std::size_t bits = msb(abs(numerator(u)) + denominator(u)) * std::size_t(segment.degree + 1);
  if (bits > max_bits) throw LimitError("numbers of too many digits would arise", {.file = "", .line = 0, .column = e.column});
  const Rational scaled = u * segment.pieces;
  int piece = 0;
  while (piece + 1 < segment.pieces && piece + 1 <= scaled) ++piece;
  const std::vector<Rational> values = bernstein_values(segment.degree, Rational(scaled - piece));
  RationalMatrix row(1, segment.size());
  for (int j = 0; j <= segment.degree; ++j) row(0, piece * (segment.degree + 1) + j) = values[std::size_t(j)];
  const int made = add_map(s, row, 0, 1, e);
  program_.nodes.back().is_point = true;
  return made;
}

int SegmentCompiler::compile_dot(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 2, "dot([c0, c1, ..], S)");
  const auto* list = std::get_if<Expression::List>(&call.arguments[0].node);
  if (!list) fail(call.arguments[0], "expected a list [c0, c1, ..]");
  const int s = segment_argument(call.arguments[1]);
  if (static_cast<int>(list->elements.size()) != node(s).size()) {
    fail(call.arguments[0], fmt::format("the list has {} numbers, the segment of degree {} has {} coefficients",
                                        list->elements.size(), node(s).degree, node(s).size()));
  }
  RuleNode made{.is_point = true, .arguments = {s}, .rows = {{}}};
  for (std::size_t j = 0; j < list->elements.size(); ++j) {
    const RationalFunction weight = number_argument(list->elements[j]);
    if (!weight.is_zero()) made.rows[0].push_back({static_cast<int>(j), pooled(weight)});
  }
  return add(std::move(made), e);
}

int SegmentCompiler::compile_again(const Expression& e, const Expression::Call& call) {
  require_arguments(e, call, 1, "again(E)");
  const auto s = compile(call.arguments[0]);
  if (!s || !node(*s).is_point) fail(call.arguments[0], "expected a point");
  // Place k <= 0 is the knot t_{i+k/2}, place k >= 1 is t_{i+(k+1)/2}; at a half one E inserts a point on that
  // interval.
  const auto interval = [](int place) { return place <= 0 ? (place - 1) / 2 : place / 2; };
  RuleNode made{.kind = RuleNode::Kind::again, .is_point = true, .arguments = {*s}};
  for (int place = node(*s).lowest; place <= node(*s).highest; ++place) {
    const bool half = place <= 0 ? place % 2 != 0 : place % 2 == 0;
    const int at = half ? interval(place) : (place <= 0 ? place / 2 : (place + 1) / 2);
    made.lowest = std::min(made.lowest, half ? at + node(*s).lowest : at);
    made.highest = std::max(made.highest, half ? at + node(*s).highest : at);
  }
  return add(std::move(made), e);
}

int SegmentCompiler::compile_operation(const Expression& e, const Expression::Operation& operation) {
  const Expression& first = operation.operands.front();
  const Expression& last = operation.operands.back();
  const auto a = compile(first);
  if (operation.op == '~') return scaled(*a, constant(-1), e);
  const auto b = compile(last);
  const bool any_point = (a && node(*a).is_point) || (b && node(*b).is_point);
  const char* const kind = any_point ? "sampled point" : "segment";
  switch (operation.op) {
    case '+':
    case '-': {
      if (!a || !b)
        fail(e, fmt::format("cannot add a number to a {}{}", kind, any_point ? "" : ": sample it, at(S,u)"));
      if (node(*a).is_point != node(*b).is_point)
        fail(e, "cannot add a segment to a sampled point: sample it, at(S,u)");
      if (node(*a).degree != node(*b).degree || node(*a).pieces != node(*b).pieces) {
        fail(e, fmt::format("cannot add segments of degree {} in {} and degree {} in {} pieces", node(*a).degree,
                            node(*a).pieces, node(*b).degree, node(*b).pieces));
      }
      const int one = pooled(constant(1)), sign = pooled(constant(operation.op == '+' ? 1 : -1)),
                size = node(*a).size();
      spend(std::size_t(2 * size), e);
      RuleNode made{
          .is_point = node(*a).is_point, .degree = node(*a).degree, .pieces = node(*a).pieces, .arguments = {*a, *b}};
      for (int j = 0; j < size; ++j) made.rows.push_back({{j, one}, {size + j, sign}});
      return add(std::move(made), e);
    }
    case '*':
      if (a && b) fail(e, fmt::format("cannot multiply two {}s", kind));
      return scaled(a ? *a : *b, names_.number(a ? last : first), e);
    case '/': {
      if (b) fail(e, fmt::format("cannot divide by a {}", kind));
      const RationalFunction divisor = names_.number(last);
      return scaled(*a, names_.arithmetic().apply('/', constant(1), divisor, e.column), e);
    }
    default:
      throw InternalError("unknown operation in an expression");
  }
}

int SegmentCompiler::scaled(int argument, const RationalFunction& factor, const Expression& e) {
  RuleNode made{.is_point = node(argument).is_point,
                .degree = node(argument).degree,
                .pieces = node(argument).pieces,
                .arguments = {argument}};
  const int number = pooled(factor);
  spend(std::size_t(node(argument).size()), e);
  for (int j = 0; j < node(argument).size(); ++j) made.rows.push_back({{j, number}});
  return add(std::move(made), e);
}

}  // namespace limes
