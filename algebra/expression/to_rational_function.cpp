// Evaluation with bounds that are checked before each operation: the size of a result is estimated from above, so that
// an expression such as ((1+w)^1000)^1000 is refused instead of computed.
#include "algebra/expression/expression.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace limes {

namespace {

constexpr double max_degree = 1000;
constexpr double max_terms = 100000;
constexpr double max_digits = 10000;
// In units of about a nanosecond: what one expression may cost altogether.
constexpr double max_work = 2e9;

// Upper bounds of the size of a polynomial on one common denominator.
struct Size {
  std::vector<int> degrees;
  double total_degree = 0;
  double terms = 0;
  double numerator_digits = 1;
  double denominator_digits = 1;

  // The number of monomials that fit below the degrees.
  double dense_terms() const {
    double box = 1;
    double simplex = 1;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      box *= degrees[i] + 1;
      simplex *= (total_degree + double(i) + 1) / (double(i) + 1);
    }
    return std::min(box, std::ceil(simplex));
  }
  double digits() const { return std::max(numerator_digits, denominator_digits); }
};

double digit_count(const Integer& x) { return x == 0 ? 1 : 1 + 0.30103 * double(msb(abs(x))); }

Size measure(const MultivariatePolynomial& p) {
  Size size;
  size.degrees = p.degrees();
  Integer common = 1;
  for (const auto& term : p.terms()) {
    double degree = 0;
    for (const int exponent : term.exponents) degree += exponent;
    size.total_degree = std::max(size.total_degree, degree);
    size.numerator_digits = std::max(size.numerator_digits, digit_count(numerator(term.coefficient)));
    if (const Integer d = denominator(term.coefficient); d != common) common = lcm(common, d);
    ++size.terms;
  }
  if (common != 1) {
    size.denominator_digits = digit_count(common);
    size.numerator_digits += size.denominator_digits;
  }
  return size;
}

Size product(const Size& a, const Size& b) {
  Size size;
  for (std::size_t i = 0; i < a.degrees.size(); ++i) size.degrees.push_back(a.degrees[i] + b.degrees[i]);
  size.total_degree = a.total_degree + b.total_degree;
  size.terms = std::min(a.terms * b.terms, size.dense_terms());
  size.numerator_digits = a.numerator_digits + b.numerator_digits + std::log10(1 + std::min(a.terms, b.terms));
  size.denominator_digits = a.denominator_digits + b.denominator_digits;
  return size;
}

Size sum(const Size& a, const Size& b) {
  Size size;
  for (std::size_t i = 0; i < a.degrees.size(); ++i) size.degrees.push_back(std::max(a.degrees[i], b.degrees[i]));
  size.total_degree = std::max(a.total_degree, b.total_degree);
  size.terms = std::min(a.terms + b.terms, size.dense_terms());
  if (a.denominator_digits == 1 && b.denominator_digits == 1) {
    size.numerator_digits = 1 + std::max(a.numerator_digits, b.numerator_digits);
  } else {
    size.numerator_digits =
        1 + std::max(a.numerator_digits + b.denominator_digits, b.numerator_digits + a.denominator_digits);
    size.denominator_digits = a.denominator_digits + b.denominator_digits;
  }
  return size;
}

Size power(const Size& a, int exponent) {
  Size size;
  // Kept inside of int; a degree that large is refused anyway.
  for (const int degree : a.degrees) size.degrees.push_back(int(std::min<long long>(1LL * degree * exponent, 1000000)));
  size.total_degree = a.total_degree * exponent;
  // Monomials of degree `exponent` in a.terms letters.
  const double most = size.dense_terms();
  double multinomials = 1;
  for (int k = 1; k < a.terms && multinomials < most; ++k) multinomials *= double(exponent + k) / k;
  size.terms = std::min(std::ceil(multinomials), most);
  size.numerator_digits = exponent * (a.numerator_digits + std::log10(std::max(1.0, a.terms)));
  size.denominator_digits = exponent * a.denominator_digits;
  return size;
}

