#include "algebra/polynomial/bernstein_form.hpp"

#include "algebra/error.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

using P = MultivariatePolynomial;

P x(int variables, int index) { return P::variable(variables, index); }
P c(int variables, const Rational& value) { return P::constant(variables, value); }

/// sum_I c_I prod binom t^I (1-t)^{n-I} straight from the definition.
Rational value(const BernsteinForm& form, const std::vector<Rational>& point) {
  Rational sum = 0;
  for (std::size_t at = 0; at < form.coefficients().size(); ++at) {
    Rational term = form.coefficients()[at];
    std::size_t rest = at;
    for (std::size_t axis = point.size(); axis-- > 0;) {
      const int n = form.degrees()[axis], k = static_cast<int>(rest % static_cast<std::size_t>(n + 1));
      rest /= static_cast<std::size_t>(n + 1);
      if (n == 0) continue;
      const Interval& interval = form.box()[axis];
      const Rational t = (point[axis] - interval.lower) / interval.width();
      Integer binomial;
      mpz_bin_uiui(binomial.backend().data(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
      term *= Rational(binomial) * power(t, k) * power(1 - t, n - k);
    }
    sum += term;
  }
  return sum;
}

TEST(BernsteinForm, RepresentsThePolynomialAndEnclosesItsRange) {
  test::Generator generator(61);
  for (int round = 0; round < 80; ++round) {
    const int n = generator.integer(0, 3);
    const P p = generator.multivariate(n, 4, 6);
    const Box box = generator.box(n, true);
    std::vector<int> degrees = p.degrees();
    for (int& degree : degrees) degree += generator.integer(0, 2);
    const BernsteinForm least(p, box), elevated(p, box, degrees);
    EXPECT_LE(least.lower(), least.upper());
    EXPECT_LE(least.lower(), elevated.lower());
    EXPECT_GE(least.upper(), elevated.upper());
    for (int k = 0; k < 8; ++k) {
      const auto point = generator.point_in(box);
      const Rational exact = p(point);
      EXPECT_EQ(value(least, point), exact);
      EXPECT_EQ(value(elevated, point), exact);
      EXPECT_LE(elevated.lower(), exact);
      EXPECT_GE(elevated.upper(), exact);
    }
  }
}

TEST(BernsteinForm, CornerCoefficientsAreValues) {
  test::Generator generator(62);
  for (int round = 0; round < 40; ++round) {
    const P p = generator.multivariate(2, 5, 6);
    const Box box = generator.box(2);
    const BernsteinForm form(p, box);
    const auto n1 = static_cast<std::size_t>(form.degrees()[1]);
    const auto& b = form.coefficients();
    EXPECT_EQ(b.front(), p(std::vector<Rational>{box[0].lower, box[1].lower}));
    EXPECT_EQ(b[n1], p(std::vector<Rational>{box[0].lower, box[1].upper}));
    EXPECT_EQ(b[b.size() - 1 - n1], p(std::vector<Rational>{box[0].upper, box[1].lower}));
    EXPECT_EQ(b.back(), p(std::vector<Rational>{box[0].upper, box[1].upper}));
  }
}

TEST(BernsteinForm, BisectAgreesWithDirectConversion) {
  test::Generator generator(63);
  for (int round = 0; round < 60; ++round) {
    const int n = generator.integer(1, 3), axis = generator.integer(0, n - 1);
    const P p = generator.multivariate(n, 4, 6);
    const BernsteinForm form(p, generator.box(n));
    const auto [left, right] = form.bisect(axis);
    for (const BernsteinForm& half : {left, right}) {
      const BernsteinForm direct(p, half.box(), form.degrees());
      EXPECT_EQ(half.coefficients(), direct.coefficients());
      EXPECT_EQ(half.degrees(), direct.degrees());
      EXPECT_GE(half.lower(), form.lower());
      EXPECT_LE(half.upper(), form.upper());
    }
    EXPECT_EQ(left.box(), bisect(form.box(), axis).first);
    EXPECT_EQ(right.box(), bisect(form.box(), axis).second);
  }
}

TEST(BernsteinForm, KnownCoefficients) {
  // (2t-1)^2 on [0,1]: 1, -1, 1.
  const P t = x(1, 0), p = Rational(4) * t * t - Rational(4) * t + c(1, 1);
  EXPECT_EQ(BernsteinForm(p, {{0, 1}}).coefficients(), (std::vector<Rational>{1, -1, 1}));
  EXPECT_EQ(BernsteinForm(t, {{2, 5}}, {3}).coefficients(), (std::vector<Rational>{2, 3, 4, 5}));
  EXPECT_EQ(BernsteinForm(c(0, 7), {}).coefficients(), (std::vector<Rational>{7}));
  const BernsteinForm product(x(2, 0) * x(2, 1), {Interval::point(3), {0, 2}});
  EXPECT_EQ(product.coefficients(), (std::vector<Rational>{0, 6}));
}

TEST(BernsteinForm, WrongShapesAreErrors) {
  const P t = x(1, 0);
  EXPECT_THROW(BernsteinForm(t * t, {{0, 1}}, {1}), DomainError);
  EXPECT_THROW(BernsteinForm(t, {{0, 1}}, {-1}), DomainError);
  EXPECT_THROW(BernsteinForm(t, {{0, 1}}, {1, 1}), DomainError);
  EXPECT_THROW(BernsteinForm(t, {}), DomainError);
  EXPECT_THROW(BernsteinForm(t, {{1, 0}}), DomainError);
  EXPECT_THROW(BernsteinForm(t, {{1, 1, true, false}}), DomainError);
  EXPECT_THROW(BernsteinForm(t, {Interval::point(1)}).bisect(0), DomainError);
  EXPECT_NO_THROW(BernsteinForm(t * t, {Interval::point(2)}, {0}));
  EXPECT_THROW(BernsteinForm(power(x(2, 0), 4000) * power(x(2, 1), 4000), {{0, 1}, {0, 1}}), LimitError);
}

TEST(BernsteinForm, StrictSign) {
  const P t = x(1, 0);
  EXPECT_EQ(BernsteinForm(t, {{1, 2}}).strict_sign(), 1);
  EXPECT_EQ(BernsteinForm(-t, {{1, 2}}).strict_sign(), -1);
  EXPECT_EQ(BernsteinForm(t, {{0, 2, true, false}}).strict_sign(), 0);
  EXPECT_EQ(BernsteinForm(c(1, 0), {{0, 2}}).strict_sign(), 0);
}

TEST(BernsteinForm, StrictSignOffOpenFaces) {
  const P t = x(1, 0), one = c(1, 1);
  const Interval open_low{0, 1, true, false}, open_high{0, 1, false, true};
  const Interval open{0, 1, true, true}, closed{0, 1, false, false};
  const auto sign = [](const P& p, const Interval& interval) {
    return BernsteinForm(p, {interval}).strict_sign_off_open_faces();
  };
  EXPECT_EQ(sign(t, open_low), 1);
  EXPECT_EQ(sign(t, open_high), 0);  // the zero is at the closed end
  EXPECT_EQ(sign(t, closed), 0);
  EXPECT_EQ(sign(-t * t * t, open_low), -1);
  EXPECT_EQ(sign(one - t, open_high), 1);
  EXPECT_EQ(sign(one - t, open_low), 0);
  EXPECT_EQ(sign((one - t) * (one - t) * (one + t), open_high), 1);
  EXPECT_EQ(sign(t * t * (one - t), open), 1);
  EXPECT_EQ(sign(t * (one - t), open_low), 0);
  EXPECT_EQ(sign(t - c(1, Rational(1) / 2), open), 0);
  EXPECT_EQ(sign(t * (t - c(1, Rational(1) / 2)), open), 0);
  EXPECT_EQ(sign(c(1, 0), open), 0);
  EXPECT_EQ(sign(c(1, -3), open), -1);
  // A first coefficient of the wrong sign, however small, is no zero.
  EXPECT_EQ(sign(t - c(1, Rational(1) / 1000000000), open_low), 0);
  // Coefficients 0, 1/3, 0, 1: zeros inside do no harm where the closed end has none.
  const P gap = t * (Rational(2) * t * t - Rational(2) * t + one);
  EXPECT_EQ(BernsteinForm(gap, {open_low}).coefficients(), (std::vector<Rational>{0, Rational(1) / 3, 0, 1}));
  EXPECT_EQ(sign(gap, open_low), 1);
  EXPECT_EQ(sign(gap, open), 1);
  EXPECT_EQ(sign(gap, open_high), 0);
  // In an elevated multidegree the strips stay zero.
  EXPECT_EQ(BernsteinForm(t * t, {open_low}, {6}).strict_sign_off_open_faces(), 1);
}

TEST(BernsteinForm, StrictSignOffOpenFacesInTwoVariables) {
  const P s = x(2, 0), t = x(2, 1), one = c(2, 1);
  const Interval open_low{0, 1, true, false}, closed{0, 1, false, false};
  const auto sign = [](const P& p, const Box& box) { return BernsteinForm(p, box).strict_sign_off_open_faces(); };
  EXPECT_EQ(sign(s * t * (one + s + t), {open_low, open_low}), 1);
  EXPECT_EQ(sign(s * t * (one + s + t), {open_low, closed}), 0);
  EXPECT_EQ(sign(s * (one + t), {open_low, closed}), 1);
  // s + t vanishes at one corner only, which one open end is enough to exclude.
  EXPECT_EQ(sign(s + t, {open_low, open_low}), 1);
  EXPECT_EQ(sign(s + t, {open_low, closed}), 1);
  EXPECT_EQ(sign(s + t, {closed, closed}), 0);
  EXPECT_EQ(sign(s + (one - t), {open_low, closed}), 1);
  EXPECT_EQ(sign(s + (one - t), {closed, open_low}), 0);
  // s t + (1-s)(1-t) vanishes at two corners, s (1-t) on two edges.
  EXPECT_EQ(sign(s * t + (one - s) * (one - t), {open_low, closed}), 0);
  EXPECT_EQ(sign(s * t + (one - s) * (one - t), {{0, 1, true, true}, closed}), 1);
  EXPECT_EQ(sign(s * (one - t), {open_low, closed}), 0);
  EXPECT_EQ(sign(s * (one - t), {open_low, {0, 1, false, true}}), 1);
  EXPECT_EQ(sign(s * t, {open_low, Interval::point(2)}), 1);
  EXPECT_EQ(sign(s * t, {open_low, Interval::point(0)}), 0);
}

TEST(BernsteinForm, SignsAreTrueAtSamples) {
  test::Generator generator(64);
  int shown = 0;
  for (int round = 0; round < 400; ++round) {
    const int n = generator.integer(1, 2);
    const Box box = generator.box(n, true);
    P p = generator.multivariate(n, 2, 3) + c(n, generator.integer(-9, 9));
    for (int i = 0; i < n; ++i) {
      const auto& interval = box[static_cast<std::size_t>(i)];
      p *= power(x(n, i) - c(n, interval.lower), generator.integer(0, 1));
      p *= power(c(n, interval.upper) - x(n, i), generator.integer(0, 1));
    }
    const BernsteinForm form(p, box);
    const int plain = form.strict_sign(), off = form.strict_sign_off_open_faces();
    const int proved = prove_strict_sign(p, box, 64);
    if (plain != 0) {
      EXPECT_EQ(off, plain);
    }
    if (off != 0) {
      EXPECT_EQ(proved, off);
    }
    shown += proved != 0;
    for (int k = 0; k < 20; ++k) {
      const auto point = generator.point_in(box);
      if (proved != 0 && contains(box, point)) {
        EXPECT_EQ(p(point).sign(), proved);
      }
    }
  }
  EXPECT_GT(shown, 40);
}

TEST(ProveStrictSign, BisectsUntilShown) {
  const P t = x(1, 0), s = x(2, 0), u = x(2, 1);
  const auto third = c(1, Rational(1) / 3);
  const P narrow = (t - third) * (t - third) + c(1, Rational(1) / 10000);
  EXPECT_EQ(BernsteinForm(narrow, {{0, 1}}).strict_sign(), 0);
  EXPECT_EQ(prove_strict_sign(narrow, {{0, 1}}), 1);
  EXPECT_EQ(prove_strict_sign(-narrow, {{0, 1}}), -1);
  EXPECT_EQ(prove_strict_sign(narrow, {{0, 1}}, 1), 0);
  EXPECT_EQ(prove_strict_sign(narrow, {{0, 1}}, 0), 0);
  const P bumpy = (s - u) * (s - u) + c(2, Rational(1) / 100);
  EXPECT_EQ(prove_strict_sign(bumpy, {{0, 1}, {0, 1}}), 1);
  // Times powers that vanish on open faces only.
  EXPECT_EQ(prove_strict_sign(bumpy * s * u * u, {{0, 1, true, false}, {0, 1, true, false}}), 1);
  EXPECT_EQ(prove_strict_sign(bumpy * s * u * u, {{0, 1, true, false}, {0, 1}}), 0);
}

TEST(ProveStrictSign, NeverHoldsWhereThereIsAZero) {
  const P t = x(1, 0), s = x(2, 0), u = x(2, 1);
  const auto third = c(1, Rational(1) / 3), half = c(1, Rational(1) / 2);
  EXPECT_EQ(prove_strict_sign((t - third) * (t - third), {{0, 1}}), 0);
  EXPECT_EQ(prove_strict_sign((t - half) * (t - half), {{0, 1}}), 0);  // the zero is on the first cut, which is closed
  EXPECT_EQ(prove_strict_sign((t - half) * (t - half), {{0, 1, true, true}}), 0);
  EXPECT_EQ(prove_strict_sign(t - third, {{0, 1}}), 0);
  EXPECT_EQ(prove_strict_sign(t, {{0, 1}}), 0);
  EXPECT_EQ(prove_strict_sign(c(1, 0), {{0, 1, true, true}}), 0);
  EXPECT_EQ(prove_strict_sign((s - u) * (s - u), {{0, 1, true, true}, {0, 1, true, true}}), 0);
  EXPECT_EQ(prove_strict_sign(s * u, {{0, 1, true, true}, {-1, 1, true, true}}), 0);
  EXPECT_EQ(prove_strict_sign(s * (s - u), {{0, 1, true, false}, {2, 3}}), -1);
  // Opposite signs on the two halves.
  EXPECT_EQ(prove_strict_sign(t * (t - c(1, 1)) * (t - half), {{0, 1, true, true}}), 0);
}

TEST(ProveStrictSign, IgnoresVariablesThatDoNotOccur) {
  const P s = x(3, 0);
  const P p = s * s - s + c(3, Rational(26) / 100);
  EXPECT_EQ(prove_strict_sign(p, {{0, 1}, {0, 1, true, true}, Interval::point(5)}), 1);
  EXPECT_EQ(prove_strict_sign(c(0, 2), {}), 1);
  EXPECT_EQ(prove_strict_sign(c(0, 0), {}), 0);
  EXPECT_EQ(prove_strict_sign(c(1, -2), {{0, 1, true, true}}), -1);
}

}  // namespace
}  // namespace limes
