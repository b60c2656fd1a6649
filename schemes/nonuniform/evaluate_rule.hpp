// Evaluation of a RuleProgram over a field K: rational functions, rationals, or doubles.
#pragma once

#include "algebra/error.hpp"
#include "algebra/expression/bounded_arithmetic.hpp"
#include "schemes/nonuniform/bezier_maps.hpp"
#include "schemes/nonuniform/rule_program.hpp"

namespace limes {

/// Constants and parameters as elements of K. The numbers of a rule are functions of the parameters.
template <class K>
class RuleField;

template <>
class RuleField<RationalFunction> {
 public:
  /// \pre parameters <= variables; the parameters come first
  RuleField(int parameters, int variables) : variables_(variables) {
    for (int k = 0; k < parameters; ++k) map_.push_back(k);
  }
  RationalFunction constant(const Rational& x) const { return RationalFunction::constant(variables_, x); }
  RationalFunction number(const RationalFunction& x) const { return x.mapped(variables_, map_); }
  RationalFunction parameter(int k) const { return RationalFunction::variable(variables_, k); }

 private:
  int variables_;
  std::vector<int> map_;
};

template <>
class RuleField<Rational> {
 public:
  explicit RuleField(std::span<const Rational> parameter_values) : values_(parameter_values) {}
  Rational constant(const Rational& x) const { return x; }
  Rational number(const RationalFunction& x) const { return x.is_constant() ? x.constant_value() : x(values_); }
  Rational parameter(int k) const { return values_[std::size_t(k)]; }

 private:
  std::span<const Rational> values_;
};

template <>
class RuleField<double> {
 public:
  explicit RuleField(std::span<const double> parameter_values)
      : values_(parameter_values.begin(), parameter_values.end()) {}
  double constant(const Rational& x) const { return approx_double(x); }
  double number(const RationalFunction& x) const {
    return approx_double(x.is_constant() ? x.constant_value() : x(values_));
  }
  double parameter(int k) const { return approx_double(values_[std::size_t(k)]); }

 private:
  std::vector<Rational> values_;
};

template <class K>
bool vanishes(const K& x) {
  if constexpr (requires { x.is_zero(); })
    return x.is_zero();
  else
    return x == 0;
}

/// The field, the numbers of a rule in it, and a bound of the work, so that a hostile rule ends in a LimitError.
template <class K>
class RuleNumbers {
 public:
  /// \param arithmetic of rational functions, for rules that nobody has looked at; none: only the operations are counted
  RuleNumbers(const std::vector<RationalFunction>& numbers, RuleField<K> in, BoundedArithmetic* arithmetic = nullptr)
      : field(std::move(in)), arithmetic_(arithmetic) {
    for (const RationalFunction& number : numbers) values.push_back(field.number(number));
  }

  /// a op b for op one of + * /
  K apply(char op, const K& a, const K& b) {
    if constexpr (std::is_same_v<K, RationalFunction>) {
      if (arithmetic_) return arithmetic_->apply(op, a, b, 0);
    }
    return op == '+' ? a + b : op == '*' ? a * b : a / b;
  }

  RuleField<K> field;
  std::vector<K> values;

  void spend(std::size_t operations) {
    work_ += operations;
    if (work_ > 20'000'000) throw LimitError("the rule takes too many operations");
  }

 private:
  std::size_t work_ = 0;
  BoundedArithmetic* arithmetic_;
};

/// The rule around one interval i: knots[k] is t_{i-before+k}, and a point is given by its weights in the knots'
/// points.
template <class K>
class RuleEvaluator {
 public:
  using Point = std::vector<K>;
  /// What divisions were by: pairs of knots.
  using Divisors = std::vector<std::pair<K, K>>;

  RuleEvaluator(const RuleProgram& rule, RuleNumbers<K>& numbers, std::vector<K> knots, int before,
                Divisors* divisors = nullptr)
      : rule_(rule), numbers_(numbers), knots_(std::move(knots)), before_(before), divisors_(divisors) {}

  /// The coefficients of a node on the interval i + shift; one for a point.
  const std::vector<Point>& operator()(int number, int shift) {
    const auto place = known_.find({number, shift});
    if (place != known_.end()) return place->second;
    const RuleNode& node = rule_.nodes[std::size_t(number)];
    return known_.emplace(std::pair(number, shift), evaluate(node, shift)).first->second;
  }

