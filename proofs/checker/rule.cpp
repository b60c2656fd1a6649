// SPDX-License-Identifier: MIT
//
// The reader of insertion rules: every mistake of kind, degree and number of arguments is found here, so that what
// remains for the evaluation (stencil.cpp) is whether the rule stays within its 2n points.
//
//     expression = term { ("+" | "-") term }        factor  = "-" factor | primary [ "^" digits ]
//     term       = factor { ("*" | "/") factor }    primary = digits | name | function "(" arguments ")" | "(" .. ")"
#include "proofs/checker/rule.hpp"
#include "proofs/checker/bezier.hpp"
#include "proofs/checker/scanner.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace limes::checker {
namespace {

constexpr int max_degree = 64, max_order = 15, max_height = 1000, max_again_depth = 3;
constexpr std::array vocabulary{"f", "hermite", "degree", "tension", "join", "split", "at", "dot", "again"};

using Node = Rule::Node;

/// A number (a function of the parameters), or a node of the rule, or, as the first argument of dot, a list.
struct Value {
  Fraction number;
  int node = -1;
  std::vector<Fraction> list;
  bool is_list = false;
  bool is_number() const { return node < 0 && !is_list; }
};

class RuleReader : Scanner {
 public:
  RuleReader(Rule& rule, const std::vector<std::string>& parameters, Budget& budget)
      : Scanner("rule", budget), rule_(rule) {
    for (std::size_t k = 0; k < parameters.size(); ++k) names_[parameters[k]].number = {variable(k), constant(1)};
  }

  /// In an order in which every definition follows those that it mentions.
  void define(const Definitions& definitions) {
    std::map<std::string, std::set<std::string>> waiting;  // for definitions that are not read yet
    for (const auto& [name, text] : definitions) {
      const bool is_function = std::find(vocabulary.begin(), vocabulary.end(), name) != vocabulary.end();
      if (!is_name(name) || is_function || name == "gamma" || names_.contains(name) || waiting.contains(name))
        throw Rejected{"scheme", checker::quoted(name) + " cannot be the name of a definition, or is taken"};
      waiting[name] = {};
    }
    for (const auto& [name, text] : definitions) {
      budget_.work(200. * static_cast<double>(text.size()));
      for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t start = i;
        while (i < text.size() && is_name_part(text[i])) ++i;
        if (const std::string word = text.substr(start, i - start); waiting.contains(word)) waiting[name].insert(word);
      }
    }
    while (!waiting.empty()) {
      const std::size_t before = waiting.size();
      for (const auto& [name, text] : definitions) {
        const auto found = waiting.find(name);
        if (found == waiting.end() || !found->second.empty()) continue;
        names_[name] = whole(text);
        waiting.erase(found);
        for (auto& [other, mentioned] : waiting) mentioned.erase(name);
      }
      if (waiting.size() == before)
        throw Rejected{"scheme",
                       "the definition of " + checker::quoted(waiting.begin()->first) + " is part of a cycle, or needs one"};
    }
  }
  int point(std::string_view text) {
    const Value value = whole(text);
    if (value.is_number() || !node(value).is_point) fail("is no point");
    return value.node;
  }

 private:
  Value whole(std::string_view text) {
    start(text);
    Value result = expression();
    if (!at_end()) fail("has an unexpected character");
    if (result.is_number()) remember(result.number);
    return result;
  }
  Value expression() {
    enter();
    Value result = term();
    for (;;) {
      const bool minus = take('-');
      if (!minus && !take('+')) break;
      result = combination(result, term(), minus);
    }
    leave();
    return result;
  }
  Value term() {
    Value result = factor();
    for (;;) {
      if (take('*')) {
        Value x = factor();
        if (!x.is_number()) std::swap(x, result);
        if (!x.is_number()) fail("multiplies two segments or points");
        result = multiple(result, x.number);
      } else if (take('/')) {
        const Value x = factor();
        if (!x.is_number()) fail("divides by a segment or a point");
        if (x.number.numerator.empty()) fail("divides by zero");
        result = multiple(result, quotient({constant(1)}, x.number, budget_));
      } else {
        return result;
      }
    }
  }
  Value factor() {
    if (take('-')) {
      enter();
      const Value result = multiple(factor(), {constant(-1)});
      leave();
      return result;
    }
    Value base = primary();
    if (!take('^')) return base;
    if (!base.is_number()) fail("has a power of a segment or a point");
    base.number = power(base.number, exponent(), budget_);
    return base;
  }
  Value primary() {
    if (take('(')) {
      Value result = expression();
      expect(')');
      return result;
    }
    if (mpq_class value; take_natural(value)) return number({constant(value)});
    const std::string name(token(is_name_part));
    if (std::find(vocabulary.begin(), vocabulary.end(), name) != vocabulary.end()) return call(name);
    const auto found = names_.find(name);
    if (found == names_.end()) fail("has an unknown name or character");
    return found->second;
  }
  Value call(const std::string& name) {
    enter();
    expect('(');
    std::vector<Value> arguments;
    if (name == "dot") {
      arguments.emplace_back().is_list = true;
      expect('[');
      do {
        const Value element = expression();
        if (!element.is_number()) fail("needs numbers in the list");
        arguments[0].list.push_back(element.number);
      } while (take(','));
      expect(']');
      expect(',');
    }
    do arguments.push_back(expression());
    while (take(','));
    expect(')');
    leave();
    const auto count = [&](std::size_t n) {
      if (arguments.size() != n) fail(name + " needs " + std::to_string(n) + " arguments");
    };
    if (name == "split" && arguments.size() == 3) return split(arguments);
    count(name == "hermite" ? 3 : name == "again" ? 1 : 2);
    if (name == "f") return interpolant(arguments);
    if (name == "hermite") return hermite(arguments);
    if (name == "degree") return degree(arguments);
    if (name == "tension") return tension(arguments);
    if (name == "join") return join(arguments);
    if (name == "split") return split(arguments);
    if (name == "at") return at(arguments);
    if (name == "dot") return dot(arguments);
    return again(arguments);
  }

