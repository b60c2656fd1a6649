#include "analysis/uniform/hoelder_exponent.hpp"

#include "algebra/polynomial/bernstein_form.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/finite_sections.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace limes;

namespace {

HoelderExponent exponent(const std::string& scheme, const std::vector<Rational>& point = {}, int digits = 6) {
  const Mask mask = Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(scheme).mask;
  return bound_hoelder_exponent(at(mask, point), digits, {}, {});
}

void expect_encloses(const HoelderExponent& e, double value, double width) {
  ASSERT_TRUE(e.bounds.lower && e.bounds.upper);
  EXPECT_LE(approx_double(*e.bounds.lower), value + 1e-12);
  EXPECT_GE(approx_double(*e.bounds.upper), value - 1e-12);
  EXPECT_LE(approx_double(*e.bounds.upper - *e.bounds.lower), width);
}

/// Rational bounds of the root of f between two numbers.
struct Bracket {
  Rational lower, upper;
};

Bracket bracket(Rational lower, Rational upper, const std::function<Rational(const Rational&)>& f) {
  const bool rising = f(upper) > 0;
  EXPECT_NE(f(lower) > 0, rising);
  for (int i = 0; i < 60; ++i) {
    const Rational middle = (lower + upper) / 2;
    ((f(middle) > 0) == rising ? upper : lower) = middle;
  }
  return {lower, upper};
}

Bracket sum(const Bracket& x, const Bracket& y) { return {x.lower + y.lower, x.upper + y.upper}; }
Bracket product(const Bracket& x, const Bracket& y) {
  const auto [low, high] = std::minmax({Rational(x.lower * y.lower), Rational(x.lower * y.upper), Rational(x.upper * y.lower), Rational(x.upper * y.upper)});
  return {low, high};
}
/// \pre 0 is not in y
Bracket quotient(const Bracket& x, const Bracket& y) { return product(x, {1 / y.upper, 1 / y.lower}); }

/// z > 1 with z + 1/z = trace > 2, which rises with the trace.
Bracket greater_of_reciprocal_pair(const Bracket& trace) {
  const auto root = [](const Rational& c) { return bracket(c / 2, c, [&](const Rational& z) { return Rational(z * z - c * z + 1); }); };
  return {root(trace.lower).lower, root(trace.upper).upper};
}

/// Bounds of the Hoelder exponent of a = (1+z)^k 2^{-(k-1)} b for every b in a box: a polytope for all corners, whose convex hull holds the
/// true sections; and one letter's matrix whose radius is at least a bound on the whole box.
void expect_exponent_on_box(const std::vector<Bracket>& b, int k, double lower, double upper) {
  const int n = int(b.size()) - 1;
  MatrixFamily corners;
  for (unsigned corner = 0; corner < 1u << b.size(); ++corner) {
    std::vector<Rational> coefficients;
    for (std::size_t i = 0; i < b.size(); ++i) coefficients.push_back((corner >> i & 1u) != 0 ? b[i].upper : b[i].lower);
    for (int e = 0; e < 2; ++e) {
      RationalMatrix section(n, n);
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const int index = e + 2 * j - i;
          if (index >= 0 && index <= n) section(i, j) = coefficients[std::size_t(index)];
        }
      }
      corners.push_back(std::move(section));
    }
  }
  const Rational radius_above = Rational(std::exp2(k - 1 - lower)), radius_below = Rational(std::exp2(k - 1 - upper));
  EXPECT_TRUE(find_polytope(corners, radius_above, {}, {}));
  // The radius of one section of the corners' mean, and how much chi(q) can vary on the box, which is tiny.
  bool found = false;
  for (int e = 0; e < 2 && !found; ++e) {
    PolynomialMatrix section(int(b.size()), n, n);
    Box box;
    for (const Bracket& x : b) box.push_back(Interval{x.lower, x.upper, false, false});
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const int index = e + 2 * j - i;
        if (index >= 0 && index <= n) section(i, j) = MultivariatePolynomial::variable(int(b.size()), index);
        else section(i, j) = MultivariatePolynomial(int(b.size()));
      }
    }
    const std::vector<MultivariatePolynomial> chi = characteristic_polynomial(section);
    MultivariatePolynomial value(int(b.size()));
    for (int i = 0; i <= n; ++i) value += power(radius_below, i) * chi[std::size_t(i)];
    found = prove_strict_sign(value, box) < 0;   // chi(q) < 0: a real eigenvalue above q, everywhere on the box
  }
  EXPECT_TRUE(found);
}

}  // namespace