 private:
  std::vector<Point> evaluate(const RuleNode& node, int shift) {
    switch (node.kind) {
      case RuleNode::Kind::interpolant:
        return interpolant(node, shift);
      case RuleNode::Kind::sample:
        return {sample(node, shift)};
      case RuleNode::Kind::map:
        return map(node, shift);
      case RuleNode::Kind::join:
        return join(node, shift);
      case RuleNode::Kind::again:
        return {again(node, shift)};
    }
    throw InternalError("unknown node of a rule");
  }

  std::size_t index(int k) const {
    if (k + before_ < 0 || k + before_ >= static_cast<int>(knots_.size()))
      throw DomainError("the segment needs points beyond the given knots");
    return static_cast<std::size_t>(k + before_);
  }
  const K& knot(int k) const { return knots_[index(k)]; }
  K constant(const Rational& x) const { return numbers_.field.constant(x); }
  Point no_point() const { return Point(knots_.size(), constant(0)); }
  Point given_point(int k) const {
    Point result = no_point();
    result[index(k)] = constant(1);
    return result;
  }

  /// x / (t_to - t_from). All divisions by a function of the knots happen here, and from < to: the divisor is a sum of
  /// intervals.
  K quotient(K x, int from, int to) {
    if (from >= to) throw InternalError("a rule divides by no sum of intervals");
    if (divisors_) divisors_->emplace_back(knot(from), knot(to));
    return numbers_.apply('/', x, knot(to) - knot(from));
  }

  void add(Point& sum, const K& factor, const Point& point) {
    numbers_.spend(sum.size());
    for (std::size_t k = 0; k < sum.size(); ++k) {
      if (!vanishes(point[k])) sum[k] = numbers_.apply('+', sum[k], numbers_.apply('*', factor, point[k]));
    }
  }

  /// prod_{r != s} 1 / (t_s - t_r) over r = first..last.
  K inverse_differences(K x, int s, int first, int last) {
    for (int r = first; r <= last; ++r) {
      if (r < s) x = quotient(std::move(x), r, s);
      if (r > s) x = -quotient(std::move(x), s, r);
    }
    return x;
  }

  /// Lagrange basis polynomials, products of linear factors (t_i - t_r)(1-u) + (t_{i+1} - t_r) u, in Bezier form.
  std::vector<Point> interpolant(const RuleNode& node, int shift) {
    const int degree = node.degree, first = shift + node.offset - degree / 2, last = first + degree;
    numbers_.spend(std::size_t((degree + 1) * (degree + 1) * (degree + 1)));
    std::vector<Point> result(std::size_t(degree + 1), no_point());
    for (int s = first; s <= last; ++s) {
      std::vector<K> product{constant(1)};  // coefficient j of (1-u)^{m-j} u^j
      for (int r = first; r <= last; ++r) {
        if (r == s) continue;
        const K left = knot(shift) - knot(r), right = knot(shift + 1) - knot(r);
        product.push_back(constant(0));
        for (std::size_t j = product.size() - 1; j > 0; --j) product[j] = product[j] * left + product[j - 1] * right;
        product[0] *= left;
      }
      for (int j = 0; j <= degree; ++j) {
        const K& c = product[std::size_t(j)];
        if (vanishes(c)) continue;
        result[std::size_t(j)][index(s)] = inverse_differences(c, s, first, last) * constant(1 / binomial(degree, j));
      }
    }
    return result;
  }

  Point sample(const RuleNode& node, int shift) {
    const int degree = node.interpolant_degree, first = shift + node.offset - degree / 2, last = first + degree;
    const K x = constant(1 - node.u) * knot(shift) + constant(node.u) * knot(shift + 1);
    numbers_.spend(std::size_t((degree + 1) * (degree + 1)));
    Point result = no_point();
    for (int s = first; s <= last; ++s) {
      K weight = constant(1);
      for (int r = first; r <= last; ++r) {
        if (r < s) weight = numbers_.apply('*', weight, quotient(x - knot(r), r, s));
        if (r > s) weight = numbers_.apply('*', weight, quotient(knot(r) - x, s, r));
      }
      result[index(s)] = weight;
    }
    return result;
  }