  // ---- arguments and results

  const Node& node(const Value& value) const { return rule_.nodes[static_cast<std::size_t>(value.node)]; }
  static Value number(const Fraction& fraction) {
    Value result;
    result.number = fraction;
    return result;
  }
  void remember(const Fraction& number) {
    if (number.denominator != constant(1)) rule_.divisors[number.denominator] = 1;
  }
  mpq_class rational(const Value& value) {
    const Polynomial& p = value.number.numerator;
    if (!value.is_number() || value.number.denominator != constant(1) || p.size() > 1) fail("needs a rational number");
    if (!p.empty() && p.begin()->first != Exponents{}) fail("needs a rational number");
    return p.empty() ? mpq_class(0) : p.begin()->second;
  }
  int integer(const Value& value, int low, int high) {
    const mpq_class x = rational(value);
    if (x.get_den() != 1 || x < low || x > high)
      fail("needs an integer from " + std::to_string(low) + " to " + std::to_string(high));
    return static_cast<int>(x.get_num().get_si());
  }
  const Node& segment(const Value& value, bool one_piece = true) {
    if (value.is_number() || node(value).is_point) fail("needs a segment");
    if (one_piece && node(value).pieces > 1) fail("needs a segment in one piece");
    return node(value);
  }
  Value add(Node made) {
    std::size_t entries = 1;
    for (const auto& row : made.rows) entries += row.size();
    budget_.work(500. * static_cast<double>(entries));
    budget_.hold(500 + 250. * static_cast<double>(entries));
    for (const int k : made.arguments) {
      const Node& argument = rule_.nodes[static_cast<std::size_t>(k)];
      made.height = std::max(made.height, argument.height + 1);
      made.again_depth = std::max(made.again_depth, argument.again_depth + (made.kind == Node::Kind::again ? 1 : 0));
    }
    if (made.height > max_height) fail("combines more than 1000 segments and points in a row");
    if (made.again_depth > max_again_depth) fail("has again more than 3 deep");
    rule_.nodes.push_back(std::move(made));
    Value result;
    result.node = static_cast<int>(rule_.nodes.size()) - 1;
    return result;
  }
  static Node like(const Node& x) {
    Node result;
    result.is_point = x.is_point, result.degree = x.degree, result.pieces = x.pieces;
    return result;
  }
  static void put(Node& made, std::size_t row, int column, const mpq_class& weight) {
    if (weight != 0) made.rows[row].emplace_back(column, constant(weight));
  }

  // ---- combinations

  Value combination(const Value& x, const Value& y, bool minus) {
    const Fraction sign{constant(minus ? -1 : 1)};
    if (x.is_number() && y.is_number()) return number(sum(x.number, product(sign, y.number, budget_), budget_));
    if (x.is_number() || y.is_number()) fail("adds a number to a segment or a point");
    Node made = like(node(x));
    if (made.is_point != node(y).is_point || made.degree != node(y).degree || made.pieces != node(y).pieces)
      fail("adds segments or points of different form");
    made.arguments = {x.node, y.node};
    for (int i = 0; i < made.size(); ++i) made.rows.push_back({{i, constant(1)}, {made.size() + i, sign.numerator}});
    return add(std::move(made));
  }
  Value multiple(const Value& x, const Fraction& factor) {
    if (x.is_number()) return number(product(x.number, factor, budget_));
    Node made = like(node(x));
    made.arguments = {x.node};
    weigh(made, std::vector<Fraction>(1, factor));
    const Polynomial weight = made.rows[0].empty() ? Polynomial{} : made.rows[0][0].second;
    made.rows.assign(static_cast<std::size_t>(made.size()), {});
    for (int i = 0; i < made.size() && !weight.empty(); ++i)
      made.rows[static_cast<std::size_t>(i)].emplace_back(i, weight);
    return add(std::move(made));
  }
  /// One row of weights, brought to a common denominator.
  void weigh(Node& made, const std::vector<Fraction>& weights) {
    for (const auto& weight : weights) {
      remember(weight);
      if (weight.denominator != constant(1)) made.divisors[weight.denominator] = 1;
    }
    made.rows.emplace_back();
    for (std::size_t j = 0; j < weights.size(); ++j) {
      Polynomial weight = weights[j].numerator;
      for (const auto& [divisor, exponent] : made.divisors)
        if (divisor != weights[j].denominator) weight = multiply(weight, divisor, budget_);
      if (!weight.empty()) made.rows.back().emplace_back(static_cast<int>(j), std::move(weight));
    }
  }