TEST(HoelderExponent, DynLevinGregory1987FourPointSchemeAtOneSixteenth) {
  const HoelderExponent e = exponent("four-point", {Rational(1, 16)});
  EXPECT_EQ(e.exact, Rational(2));
  EXPECT_EQ(e.order, 4);
  EXPECT_EQ(e.radius.exact->lower, 2);
}

TEST(HoelderExponent, BSplinesHaveTheirDegreeAsExponent) {
  for (int degree = 1; degree <= 8; ++degree) {
    const HoelderExponent e = exponent("b-spline-" + std::to_string(degree));
    EXPECT_EQ(e.exact, Rational(degree));
    EXPECT_EQ(e.sobolev.lower, degree + Rational(1, 2));
    EXPECT_EQ(e.sobolev.upper, degree + Rational(1, 2));
  }
}

TEST(HoelderExponent, DeslauriersDubuc1989Family) {
  expect_encloses(exponent("deslauriers-dubuc-6"), 6 - std::log2(9.0), 1e-6);   // 2.830
  expect_encloses(exponent("deslauriers-dubuc-8"), 3.5511305, 1e-6);            // 7 - log_2 of the greatest root of x^3 - 7 x^2 - 217/4 x + 125
  EXPECT_EQ(exponent("deslauriers-dubuc-8").radius.exact->polynomial, Polynomial({125, Rational(-217, 4), -7, 1}));
  expect_encloses(exponent("deslauriers-dubuc-10"), 4.1935735, 1e-6);
}

TEST(HoelderExponent, LowerOrderOfDifferencesGivesTheLesserOfOrderAndExponent) {
  // With sigma^2 only, the radius of b is max(1/2, 2^{1 - 2}) for the four-point scheme: exponent min(2, 2).
  const Mask mask = at(Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load("four-point").mask, std::vector<Rational>{Rational(1, 16)});
  const SpectralRadiusBounds second = bound_spectral_radius(difference_sections(mask, 2), {}, {});
  EXPECT_LE(second.lower, Rational(1, 2));
  EXPECT_GE(second.upper, Rational(1, 2));
}

TEST(HoelderExponent, ArityThree) {
  const HoelderExponent e = exponent("ternary-four-point", {Rational(1, 11)});
  EXPECT_EQ(e.radius.exact->lower, Rational(9, 11));
  expect_encloses(e, 2 + std::log(11.0 / 9) / std::log(3.0), 1e-6);
}

TEST(HoelderExponent, ComplexLeadingEigenvalue) {
  const HoelderExponent e = exponent("six-point", {Rational(1, 50)});
  EXPECT_FALSE(e.radius.exact);
  expect_encloses(e, 2.8327891, 1e-6);
}

TEST(HoelderExponent, NoneWithoutSumRules) {
  const auto mask = [](const std::vector<Rational>& coefficients) {
    return Mask{2, LaurentPolynomial::from_rationals(0, coefficients)};
  };
  // The sum is 18/5; then no factor 1 + z; then b = 1 - 2 z + 2 z^2 (k = 1), of radius at least 2.
  for (const auto& coefficients : {std::vector<Rational>{Rational(9, 10), Rational(9, 5), Rational(9, 10)}, {2, 0, 0, 0, 0, 0}, {1, -1, 0, 2}}) {
    const HoelderExponent e = bound_hoelder_exponent(mask(coefficients), 6, {}, {});
    EXPECT_FALSE(e.bounds.lower);
    EXPECT_FALSE(e.reason.empty());
  }
}

TEST(HoelderExponent, Daubechies1988FourCoefficients) {
  // b = (1 + sqrt 3)/2 + (1 - sqrt 3)/2 z: sections are 1 x 1, exponent 1 - log_2((1 + sqrt 3)/2) = 0.5500.
  const Bracket root = bracket(1, 2, [](const Rational& x) { return x * x - 3; });
  expect_exponent_on_box({{(1 + root.lower) / 2, (1 + root.upper) / 2}, {(1 - root.upper) / 2, (1 - root.lower) / 2}}, 2, 0.55000, 0.55002);
}