  std::vector<Point> map(const RuleNode& node, int shift) {
    std::vector<const Point*> columns;
    for (const int argument : node.arguments) {
      for (const Point& coefficient : (*this)(argument, shift)) columns.push_back(&coefficient);
    }
    std::vector<Point> result;
    for (const auto& row : node.rows) {
      Point& sum = result.emplace_back(no_point());
      for (const auto& [column, number] : row)
        add(sum, numbers_.values[std::size_t(number)], *columns[std::size_t(column)]);
    }
    return result;
  }

  std::vector<Point> join(const RuleNode& node, int shift) {
    const int r = node.order, d = node.degree;
    const auto& own = (*this)(node.arguments[0], shift);
    const auto& before = (*this)(node.arguments[0], shift - 1);
    const auto& after = (*this)(node.arguments[0], shift + 1);
    const auto joined = [&](const auto& mine, const auto& theirs, int a, int b, int c) {
      Point sum = no_point();
      const auto term = [&](const K& weight, const Point& point) { add(sum, weight, point); };
      // h: the segment's own interval, g: its neighbour's; (x/g) and the like are quotients by sums of intervals.
      const bool right = b == shift + 1;
      const K h = right ? knot(b) - knot(a) : knot(c) - knot(b), g = right ? knot(c) - knot(b) : knot(b) - knot(a);
      const auto by_g = [&](K x) { return right ? quotient(std::move(x), b, c) : quotient(std::move(x), a, b); };
      const auto by_sum = [&](K x) { return quotient(std::move(x), a, c); };
      const K both = g + h;
      if (r == 1) {  // eq. (3)
        term(by_sum(h), theirs(1));
        term(by_sum(g), mine(1));
      } else if (r == 2) {  // eq. (4)
        term(constant(Rational(-1) / 2) * by_g(h) * by_sum(h), theirs(2));
        term(constant(Rational(1) / 2) * by_g(both), mine(0));
        term(constant(Rational(1) / 2) * by_sum(g), mine(2));
      } else {  // eq. (5)
        const K beta = by_g(h);
        term(constant(Rational(1) / 3) * beta * beta * by_sum(h), theirs(3));
        term(constant(Rational(-1) / 3) * beta * by_g(both), theirs(1));
        term(constant(Rational(2) / 3) * by_g(both), mine(1));
        term(constant(Rational(1) / 3) * by_sum(g), mine(3));
      }
      return sum;
    };
    const auto forward = [](const std::vector<Point>& c) {
      return [&c](int j) -> const Point& { return c[std::size_t(j)]; };
    };
    const auto backward = [d](const std::vector<Point>& c) {
      return [&c, d](int j) -> const Point& { return c[std::size_t(d - j)]; };
    };
    std::vector<Point> result = own;
    result[std::size_t(r - 1)] = joined(forward(own), backward(before), shift - 1, shift, shift + 1);
    result[std::size_t(d - r + 1)] = joined(backward(own), forward(after), shift, shift + 1, shift + 2);
    return result;
  }

  /// Place k <= 0 is the knot t_{i+k/2}, place k >= 1 is t_{i+(k+1)/2}: only the interval i itself is not halved.
  Point again(const RuleNode& node, int shift) {
    const int argument = node.arguments[0];
    const int lowest = rule_.nodes[std::size_t(argument)].lowest, highest = rule_.nodes[std::size_t(argument)].highest;
    std::vector<K> refined;
    std::vector<Point> points;
    for (int place = lowest; place <= highest; ++place) {
      const int twice = 2 * shift + (place <= 0 ? place : place + 1);
      if (twice % 2 == 0) {
        refined.push_back(knot(twice / 2));
        points.push_back(given_point(twice / 2));
      } else {
        const int interval = (twice - 1) / 2;
        refined.push_back(constant(Rational(1) / 2) * (knot(interval) + knot(interval + 1)));
        points.push_back((*this)(argument, interval)[0]);
      }
    }
    RuleEvaluator once_more(rule_, numbers_, std::move(refined), -lowest, divisors_);
    const Point weights = once_more(argument, 0)[0];
    Point sum = no_point();
    for (std::size_t k = 0; k < points.size(); ++k) add(sum, weights[k], points[k]);
    return sum;
  }

  const RuleProgram& rule_;
  RuleNumbers<K>& numbers_;
  std::vector<K> knots_;
  int before_;
  Divisors* divisors_;
  std::map<std::pair<int, int>, std::vector<Point>> known_;
};

}  // namespace limes
