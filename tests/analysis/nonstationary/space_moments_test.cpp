#include "analysis/nonstationary/space_moments.hpp"

#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

MaskSequence load(const char* name) {
  return *Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name).sequence;
}

bool reproduces(const MaskSequence& sequence, const std::string& function, bool at_zero = false) {
  return defects(sequence.mask, parameter_tau(sequence), read_exponential_function(function), false, at_zero).empty();
}

/// The value at new point i of one step from the samples of u with the old edge 2 h.
double step(const MaskSequence& sequence, double mu, int i, const std::function<double(double)>& u, double h) {
  double sum = 0;
  const LaurentPolynomial mask = sequence.mask.symbol.at(std::array<Rational, 1>{Rational(mu)});
  for (int k = mask.lowest(); k <= mask.highest(); ++k) {
    if ((i - k) % 2 == 0) sum += approx_double(mask.coefficient(k).constant_value()) * u((i - k) * h);
  }
  return sum;
}

// Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, Lemmas 3.1-3.6: old points (even residue) and new ones (odd), cosine and sine.
TEST(SpaceMoments, Lemmas31To33TheUnifiedCurveReproducesCosineAndSine) {
  const MaskSequence unified = load("unified-curve");
  EXPECT_TRUE(reproduces(unified, "cos"));
  EXPECT_TRUE(reproduces(unified, "sin"));
  const double theta = 0.9;
  for (int level = 0; level < 6; ++level) {
    const double h = theta / std::exp2(level + 1);
    for (int i = -4; i <= 5; ++i) {
      EXPECT_NEAR(step(
                      unified, std::cos(h), i, [](double y) { return std::cos(y); }, h),
                  std::cos(i * h), 1e-14);
      EXPECT_NEAR(step(
                      unified, std::cos(h), i, [](double y) { return std::sin(y); }, h),
                  std::sin(i * h), 1e-14);
    }
  }
}

TEST(SpaceMoments, Lemmas34To36TheUnifiedCurveReproducesTheHyperbolicFunctions) {
  const MaskSequence unified = load("unified-curve");
  EXPECT_TRUE(reproduces(unified, "cosh"));
  EXPECT_TRUE(reproduces(unified, "sinh"));
  for (const double h : {1.5, 0.3, 0.01}) {
    for (int i = -3; i <= 4; ++i) {
      EXPECT_NEAR(step(
                      unified, std::cosh(h), i, [](double y) { return std::cosh(y); }, h) /
                      std::cosh(i * h),
                  1, 1e-14);
      EXPECT_NEAR(step(
                      unified, std::cosh(h), i, [](double y) { return std::sinh(y); }, h),
                  std::sinh(i * h), 1e-13 * std::cosh(4 * h));
    }
  }
}

// Theorems 3.3-3.5 and 3.8-3.10 there: tensor products. The rows are refined with one angle, then the columns with the other.
TEST(SpaceMoments, Theorems33To310TensorProductsReproduceProducts) {
  const MaskSequence unified = load("unified-curve");
  const double s = 0.4, t = 0.7;  // angles of one new edge
  using Wave = double (*)(double);
  for (const auto& [u, v, hyperbolic_u, hyperbolic_v] :
       std::vector<std::tuple<Wave, Wave, bool, bool>>{{std::cos, std::cos, false, false},
                                                       {std::cos, std::sin, false, false},
                                                       {std::sin, std::sin, false, false},
                                                       {std::cosh, std::cosh, true, true},
                                                       {std::cosh, std::sinh, true, true},
                                                       {std::sinh, std::sinh, true, true},
                                                       {std::cosh, std::sin, true, false}}) {
    const double mu_u = hyperbolic_u ? std::cosh(s) : std::cos(s), mu_v = hyperbolic_v ? std::cosh(t) : std::cos(t);
    for (int i = -1; i <= 2; ++i) {
      for (int j = -1; j <= 2; ++j) {
        const auto column = [&](double y) {
          return step(
              unified, mu_u, i, [&](double x) { return u(x) * v(y); }, s);
        };
        EXPECT_NEAR(step(unified, mu_v, j, column, t), u(i * s) * v(j * t), 1e-13);
      }
    }
  }
}

