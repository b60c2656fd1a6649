// The size of a result is estimated from above, so that an expression such as ((1+w)^1000)^1000 is refused instead of computed.
#include "algebra/expression/bounded_arithmetic.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace limes {

namespace {

constexpr double max_degree = 1000;
constexpr double max_terms = 100000;
constexpr double max_digits = 10000;
// In units of about a nanosecond: what the operations of one object may cost altogether.
constexpr double max_work = 2e9;
// Of an operation on constants.
constexpr double least_work = 3000;

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

// Estimates the operations at one place of the text.
class Meter {
 public:
  Meter(double& work, int column) : work_(work), column_(column) { spend(least_work); }

  void allow_sum(const RationalFunction& a, const RationalFunction& b) {
    if (a.denominator() == b.denominator()) {
      const Size numerator = sum(measured(a.numerator()), measured(b.numerator()));
      allow(numerator);
      spend(numerator.terms * digit_cost(numerator));
      if (!a.is_polynomial()) spend_on_gcd(numerator, measured(a.denominator()));
      return;
    }
    const Size numerator_a = measured(a.numerator());
    const Size numerator_b = measured(b.numerator());
    const Size denominator_a = measured(a.denominator());
    const Size denominator_b = measured(b.denominator());
    const Size numerator = sum(product(numerator_a, denominator_b), product(numerator_b, denominator_a));
    const Size denominator = product(denominator_a, denominator_b);
    allow(numerator);
    allow(denominator);
    spend((numerator_a.terms * denominator_b.terms + numerator_b.terms * denominator_a.terms) * digit_cost(numerator));
    spend_on_gcd(numerator, denominator);
  }

  void allow_product(const MultivariatePolynomial& numerator_a, const MultivariatePolynomial& denominator_a,
                     const MultivariatePolynomial& numerator_b, const MultivariatePolynomial& denominator_b) {
    const Size size_a = measured(numerator_a);
    const Size size_b = measured(numerator_b);
    const Size numerator = product(size_a, size_b);
    const Size denominator = product(measured(denominator_a), measured(denominator_b));
    allow(numerator);
    allow(denominator);
    spend(size_a.terms * size_b.terms * digit_cost(numerator));
    if (denominator.total_degree > 0) spend_on_gcd(numerator, denominator);
  }

  void allow_power(const RationalFunction& base, int exponent) {
    for (const auto* part : {&base.numerator(), &base.denominator()}) {
      const Size one = measured(*part);
      const Size size = power(one, exponent);
      allow(size);
      spend(one.terms * size.terms * digit_cost(size));
    }
  }

 private:
  // Looking at all terms costs as well.
  Size measured(const MultivariatePolynomial& p) {
    spend(300 * double(p.term_count()));
    return measure(p);
  }

  void allow(const Size& size) const {
    if (size.total_degree > max_degree)
      limit(fmt::format("a polynomial of degree above {} would arise", max_degree));
    if (size.terms > max_terms) limit(fmt::format("a polynomial of more than {} terms would arise", max_terms));
    if (size.digits() > max_digits)
      limit(fmt::format("numbers of more than {} digits would arise", max_digits));
  }

  // The cost of one multiplication of coefficients.
  static double digit_cost(const Size& size) { return 10 + size.digits() * std::sqrt(size.digits()) / 20; }

  // The greatest common divisor of two dense polynomials.
  void spend_on_gcd(const Size& a, const Size& b) {
    const Size size = sum(a, b);
    double side = 1;
    for (const int degree : size.degrees) side = std::max(side, double(degree));
    spend(size.dense_terms() * side * digit_cost(size) / 4);
  }

  void spend(double work) {
    work_ += work;
    if (!(work_ <= max_work)) limit("the expression is too large to expand");
  }

  [[noreturn]] void limit(const std::string& reason) const { throw LimitError(reason, {"", 0, column_}); }

  double& work_;
  int column_;
};

}  // namespace

RationalFunction BoundedArithmetic::apply(char op, const RationalFunction& a, const RationalFunction& b, int column) {
  Meter meter(work_, column);
  switch (op) {
    case '+':
    case '-':
      meter.allow_sum(a, b);
      return op == '+' ? a + b : a - b;
    case '*':
      meter.allow_product(a.numerator(), a.denominator(), b.numerator(), b.denominator());
      return a * b;
    case '/':
      if (b.is_zero()) throw InputError("division by zero", {"", 0, column});
      meter.allow_product(a.numerator(), a.denominator(), b.denominator(), b.numerator());
      return a / b;
  }
  throw InternalError(fmt::format("an expression has the operator '{}'", op));
}

RationalFunction BoundedArithmetic::power(const RationalFunction& a, int exponent, int column) {
  if (exponent < 0 && a.is_zero()) throw InputError("division by zero", {"", 0, column});
  Meter(work_, column).allow_power(a, std::abs(exponent));
  return limes::power(a, exponent);
}

}  // namespace limes
