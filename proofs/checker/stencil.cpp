// SPDX-License-Identifier: MIT
//
// The evaluation of a rule over fractions whose denominators are products of known polynomials: sums of intervals (the
// only functions of the knots by which the vocabulary divides) and divisors in the parameters. Every coefficient of a
// segment is kept as its weights at the points, and no operation mixes the weights at different points; so each point
// has a denominator of its own.
#include "proofs/checker/rule.hpp"

#include <algorithm>
#include <tuple>

namespace limes::checker {
namespace {

using Node = Rule::Node;

/// a + b gamma: a knot or a difference of knots.
struct Linear {
  mpq_class a, b;
};
Linear operator+(const Linear& x, const Linear& y) { return {x.a + y.a, x.b + y.b}; }
Linear operator-(const Linear& x, const Linear& y) { return {x.a - y.a, x.b - y.b}; }

/// The weights at one point of the coefficients of a segment, or of a point.
struct Column {
  Divisors denominator;
  std::vector<Polynomial> numerators;
};
using Columns = std::vector<Column>;  // one for each knot of the context

/// Knots t_{i+first}, t_{i+first+1}, .. around an interval i, with a point at each of them.
struct Context {
  std::vector<Linear> knots;
  int first = 0;
};

class Evaluator {
 public:
  Evaluator(const Rule& rule, Context context, Budget& budget) : rule_(rule), budget_(budget) {
    contexts_.push_back(std::move(context));
  }

  /// A node on the interval [t_{i+shift}, t_{i+shift+1}] of a context.
  const Columns& value(std::size_t context, int node_index, int shift) {
    const auto key = std::tuple{context, node_index, shift};
    if (const auto found = values_.find(key); found != values_.end()) return found->second;
    budget_.work(1000);
    budget_.hold(200 + 100. * static_cast<double>(contexts_[context].knots.size()));
    const Node& node = rule_.nodes[static_cast<std::size_t>(node_index)];
    Columns result;
    if (node.kind == Node::Kind::interpolant) result = interpolant(context, node, shift);
    if (node.kind == Node::Kind::map) result = map(context, node, shift);
    if (node.kind == Node::Kind::join) result = join(context, node, shift);
    if (node.kind == Node::Kind::again) result = again(context, node, shift);
    return values_[key] = std::move(result);
  }

  /// Numerators over the least common multiple of the denominators and `divisors`, after division by the linear forms
  /// that divide a numerator.
  Stencil over_common_denominator(Columns columns, const Divisors& divisors) {
    Divisors all = divisors;
    for (auto& column : columns) {
      cancel(column);
      all = least_common_multiple(all, column.denominator);
    }
    Stencil result{missing({}, all), {}};
    for (const auto& column : columns)
      result.numerators.push_back(
          column.numerators.empty() ? Polynomial{} : times(column.numerators[0], missing(column.denominator, all)));
    return result;
  }

  Columns zero(std::size_t context) const { return Columns(contexts_[context].knots.size()); }

 private:
  Polynomial times(const Polynomial& p, const Polynomial& q) { return multiply(p, q, budget_); }
  Polynomial polynomial(const Linear& x) {
    return add(constant(x.a), multiply(variable(rule_.gamma), constant(x.b), budget_), budget_);
  }

  // ---- denominators