// Section 2.5 and errata: {1, y, cos, sin} and nothing else of low order, the cubics at theta = 0 only.
TEST(SpaceMoments, WhatTheUnifiedCurveDoesNotReproduce) {
  const MaskSequence unified = load("unified-curve");
  EXPECT_EQ(to_string(reproduced_space(unified, AngleType::trigonometric, false)), "{1, y, cos, sin}");
  EXPECT_EQ(to_string(reproduced_space(unified, AngleType::hyperbolic, false)), "{1, y, cosh, sinh}");
  EXPECT_EQ(to_string(reproduced_polynomials(unified)), "{1, y, y^2, y^3}");
  for (const char* f : {"y^2", "y cos", "cos(2y)"}) EXPECT_FALSE(reproduces(unified, f)) << f;
  // The defect of y^2, moment 2 at the new points: (mu - 1)(mu + 2) / (mu (mu + 1)).
  const auto defect = defects(unified.mask, 0, read_exponential_function("y^2"), false).front();
  const RationalFunction mu = RationalFunction::variable(1, 0), one = RationalFunction::constant(1, 1);
  EXPECT_EQ(defect.moment, 2);
  EXPECT_EQ(defect.residue, 1);
  EXPECT_EQ(defect.value, (mu - one) * (mu + one + one) / (mu * (mu + one)));
}

TEST(SpaceMoments, ADefectIsTheErrorOfOneStep) {
  const MaskSequence unified = load("unified-curve");
  const double h = 0.6, mu = std::cos(h);
  const std::array<Rational, 1> at{Rational(mu)};
  const auto value = [&](const char* f) {
    return approx_double(defects(unified.mask, 0, read_exponential_function(f), false).front().value(at));
  };
  EXPECT_NEAR(step(
                  unified, mu, 1, [](double y) { return y * y; }, h) -
                  h * h,
              h * h * value("y^2"), 1e-15);
  EXPECT_NEAR(step(
                  unified, mu, 1, [](double y) { return std::cos(2 * y); }, h) -
                  std::cos(2 * h),
              std::cos(2 * h) * value("cos(2y)"), 1e-14);
  // y e^{iy} at i + 1: h e^{iy} M_1, M_1 = -i sin(x) (odd part) up to sign.
  const double sine = step(
                          unified, mu, 1, [](double y) { return y * std::sin(y); }, h) -
                      h * std::sin(h);
  EXPECT_NEAR(std::abs(sine), std::abs(h * std::sin(h) * value("y cos") * std::cos(h)), 1e-14);
}

// Dual schemes generate with a parameter shift that they need not reproduce with [Dyn & Levin 1995].
TEST(SpaceMoments, ExponentialSplinesGenerateMoreThanTheyReproduce) {
  const MaskSequence quadratic = load("exponential-b-spline-3"), cubic = load("exponential-b-spline-4");
  EXPECT_EQ(parameter_tau(quadratic), Rational(1) / 2);
  EXPECT_EQ(parameter_tau(cubic), 0);
  const auto trigonometric = AngleType::trigonometric;
  EXPECT_EQ(to_string(reproduced_space(quadratic, trigonometric, true)), "{1, cos, sin}");
  EXPECT_EQ(to_string(reproduced_space(quadratic, trigonometric, false)), "{1}");
  EXPECT_EQ(to_string(reproduced_space(cubic, trigonometric, true)), "{1, y, cos, sin}");
  EXPECT_EQ(to_string(reproduced_space(cubic, trigonometric, false)), "{1, y}");
  EXPECT_EQ(to_string(reproduced_polynomials(quadratic)), "{1, y}");  // Chaikin
  // A step multiplies the cosine by mu.
  const auto defect = defects(cubic.mask, 0, read_exponential_function("cos"), false).front();
  EXPECT_EQ(defect.value, RationalFunction::variable(1, 0) - RationalFunction::constant(1, 1));
}

TEST(SpaceMoments, TheSixPointSchemeReproducesItsSpace) {
  const MaskSequence six = load("six-point-nonstationary");
  EXPECT_EQ(to_string(reproduced_space(six, AngleType::trigonometric, false)), "{1, y, y^2, y^3, cos, sin}");
  EXPECT_EQ(to_string(reproduced_polynomials(six)), "{1, y, y^2, y^3, y^4, y^5}");
}

TEST(SpaceMoments, EveryInterpolatedSpaceIsReproduced) {
  for (const char* text : {"{1, y}", "{cos, sin}", "{cos, sin, cos(2y), sin(2y)}", "{1, y, cos, sin, y cos, y sin}",
                           "{1, y, cos, sin, cos(2y), sin(2y)}", "{1, y, y^2, y^3, cos, sin, cos(2y), sin(2y)}"}) {
    const auto basis = read_exponential_functions(text);
    const Mask mask = interpolation_mask(basis);
    for (const ExponentialFunction& f : basis)
      EXPECT_TRUE(defects(mask, 0, f, false).empty()) << text << " " << to_string(f);
  }
}

}  // namespace
}  // namespace limes