  // ---- the vocabulary

  Value interpolant(const std::vector<Value>& arguments) {
    Node made;
    made.kind = Node::Kind::interpolant;
    made.degree = made.order = integer(arguments[0], 0, max_degree - 1);
    made.offset = integer(arguments[1], -max_degree, max_degree);
    return add(std::move(made));
  }
  Value hermite(const std::vector<Value>& arguments) {
    Node made;
    const int r = integer(arguments[0], 0, max_order), m = segment(arguments[1]).degree,
              n = segment(arguments[2]).degree;
    made.degree = 2 * r + 1;
    made.arguments = {arguments[1].node, arguments[2].node};
    made.rows.resize(static_cast<std::size_t>(made.size()));
    const Rows left = jet_rows(m, made.degree, r), right = jet_rows(n, made.degree, r);
    for (std::size_t i = 0; i < left.size(); ++i) {
      for (int j = 0; j <= m; ++j) put(made, i, j, left[i][static_cast<std::size_t>(j)]);
      for (int j = 0; j <= n; ++j)
        put(made, made.rows.size() - 1 - i, m + 1 + n - j, right[i][static_cast<std::size_t>(j)]);
    }
    return add(std::move(made));
  }
  Value from_rows(const Value& argument, const Rows& rows, int degree, int pieces) {
    Node made;
    made.degree = degree, made.pieces = pieces;
    made.arguments = {argument.node};
    made.rows.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j) put(made, i, static_cast<int>(j), rows[i][j]);
    return add(std::move(made));
  }
  Value degree(const std::vector<Value>& arguments) {
    const int to = integer(arguments[0], 0, max_degree), from = segment(arguments[1]).degree;
    if (from > to) fail("cannot lower a degree");
    budget_.work(500. * (to + 1) * (from + 1) * (to + 1));
    return from_rows(arguments[1], jet_rows(from, to, to), to, 1);
  }
  Value tension(const std::vector<Value>& arguments) {
    if (!arguments[0].is_number()) fail("needs a number");
    const Fraction& c = arguments[0].number;
    Node made = like(segment(arguments[1]));
    if (made.degree % 2 == 0) fail("tension needs a segment of odd degree");
    made.arguments = {arguments[1].node};
    remember(c);
    // (1-c)^{i-s} c^s with the denominator q^r, c = p / q.
    const int r = made.degree / 2;
    std::vector<Polynomial> p{constant(1)}, q{constant(1)}, d{constant(1)};  // powers of p, q, q - p
    const Polynomial rest = checker::add(c.denominator, multiply(c.numerator, constant(-1), budget_), budget_);
    for (int k = 0; k < r; ++k) {
      p.push_back(multiply(p.back(), c.numerator, budget_));
      q.push_back(multiply(q.back(), c.denominator, budget_));
      d.push_back(multiply(d.back(), rest, budget_));
    }
    if (c.denominator != constant(1) && r > 0) made.divisors[c.denominator] = r;
    made.rows.resize(static_cast<std::size_t>(made.size()));
    for (int i = 0; i <= r; ++i) {
      for (int s = 0; s <= i; ++s) {
        const auto place = [](int k) { return static_cast<std::size_t>(k); };
        Polynomial weight = multiply(multiply(p[place(s)], d[place(i - s)], budget_), q[place(r - i)], budget_);
        weight = multiply(weight, constant(binomial(i, s)), budget_);
        if (weight.empty()) continue;
        made.rows[place(i)].emplace_back(s, weight);
        made.rows[place(made.degree - i)].emplace_back(made.degree - s, weight);
      }
    }
    return add(std::move(made));
  }
  Value join(const std::vector<Value>& arguments) {
    const int r = integer(arguments[0], 1, 3);
    Node made = like(segment(arguments[1]));
    if (made.degree < 2 * r) fail("join(r, S) needs a segment of degree at least 2r");
    made.kind = Node::Kind::join;
    made.order = r;
    made.arguments = {arguments[1].node};
    return add(std::move(made));
  }
  Value split(const std::vector<Value>& arguments) {
    const int r = integer(arguments[0], 1, max_order), from = segment(arguments[1]).degree;
    const int pieces = arguments.size() == 2 ? r + 1 : integer(arguments[2], 1, r + 1);
    budget_.work(3000. * pieces * (r + 2) * (r + 2) * (from + 2 * r));
    const Rows rows = split_rows(from, r, pieces);
    if (rows.empty()) fail("has too few pieces in split");
    return from_rows(arguments[1], rows, r + 1, pieces);
  }
  Value at(const std::vector<Value>& arguments) {
    const Node& s = segment(arguments[0], false);
    const mpq_class u = rational(arguments[1]) * s.pieces;
    const double size = s.degree * limbs(u);
    budget_.work((s.degree + 1.) * (s.degree + 1.) * 2 * cost(size));
    budget_.hold((s.degree + 1.) * 8 * size);
    int piece = 0;
    while (piece + 1 < s.pieces && piece + 1 <= u) ++piece;
    Rows row(1, Vector(static_cast<std::size_t>(s.size())));
    for (int j = 0; j <= s.degree; ++j)
      row[0][static_cast<std::size_t>(piece * (s.degree + 1) + j)] =
          binomial(s.degree, j) * power(1 - (u - piece), s.degree - j) * power(u - piece, j);
    const Value result = from_rows(arguments[0], row, 0, 1);
    rule_.nodes.back().is_point = true;
    return result;
  }
  static double cost(double size) { return 300 + 4 * size * size; }
  Value dot(const std::vector<Value>& arguments) {
    if (static_cast<int>(arguments[0].list.size()) != segment(arguments[1]).size())
      fail("needs as many numbers in the list as the segment has coefficients");
    Node made;
    made.is_point = true;
    made.arguments = {arguments[1].node};
    weigh(made, arguments[0].list);
    return add(std::move(made));
  }
  Value again(const std::vector<Value>& arguments) {
    if (arguments[0].is_number() || !node(arguments[0]).is_point) fail("again needs a point");
    Node made;
    made.kind = Node::Kind::again;
    made.is_point = true;
    made.arguments = {arguments[0].node};
    return add(std::move(made));
  }

  Rule& rule_;
  std::map<std::string, Value> names_;
};

}  // namespace