  static Divisors least_common_multiple(Divisors x, const Divisors& y) {
    for (const auto& [divisor, exponent] : y) x[divisor] = std::max(x[divisor], exponent);
    return x;
  }
  /// all / part
  Polynomial missing(const Divisors& part, const Divisors& all) {
    Polynomial result = constant(1);
    for (const auto& [divisor, exponent] : all) {
      const auto found = part.find(divisor);
      for (int k = found == part.end() ? 0 : found->second; k < exponent; ++k) result = times(result, divisor);
    }
    return result;
  }
  /// Divides by a power of a difference of two knots of which the second is the greater one. That they are strictly
  /// increasing for every gamma > 0, a, b >= 0 and not both 0, is what makes the quotient free of poles.
  void divide(Divisors& denominator, mpq_class& scale, const Linear& x, int exponent) {
    if (x.a < 0 || x.b < 0 || (x.a == 0 && x.b == 0))
      throw Rejected{"scheme", "the rule divides by something that is no sum of intervals"};
    for (int k = 0; k < exponent; ++k) scale /= x.b == 0 ? x.a : x.b;
    if (x.b != 0) denominator[polynomial({x.a / x.b, 1})] += exponent;
  }
  void cancel(Column& column) {
    if (column.numerators.empty() || column.numerators[0].empty()) return column.denominator.clear();
    for (auto divisor = column.denominator.begin(); divisor != column.denominator.end();) {
      const bool linear = divisor->first.rbegin()->first == variable(rule_.gamma).begin()->first;
      const mpq_class root = linear && divisor->first.size() == 2 ? mpq_class(-divisor->first.begin()->second) : 0;
      const bool own = linear && divisor->first.begin()->first == Exponents{};  // gamma + a with a constant a
      while ((own || divisor->first == variable(rule_.gamma)) && divisor->second > 0 &&
             substitute(column.numerators[0], rule_.gamma, root, budget_).empty()) {
        column.numerators[0] = quotient_by_root(column.numerators[0], root);
        --divisor->second;
      }
      divisor = divisor->second == 0 ? column.denominator.erase(divisor) : std::next(divisor);
    }
  }
  /// p / (gamma - root), which is a polynomial.
  Polynomial quotient_by_root(const Polynomial& p, const mpq_class& root) {
    Polynomial result;
    const Exponents gamma = variable(rule_.gamma).begin()->first;
    const int n = degree(p, rule_.gamma);
    Polynomial carry;  // without gamma: the coefficients of the quotient, from the highest
    for (int k = n; k > 0; --k) {
      carry = times(carry, constant(root));
      for (const auto& [exponents, c] : p) {
        if (exponents[rule_.gamma] != k) continue;
        Exponents others = exponents;
        others[rule_.gamma] = 0;
        carry = add(std::move(carry), {{others, c}}, budget_);
      }
      Exponents shift = gamma;
      shift[rule_.gamma] = static_cast<std::uint16_t>(k - 1);
      result = add(std::move(result), times(carry, {{shift, 1}}), budget_);
    }
    return result;
  }

  // ---- the vocabulary

  const Linear& knot(std::size_t context, int index) const {
    const Context& c = contexts_[context];
    const int place = index - c.first;
    if (place < 0 || place >= static_cast<int>(c.knots.size()))
      throw Rejected{"scheme", "the rule depends on more than its 2n points"};
    return c.knots[static_cast<std::size_t>(place)];
  }
  std::size_t place(std::size_t context, int index) const {
    knot(context, index);
    return static_cast<std::size_t>(index - contexts_[context].first);
  }

  /// Lagrange's weights prod_{r != q} (x(u) - t_r) / (t_q - t_r): with x(u) = t_i (1-u) + t_{i+1} u each factor is
  /// linear in (1-u, u), and products of such are convolutions of binomially scaled coefficients.
  Columns interpolant(std::size_t context, const Node& node, int shift) {
    Columns result = zero(context);
    const Linear start = knot(context, shift), end = knot(context, shift + 1);
    const int first = shift + node.offset - node.order / 2, last = first + node.order;
    for (int q = first; q <= last; ++q) {
      Column& column = result[place(context, q)];
      std::vector<Polynomial> product{constant(1)};
      mpq_class scale = 1;
      for (int r = first; r <= last; ++r) {
        if (r == q) continue;
        const Linear &t = knot(context, r), &own = knot(context, q);
        divide(column.denominator, scale, r < q ? own - t : t - own, 1);
        if (r > q) scale = -scale;
        const Polynomial at_start = polynomial(start - t), at_end = polynomial(end - t);
        std::vector<Polynomial> next(product.size() + 1);
        for (std::size_t j = 0; j < product.size(); ++j) {
          next[j] = add(std::move(next[j]), times(product[j], at_start), budget_);
          next[j + 1] = times(product[j], at_end);
        }
        product = std::move(next);
      }
      mpz_class binomial = 1;
      for (std::size_t j = 0; j < product.size(); ++j) {
        column.numerators.push_back(times(product[j], constant(scale / mpq_class(binomial))));
        binomial = binomial * (product.size() - 1 - j) / (j + 1);
      }
    }
    return result;
  }