class Evaluator {
 public:
  explicit Evaluator(const VariableNames& names) : names_(names), variables_(int(names.size())) {}

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
    RationalFunction a = (*this)(node.operands.front());
    if (node.op == '~') return -a;
    const RationalFunction b = (*this)(node.operands.back());
    switch (node.op) {
      case '+':
      case '-':
        allow_sum(a, b, column);
        return node.op == '+' ? a + b : a - b;
      case '*':
        allow_product(a.numerator(), a.denominator(), b.numerator(), b.denominator(), column);
        return a * b;
      case '/':
        if (b.is_zero()) fail("division by zero", column);
        allow_product(a.numerator(), a.denominator(), b.denominator(), b.numerator(), column);
        return a / b;
    }
    throw InternalError(fmt::format("an expression has the operator '{}'", node.op));
  }

  RationalFunction evaluate(const Expression::Power& node, int column) {
    const RationalFunction base = (*this)(node.base.front());
    if (node.exponent < 0 && base.is_zero()) fail("division by zero", column);
    const int exponent = std::abs(node.exponent);
    for (const auto* part : {&base.numerator(), &base.denominator()}) {
      const Size one = measured(*part, column);
      const Size size = power(one, exponent);
      allow(size, column);
      spend(one.terms * size.terms * digit_cost(size), column);
    }
    return limes::power(base, node.exponent);
  }

  void allow_sum(const RationalFunction& a, const RationalFunction& b, int column) {
    if (a.denominator() == b.denominator()) {
      const Size numerator = sum(measured(a.numerator(), column), measured(b.numerator(), column));
      allow(numerator, column);
      spend(numerator.terms * digit_cost(numerator), column);
      if (!a.is_polynomial()) spend_on_gcd(numerator, measured(a.denominator(), column), column);
      return;
    }
    const Size numerator_a = measured(a.numerator(), column);
    const Size numerator_b = measured(b.numerator(), column);
    const Size denominator_a = measured(a.denominator(), column);
    const Size denominator_b = measured(b.denominator(), column);
    const Size numerator = sum(product(numerator_a, denominator_b), product(numerator_b, denominator_a));
    const Size denominator = product(denominator_a, denominator_b);
    allow(numerator, column);
    allow(denominator, column);
    spend((numerator_a.terms * denominator_b.terms + numerator_b.terms * denominator_a.terms) * digit_cost(numerator),
          column);
    spend_on_gcd(numerator, denominator, column);
  }

  void allow_product(const MultivariatePolynomial& numerator_a, const MultivariatePolynomial& denominator_a,
                     const MultivariatePolynomial& numerator_b, const MultivariatePolynomial& denominator_b,
                     int column) {
    const Size size_a = measured(numerator_a, column);
    const Size size_b = measured(numerator_b, column);
    const Size numerator = product(size_a, size_b);
    const Size denominator = product(measured(denominator_a, column), measured(denominator_b, column));
    allow(numerator, column);
    allow(denominator, column);
    spend(size_a.terms * size_b.terms * digit_cost(numerator), column);
    if (denominator.total_degree > 0) spend_on_gcd(numerator, denominator, column);
  }

  // Looking at all terms costs as well.
  Size measured(const MultivariatePolynomial& p, int column) {
    spend(300 * double(p.term_count()), column);
    return measure(p);
  }

  static void allow(const Size& size, int column) {
    if (size.total_degree > max_degree)
      limit(fmt::format("a polynomial of degree above {} would arise", max_degree), column);
    if (size.terms > max_terms) limit(fmt::format("a polynomial of more than {} terms would arise", max_terms), column);
    if (size.digits() > max_digits)
      limit(fmt::format("numbers of more than {} digits would arise", max_digits), column);
  }

  // The cost of one multiplication of coefficients.
  static double digit_cost(const Size& size) { return 10 + size.digits() * std::sqrt(size.digits()) / 20; }

  // The greatest common divisor of two dense polynomials.
  void spend_on_gcd(const Size& a, const Size& b, int column) {
    const Size size = sum(a, b);
    double side = 1;
    for (const int degree : size.degrees) side = std::max(side, double(degree));
    spend(size.dense_terms() * side * digit_cost(size) / 4, column);
  }

  void spend(double work, int column) {
    work_ += work;
    if (!(work_ <= max_work)) limit("the expression is too large to expand", column);
  }

  [[noreturn]] static void fail(const std::string& reason, int column) { throw InputError(reason, {"", 0, column}); }
  [[noreturn]] static void limit(const std::string& reason, int column) { throw LimitError(reason, {"", 0, column}); }

  const VariableNames& names_;
  int variables_;
  double work_ = 0;
};

}  // namespace

RationalFunction to_rational_function(const Expression& expression, const VariableNames& names) {
  return Evaluator(names)(expression);
}

RationalFunction read_rational_function(std::string_view text, const VariableNames& names) {
  return to_rational_function(read_expression(text), names);
}

}  // namespace limes