TEST(HoelderExponent, Daubechies1988SixCoefficients) {
  // b = b_0 + b_1 z + b_2 z^2, b(1) = 1, b_0 b_2 = 3/8, |b|^2 = 1 + 2 (3/2 y + 6 y^2 terms): with s = b_0 + b_2 = 1 - b_1 and sum of squares 19/4.
  // (P(y) = 1 + 3 y + 6 y^2, y = (2 - z - 1/z)/4: |b|^2 = 3/8 (z^2 + z^-2) - 9/4 (z + 1/z) + 19/4.)
  // b_1 (1 - b_1) = -9/4 gives b_1 = (1 - sqrt 10)/2; b_0 and b_2 are the roots of x^2 - s x + 3/8.
  const Bracket ten = bracket(3, 4, [](const Rational& x) { return x * x - 10; });
  const Bracket s{(1 + ten.lower) / 2, (1 + ten.upper) / 2};
  const auto greater_root = [](const Rational& sum) {
    return bracket(sum / 2, sum, [&](const Rational& x) { return x * x - sum * x + Rational(3, 8); });
  };
  const Bracket b0{greater_root(s.lower).lower, greater_root(s.upper).upper};
  const Bracket b2{Rational(3, 8) / b0.upper, Rational(3, 8) / b0.lower};
  expect_exponent_on_box({b0, {(1 - ten.upper) / 2, (1 - ten.lower) / 2}, b2}, 3, 1.08780, 1.08790);
}

TEST(HoelderExponent, Daubechies1988EightCoefficients) {
  // |b|^2 = P(y) = 1 + 4 y + 10 y^2 + 20 y^3, y = (2 - u)/4, u = z + 1/z. The real root y_1 gives the factor x - z_1 of b, z_1 + 1/z_1 = 2 - 4 y_1, |z_1| > 1.
  const Bracket y = bracket(-1, 0, [](const Rational& t) { return Rational(1 + t * (4 + t * (10 + t * 20))); });
  const Bracket trace{2 - 4 * y.upper, 2 - 4 * y.lower};
  const Bracket z = greater_of_reciprocal_pair(trace);
  // The complex pair has y-sum s and y-product t, and so u^2 - S u + T = 0. Its factor x^2 + p x + q of b, roots outside of the circle, satisfies
  // p (1 + q)/q = -S and ((1 - q)^2 + p^2)/q = T: with w = q + 1/q, (T + 2 - w)(w + 2) = S^2.
  const Bracket s{Rational(-1, 2) - y.upper, Rational(-1, 2) - y.lower}, t = quotient({Rational(-1, 20), Rational(-1, 20)}, y);
  const Bracket S{4 - 4 * s.upper, 4 - 4 * s.lower}, T{4 - 8 * s.upper + 16 * t.lower, 4 - 8 * s.lower + 16 * t.upper};
  const auto w_of = [](const Rational& S0, const Rational& T0) {
    return bracket(T0 / 2, T0 + 4, [&](const Rational& w) { return Rational((w + 2) * (w - T0 - 2) + S0 * S0); });
  };
  const Bracket w{w_of(S.upper, T.lower).lower, w_of(S.lower, T.upper).upper};
  const Bracket q = greater_of_reciprocal_pair(w);
  const Bracket p = product({-S.upper, -S.lower}, quotient(q, {1 + q.lower, 1 + q.upper}));
  // b is proportional to (z_1 - x)(q + p x + x^2), b(1) = 1.
  const Bracket one{1, 1}, minus{-1, -1};
  const Bracket scale = quotient(one, product(sum(z, minus), sum(sum(q, p), one)));
  std::vector<Bracket> b{product(z, q), sum(product(z, p), product(minus, q)), sum(z, product(minus, p)), minus};
  for (Bracket& x : b) x = product(x, scale);
  EXPECT_LT(b[0].upper - b[0].lower, Rational(1, 1000000000));
  expect_exponent_on_box(b, 4, 1.6178, 1.6180);
}