  Columns map(std::size_t context, const Node& node, int shift) {
    std::vector<const Columns*> arguments;
    for (const int argument : node.arguments) arguments.push_back(&value(context, argument, shift));
    Columns result = zero(context);
    for (std::size_t q = 0; q < result.size(); ++q) {
      Divisors common;
      for (const Columns* argument : arguments) common = least_common_multiple(common, (*argument)[q].denominator);
      std::vector<Polynomial> all;  // the coefficients of all arguments over the common denominator
      bool any = false;
      for (std::size_t k = 0; k < arguments.size(); ++k) {
        const Column& column = (*arguments[k])[q];
        const Polynomial factor = missing(column.denominator, common);
        const auto size = static_cast<std::size_t>(rule_.nodes[static_cast<std::size_t>(node.arguments[k])].size());
        for (std::size_t j = 0; j < size; ++j)
          all.push_back(column.numerators.empty() ? Polynomial{} : times(column.numerators[j], factor));
        any = any || !column.numerators.empty();
      }
      if (!any) continue;
      for (const auto& row : node.rows) {
        Polynomial sum;
        for (const auto& [j, weight] : row)
          sum = add(std::move(sum), times(weight, all[static_cast<std::size_t>(j)]), budget_);
        result[q].numerators.push_back(std::move(sum));
      }
      for (const auto& [divisor, exponent] : node.divisors) common[divisor] += exponent;
      result[q].denominator = std::move(common);
    }
    return result;
  }

  /// Coefficient r-1 from one end, of a segment over an interval of length h next to one of length g, by eqs. (3)-(5)
  /// of Karciauskas & Peters 2013 with beta = h / g, over the common denominator r g^{r-1} (g + h).
  Columns join(std::size_t context, const Node& node, int shift) {
    const int argument = node.arguments[0], r = node.order, m = node.degree;
    const Columns& own = value(context, argument, shift);
    Columns result = own;
    for (const bool at_end : {false, true}) {
      const Columns& other = value(context, argument, at_end ? shift + 1 : shift - 1);
      const Linear h = knot(context, shift + 1) - knot(context, shift);
      const Linear g = at_end ? knot(context, shift + 2) - knot(context, shift + 1)
                              : knot(context, shift) - knot(context, shift - 1);
      const Polynomial H = polynomial(h), G = polynomial(g), S = polynomial(g + h);
      struct Term {
        bool own;
        int index;  // counted from the common knot
        Polynomial weight;
      };
      std::vector<Term> terms;
      if (r == 1) terms = {{true, 1, G}, {false, 1, H}};
      if (r == 2)
        terms = {{false, 2, times(times(H, H), constant(-1))}, {true, 0, times(S, S)}, {true, 2, times(G, G)}};
      if (r == 3)
        terms = {{false, 3, times(times(H, H), H)},
                 {false, 1, times(times(H, constant(-1)), times(S, S))},
                 {true, 1, times(times(G, constant(2)), times(S, S))},
                 {true, 3, times(times(G, G), G)}};
      for (std::size_t q = 0; q < result.size(); ++q) {
        if (own[q].numerators.empty() && other[q].numerators.empty()) continue;
        const Divisors both = least_common_multiple(own[q].denominator, other[q].denominator);
        Polynomial sum;
        for (const auto& [is_own, index, weight] : terms) {
          const Column& column = is_own ? own[q] : other[q];
          if (column.numerators.empty()) continue;
          const auto k = static_cast<std::size_t>(is_own == at_end ? m - index : index);
          const std::size_t from = is_own ? k : static_cast<std::size_t>(at_end ? index : m - index);
          sum = add(std::move(sum), times(times(weight, column.numerators[from]), missing(column.denominator, both)),
                    budget_);
        }
        Column changed{both, {}};
        mpq_class scale = mpq_class(1) / r;
        divide(changed.denominator, scale, g, r - 1);
        divide(changed.denominator, scale, g + h, 1);
        replace(result[q], static_cast<std::size_t>(at_end ? m - (r - 1) : r - 1), changed.denominator,
                times(sum, constant(scale)), static_cast<std::size_t>(m + 1));
      }
    }
    return result;
  }
  /// Coefficient `index` := numerator / denominator.
  void replace(Column& column, std::size_t index, const Divisors& denominator, const Polynomial& numerator,
               std::size_t size) {
    column.numerators.resize(size);
    const Divisors common = least_common_multiple(column.denominator, denominator);
    const Polynomial factor = missing(column.denominator, common);
    for (auto& p : column.numerators) p = times(p, factor);
    column.numerators[index] = times(numerator, missing(denominator, common));
    column.denominator = common;
  }

