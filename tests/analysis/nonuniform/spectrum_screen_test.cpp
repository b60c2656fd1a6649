#include "analysis/nonuniform/spectrum_screen.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/schur_cohn.hpp"
#include "analysis/nonuniform/nelder_mead.hpp"
#include "analysis/nonuniform/subdivision_matrix.hpp"
#include "tests/analysis/nonuniform/rules.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

double greatest(const std::vector<double>& radii) { return *std::max_element(radii.begin(), radii.end()); }

// Its eigenvalues are those of L without 1, .., 2^-m: the characteristic polynomials agree.
TEST(SpectrumScreen, HasTheSpectrumOfTheSubdivisionMatrix) {
  const InsertionRule rule = test::a2_5_3();
  const Rational gamma = Rational(1) / 3, w = Rational(1) / 64;
  const double radius = SpectrumScreen(rule, 2, {gamma}, 1).approx_radii(std::vector<double>{1.0 / 64}).front();
  Polynomial chi = limes::characteristic_polynomial(SubdivisionMatrix(rule).at(std::vector<Rational>{w, gamma}));
  for (const int k : {0, 1, 2}) chi = divide(chi, Polynomial({-power(Rational(2), -k), 1})).first;
  // All roots inside of a slightly larger circle, not all inside of a slightly smaller one.
  const Rational scaled = Rational(Integer(std::llround(radius * 1e6))) / 4000000;
  EXPECT_TRUE(roots_inside_circle(chi, scaled * Rational(1001) / 1000));
  EXPECT_FALSE(roots_inside_circle(chi, scaled * Rational(999) / 1000));
}

// Karciauskas & Peters 2013, Proposition 4, and its remark that the scheme is not C^3.
TEST(SpectrumScreen, KnowsThePublishedSchemes) {
  const std::vector<double> w{0.0141};
  EXPECT_LT(greatest(SpectrumScreen(test::a2_5_3(), 2).approx_radii(w)), 1);
  EXPECT_GT(greatest(SpectrumScreen(test::a2_5_3(), 3).approx_radii(w)), 1);
  EXPECT_LT(greatest(SpectrumScreen(test::a3_5_3_3(), 3).approx_radii(w)), 1);
  EXPECT_LT(greatest(SpectrumScreen(test::ten_point(), 4).approx_radii(std::vector<double>{0.001})), 1);
}

TEST(SpectrumScreen, SmallRatiosAreNoTrouble) {
  const InsertionRule rule = test::ten_point();
  const auto radius = [&](int k) {
    return SpectrumScreen(rule, 4, {power(Rational(2), -k)}, 1).approx_radii(std::vector<double>{0.001}).front();
  };
  EXPECT_NEAR(radius(40), radius(50), 1e-6);
}

TEST(SpectrumScreen, RefusesWhatItCannotScreen) {
  EXPECT_THROW(SpectrumScreen(test::rule("w*w*at(f(3,0),1/2)+(1-w*w)*at(f(1,0),1/2)"), 1), DomainError);
  EXPECT_THROW(SpectrumScreen(test::a1_3_1(), 2), DomainError);
}

TEST(NelderMead, FindsTheMinimumOfAQuadraticFunction) {
  const auto f = [](std::span<const double> x) { return std::pow(x[0] - 1, 2) + 3 * std::pow(x[1] + 2, 2) + x[0] * x[1]; };
  const ApproxMinimum found = approx_minimum(f, {5, 5}, 1, 200);
  // The gradient 2 (x - 1) + y, 6 (y + 2) + x vanishes at (24/11, -26/11).
  EXPECT_NEAR(found.x[0], 24.0 / 11, 1e-5);
  EXPECT_NEAR(found.x[1], -26.0 / 11, 1e-5);
}

}  // namespace
}  // namespace limes
