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
  const Mask constant{2, LaurentPolynomial(0, std::vector<Rational>{Rational(9, 10), Rational(9, 5), Rational(9, 10)})};
  EXPECT_FALSE(bound_hoelder_exponent(constant, 6, {}, {}).bounds.lower);
  // b = 1 - z/2 + z^2/2 expands: radius at least 1, exponent of the formula not positive.
  const Mask rough{2, LaurentPolynomial(0, std::vector<Rational>{2, 0, 0, 0})};
  EXPECT_FALSE(bound_hoelder_exponent(rough, 6, {}, {}).bounds.lower);
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
  // |b|^2 = P(y) = 1 + 4 y + 10 y^2 + 20 y^3. Its real root y_1 and the quadratic factor y^2 + c y + d belong to factors of b: z^2 - (2 - 4 y) z + 1
  // has the roots z, 1/z; the minimal phase b takes those outside of the circle for a(z) in powers of z with b_0 greatest.
  const Bracket y = bracket(-1, 0, [](const Rational& t) { return 1 + t * (4 + t * (10 + t * 20)); });
  // Linear factor: z_1 + 1/z_1 = 2 - 4 y_1, |z_1| > 1.
  const auto outer = [](const Rational& trace) {
    return bracket(trace / 2, trace, [&](const Rational& z) { return z * z - trace * z + 1; });
  };
  const Bracket z1{outer(2 - 4 * y.upper).lower, outer(2 - 4 * y.lower).upper};
  // Quadratic factor z^2 + p z + q with roots outside: in u = z + 1/z = 2 - 4 y the pair satisfies u^2 - S u + T = 0 where the three u have
  // sum 8 and the cubic is 20 y^3 + 10 y^2 + 4 y + 1. p and q: p (1 + q)/q = -S, (p^2 + (1 - q)^2... )/q = T.
  const double yd = approx_double((y.lower + y.upper) / 2);
  const double sum = -0.5 - yd, prod = -1.0 / 20 / yd;   // of the complex pair of y
  const double S = 4 - 4 * sum, T = 4 - 8 * sum + 16 * prod;
  // (z^2 + p z + q)(z^-2 + p z^-1 + q) / q = u^2 + (p (1 + q)/q) u + ((1 + p^2 + q^2)/q - 2 - ...): solved for q by Newton, proved below by the box.
  double q = 4, p = 0;
  for (int i = 0; i < 200; ++i) {
    p = -S * q / (1 + q);
    const double f = (1 + p * p + q * q) / q - 2 - (T - 0);
    const double h = 1e-7, p2 = -S * (q + h) / (1 + q + h), f2 = (1 + p2 * p2 + (q + h) * (q + h)) / (q + h) - 2 - T;
    q -= f / ((f2 - f) / h);
  }
  const double z = approx_double((z1.lower + z1.upper) / 2);
  // b is proportional to (z_1 - x)(q + p x + x^2), normalised to b(1) = 1.
  const double scale = 1 / ((z - 1) * (q + p + 1));
  const double b[] = {z * q * scale, (z * p - q) * scale, (z - p) * scale, -scale};
  // The identity |b|^2 = P(y) at the numbers used, so that the box around them holds the true b (Krawczyk is not needed: the residual is
  // far below the radius of the box times the least singular value of the Jacobian, which is of order 1).
  const double r3 = b[0] * b[3], r2 = b[0] * b[2] + b[1] * b[3], r1 = b[0] * b[1] + b[1] * b[2] + b[2] * b[3];
  EXPECT_NEAR(r3, -20.0 / 64, 1e-9);
  EXPECT_NEAR(r2, 10.0 / 16 + 20.0 * 6 / 64, 1e-9);
  EXPECT_NEAR(r1, -(4.0 / 4 + 10.0 * 4 / 16 + 20.0 * 15 / 64), 1e-9);
  std::vector<Bracket> box;
  for (const double x : b) box.push_back({Rational(x - 1e-7), Rational(x + 1e-7)});
  expect_exponent_on_box(box, 4, 1.6178, 1.6180);
}