  /// The argument on the knots of places .., -2, -1, 0, 1, 2, 3, ..: t_{i-1}, t_{i-1/2}, t_i, t_{i+1}, t_{i+3/2},
  /// t_{i+2}, .., with the points that the argument itself inserts at the half ones.
  Columns again(std::size_t context, const Node& node, int shift) {
    const int argument = node.arguments[0];
    const auto [known, fresh] = refined_.try_emplace({context, shift}, contexts_.size());
    const std::size_t refined = known->second;
    const int low = contexts_[context].first, high = low + static_cast<int>(contexts_[context].knots.size()) - 1;
    knot(context, shift), knot(context, shift + 1);
    if (fresh) {
      Context made;
      made.first = 2 * (low - shift);
      for (int k = low; k <= high; ++k) {
        made.knots.push_back(knot(context, k));
        if (k == high || k == shift) continue;
        const Linear sum = knot(context, k) + knot(context, k + 1);
        made.knots.push_back({sum.a / 2, sum.b / 2});
      }
      contexts_.push_back(std::move(made));
    }
    const Columns weights = value(refined, argument, 0);
    Columns result = zero(context);
    for (std::size_t q = 0; q < weights.size(); ++q) {
      const Column& weight = weights[q];
      if (weight.numerators.empty() || weight.numerators[0].empty()) continue;
      const int at = contexts_[refined].first + static_cast<int>(q);
      const bool half = at <= 0 ? at % 2 != 0 : at % 2 == 0;
      const int index = shift + (at <= 0 ? (at - (half ? 1 : 0)) / 2 : (at + 1) / 2);  // of the (left) knot
      if (!half) {
        accumulate(result[place(context, index)], weight.denominator, weight.numerators[0]);
        continue;
      }
      const Columns& inserted = value(context, argument, index);
      for (std::size_t k = 0; k < result.size(); ++k) {
        if (inserted[k].numerators.empty()) continue;
        Divisors denominator = weight.denominator;
        for (const auto& [divisor, exponent] : inserted[k].denominator) denominator[divisor] += exponent;
        accumulate(result[k], denominator, times(weight.numerators[0], inserted[k].numerators[0]));
      }
    }
    return result;
  }
  void accumulate(Column& sum, const Divisors& denominator, const Polynomial& numerator) {
    sum.numerators.resize(1);
    const Divisors common = least_common_multiple(sum.denominator, denominator);
    sum.numerators[0] = add(times(sum.numerators[0], missing(sum.denominator, common)),
                            times(numerator, missing(denominator, common)), budget_);
    sum.denominator = common;
  }

  const Rule& rule_;
  Budget& budget_;
  std::vector<Context> contexts_;
  std::map<std::tuple<std::size_t, int, int>, Columns> values_;
  std::map<std::pair<std::size_t, int>, std::size_t> refined_;
};

/// p(parameters, b_1 .. b_{2n-2}) at ratios 1 but b_{2n-1-k}, which is gamma (k = 1..2n-2).
Polynomial at_isolated_ratio(const Rule& rule, Polynomial p, int k, Budget& budget) {
  for (int j = 1; j <= rule.points - 2; ++j)
    if (j != rule.points - 1 - k) p = substitute(p, rule.gamma + static_cast<std::size_t>(j) - 1, 1, budget);
  Polynomial result;
  const std::size_t own = rule.gamma + static_cast<std::size_t>(rule.points - 2 - k);
  for (const auto& [exponents, c] : p) {
    Exponents moved = exponents;
    if (k > 0 && k < rule.points - 1) moved[own] = 0, moved[rule.gamma] = exponents[own];
    result[moved] = c;
  }
  return result;
}

}  // namespace

Stencil isolated_stencil(const Rule& rule, int k, Budget& budget) {
  const int n = rule.points / 2;
  Context context;
  context.first = 1 - n;
  for (int j = k + 1 - rule.points; j <= k; ++j)
    context.knots.push_back(j <= 0 ? Linear{mpq_class(j), 0} : Linear{0, mpq_class(j)});
  Evaluator evaluator(rule, std::move(context), budget);
  if (rule.coefficients.empty())
    return evaluator.over_common_denominator(evaluator.value(0, rule.root, 0), k == 0 ? rule.divisors : Divisors{});
  Columns columns = evaluator.zero(0);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const Polynomial denominator = at_isolated_ratio(rule, rule.coefficients[j].denominator, k, budget);
    const Polynomial scale = constant(1 / mpq_class(denominator.rbegin()->second));
    columns[j].numerators.push_back(
        multiply(at_isolated_ratio(rule, rule.coefficients[j].numerator, k, budget), scale, budget));
    if (denominator.size() > 1 || denominator.begin()->first != Exponents{})
      columns[j].denominator[multiply(denominator, scale, budget)] = 1;
  }
  return evaluator.over_common_denominator(std::move(columns), k == 0 ? rule.divisors : Divisors{});
}

}  // namespace limes::checker
