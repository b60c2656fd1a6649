#include "algebra/polynomial/rational_function.hpp"

#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

using P = MultivariatePolynomial;
using F = RationalFunction;

void expect_canonical(const F& f) {
  EXPECT_FALSE(f.denominator().is_zero());
  EXPECT_EQ(f.denominator().terms().front().coefficient, 1);
  EXPECT_TRUE(gcd(f.numerator(), f.denominator()).is_constant());
  if (f.is_zero()) {
    EXPECT_TRUE(f.denominator().is_constant());
  }
}

TEST(RationalFunction, FieldAxioms) {
  test::Generator generator(31);
  for (int round = 0; round < 100; ++round) {
    const int n = generator.integer(0, 3);
    const F a = generator.rational_function(n, 2, 3), b = generator.rational_function(n, 2, 3);
    const F c = generator.coin() ? F(generator.multivariate(n, 2, 3)) : generator.rational_function(n, 1, 3);
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_EQ(a - b, a + (-b));
    EXPECT_TRUE((a - a).is_zero());
    for (const F& f : {a + b, a - b, a * b, a * c, a + c, a - a}) expect_canonical(f);
    if (b.is_zero()) {
      EXPECT_THROW(a / b, DomainError);
    } else {
      EXPECT_EQ(a / b * b, a);
      EXPECT_EQ(power(b, -2) * b * b, F::constant(n, 1));
      expect_canonical(a / b);
    }
    F twice = a;
    twice += twice;
    EXPECT_EQ(twice, F::constant(n, 2) * a);
    F square = a;
    square *= square;
    EXPECT_EQ(square, power(a, 2));
  }
}

TEST(RationalFunction, OperationsCommuteWithEvaluation) {
  test::Generator generator(32);
  int compared = 0;
  for (int round = 0; round < 100; ++round) {
    const int n = generator.integer(1, 3), index = generator.integer(0, n - 1);
    const F a = generator.rational_function(n, 2, 3), b = generator.rational_function(n, 2, 3);
    const auto point = generator.point(n, 50);
    auto moved = point;
    try {
      const Rational at_a = a(point), at_b = b(point);
      EXPECT_EQ((a + b)(point), at_a + at_b);
      EXPECT_EQ((a * b)(point), at_a * at_b);
      moved[static_cast<std::size_t>(index)] = at_b;
      EXPECT_EQ(a.substitute(index, b)(point), a(moved));
      EXPECT_EQ(a.substitute(index, at_b)(point), a(moved));
      expect_canonical(a.substitute(index, b));
      ++compared;
    } catch (const DomainError&) {  // a pole
    }
  }
  EXPECT_GT(compared, 80);
}

TEST(RationalFunction, PolesAndZeroDenominatorsAreErrors) {
  const F x = F::variable(2, 0), y = F::variable(2, 1), one = F::constant(2, 1);
  EXPECT_THROW(F(P::variable(1, 0), P(1)), DomainError);
  EXPECT_THROW(F(P(1), P(1)), DomainError);
  EXPECT_THROW(F(P(1), P::constant(2, 1)), DomainError);
  EXPECT_THROW((one / (x - y))(std::vector<Rational>{2, 2}), DomainError);
  EXPECT_THROW((one / (x - y)).substitute(0, y), DomainError);
  EXPECT_THROW((one / x).substitute(0, Rational(0)), DomainError);
  EXPECT_THROW(power(F(2), -1), DomainError);
  EXPECT_THROW(one / x + F::constant(1, 1), DomainError);
  EXPECT_THROW(one / x * F::constant(1, 1), DomainError);
  EXPECT_THROW(x.constant_value(), DomainError);
  // A removable singularity is none: the function is stored in lowest terms.
  EXPECT_EQ(((x * x - y * y) / (x - y))(std::vector<Rational>{2, 2}), 4);
}

TEST(RationalFunction, Mapped) {
  const F f = (F::variable(2, 0) + F::constant(2, 1)) / F::variable(2, 1);
  const F g = f.mapped(3, std::vector<int>{2, 0});
  EXPECT_EQ(to_string(g, {"a", "b", "c"}), "(c + 1)/a");
  EXPECT_THROW(F(f).mapped(1, std::vector<int>{0}), DomainError);
}

TEST(RationalFunction, ReadsBackWhatIsPrinted) {
  test::Generator generator(33);
  const VariableNames names = {"a", "beta_1", "w"};
  for (int round = 0; round < 200; ++round) {
    const F f = generator.rational_function(3, 3, 3);
    EXPECT_EQ(read_rational_function(to_string(f, names), names), f) << to_string(f, names);
  }
}

TEST(RationalFunction, Prints) {
  const F a = F::variable(2, 0), b = F::variable(2, 1), one = F::constant(2, 1), two = F::constant(2, 2);
  const VariableNames names = {"a", "b"};
  EXPECT_EQ(to_string((a + one) / (b + two), names), "(a + 1)/(b + 2)");
  EXPECT_EQ(to_string(one / a, names), "1/a");
  EXPECT_EQ(to_string(-one / (a * a), names), "-1/a^2");
  EXPECT_EQ(to_string(one / (two * a * b), names), "1/2/(a*b)");
  EXPECT_EQ(to_string((a - b) / two, names), "1/2*a - 1/2*b");
  EXPECT_EQ(to_string(F(2), names), "0");
}

}  // namespace
}  // namespace limes