Rule read_rule(const Definitions& definitions, std::string_view rule, const std::vector<std::string>& parameters,
               int points, Budget& budget) {
  Rule result;
  result.points = points;
  result.gamma = parameters.size();
  RuleReader reader(result, parameters, budget);
  reader.define(definitions);
  result.root = reader.point(rule);
  return result;
}

Rule read_coefficients(const std::vector<std::string>& texts, const std::vector<std::string>& parameters,
                       Budget& budget) {
  Rule result;
  result.points = static_cast<int>(texts.size());
  result.gamma = parameters.size();
  std::vector<std::string> names = parameters;
  for (int k = 1; k <= result.points - 2; ++k) {
    names.push_back("b" + std::to_string(k));
    if (std::count(parameters.begin(), parameters.end(), names.back()) > 0)
      throw Rejected{"scheme", "the parameter " + names.back() + " has the name of a ratio"};
  }
  if (names.size() > max_variables) throw Rejected{"scheme", "there are more than 16 parameters and ratios"};
  for (const auto& text : texts) {
    result.coefficients.push_back(read_expression(text, names, budget));
    // The denominator, as a polynomial in the ratios: all coefficients are positive multiples of one polynomial in the
    // parameters, so for positive ratios it vanishes only where that one does.
    std::map<Exponents, Polynomial> by_ratios;
    for (const auto& [exponents, c] : result.coefficients.back().denominator) {
      Exponents own{}, ratios{};
      for (std::size_t k = 0; k < names.size(); ++k) (k < parameters.size() ? own : ratios)[k] = exponents[k];
      by_ratios[ratios][own] = c;
    }
    const Polynomial& first = by_ratios.begin()->second;
    for (const auto& [ratios, polynomial] : by_ratios) {
      const mpq_class multiple = polynomial.rbegin()->second / first.rbegin()->second;
      if (multiple <= 0 || multiply(first, constant(multiple), budget) != polynomial)
        throw Rejected{"scheme", "the denominator of " + checker::quoted(text) +
                                     " is no polynomial in the parameters times one of one sign in the ratios"};
    }
    const Polynomial divisor = multiply(first, constant(1 / mpq_class(first.rbegin()->second)), budget);
    if (divisor != constant(1)) result.divisors[divisor] = 1;
  }
  return result;
}

}  // namespace limes::checker
