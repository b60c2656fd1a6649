#include "analysis/surface/characteristic_map.hpp"

#include "algebra/error.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limes {
namespace {

struct Case {
  std::string name;
  RingRule rule;
  int rings;
};

std::vector<Case> cases() {
  std::vector<Case> result;
  for (const std::string name : {"unified", "catmull-clark", "doo-sabin"}) {
    const RingRule rule = load_scheme(name).surface->rings;
    result.push_back({name, rule, rule.invariant_rings(rule.curve.symbol.highest())});
  }
  return result;
}

ApproxCharacteristicMap map_of(const Case& c, int n) { return {c.rule, c.rings, n, std::cos(std::numbers::pi / n)}; }

TEST(CharacteristicMap, EigenvaluesOfCatmullClarkAndDooSabinAreTheKnownOnes) {
  for (int n = 3; n <= 20; ++n) {
    const double c = std::cos(2 * std::numbers::pi / n);
    EXPECT_NEAR(map_of(cases()[1], n).eigenvalue().value, (c + 5 + std::sqrt((c + 1) * (c + 9))) / 16, 1e-12) << n;
    EXPECT_NEAR(map_of(cases()[2], n).eigenvalue().value, 0.5, 1e-12) << n;
  }
}

TEST(CharacteristicMap, IsTheIdentityAtRegularVertices) {
  for (const Case& c : cases()) {
    const ApproxCharacteristicMap map = map_of(c, 4);
    const auto samples = map.samples(2);
    const std::complex<double> unit = samples[0][0] / double(map.reach());
    EXPECT_NEAR(map.eigenvalue().value, 0.5, 1e-12) << c.name;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (std::size_t b = 0; b < samples[i].size(); ++b) {
        const std::complex<double> t(map.reach() + double(i) / 4, double(b) / 4);
        EXPECT_LT(std::abs(samples[i][b] - unit * t), 1e-9) << c.name << " " << t;
      }
    }
  }
}

TEST(CharacteristicMap, RepeatsItselfAndFollowsTheSymmetry) {
  for (const Case& c : cases()) {
    for (const int n : {3, 5, 6, 17}) {
      const ApproxCharacteristicMap map = map_of(c, n);
      const auto samples = map.samples(5);
      const std::complex<double> omega = std::polar(1., 2 * std::numbers::pi / n);
      for (std::size_t b = 0; b < samples[0].size(); ++b)
        EXPECT_LT(std::abs(samples.back()[2 * b] * map.eigenvalue().value - samples[0][b]), 2e-3) << c.name << n;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_LT(std::abs(samples[i][0].imag()), 1e-9);
        EXPECT_LT(std::abs(samples[i].back() - omega * std::conj(samples[i].back())), 1e-9) << "on the diagonal";
      }
    }
  }
}

TEST(CharacteristicMap, HasClearSignsForEveryValenceTo50) {
  for (const Case& c : cases()) {
    for (int n = 3; n <= 50; ++n) {
      const std::optional<int> level = approx_map_level(c.rule, c.rings, n);
      ASSERT_TRUE(level) << c.name << n;
      EXPECT_LE(*level, 4) << c.name << n;
      const auto [jacobian, inward] = map_of(c, n).margins(*level);
      EXPECT_GT(jacobian, 0);
      EXPECT_GT(inward, 0);
    }
  }
}

TEST(CharacteristicMap, MarginsGrowWithTheLevelToThoseOfTheSamples) {
  for (const Case& c : cases()) {
    const ApproxCharacteristicMap map = map_of(c, 7);
    EXPECT_LT(map.margins(2).jacobian, map.margins(4).jacobian) << c.name;
    EXPECT_LT(map.margins(4).jacobian, 1);
  }
}

TEST(CharacteristicMap, IntervalsContainTheMapsInside) {
  for (const Case& c : cases()) {
    const double radius = 1. / 64;
    const ApproxCharacteristicMap wide(c.rule, c.rings, std::nullopt, 0.7, radius);
    for (const double s : {-1., -0.5, 0., 0.3, 1.}) {
      const ApproxMapNumber x = wide.eigenvalue();
      const ApproxCharacteristicMap thin(c.rule, c.rings, std::nullopt, 0.7 + s * radius);
      EXPECT_LE(std::abs(thin.eigenvalue().value - (x.value + s * x.slope)), x.error + 1e-12) << c.name << s;
    }
    EXPECT_LT(wide.margins(3).jacobian, ApproxCharacteristicMap(c.rule, c.rings, std::nullopt, 0.7).margins(3).jacobian);
  }
}

TEST(CharacteristicMap, FewPiecesCoverAllValences) {
  for (const Case& c : cases()) {
    const std::vector<MapPiece> pieces = approx_map_pieces(c.rule, c.rings, Rational(1, 2));
    ASSERT_FALSE(pieces.empty()) << c.name;
    EXPECT_LE(pieces.size(), 64u);
    EXPECT_EQ(pieces.back().to, Rational(1));
    for (std::size_t i = 1; i < pieces.size(); ++i) EXPECT_LT(pieces[i - 1].to, pieces[i].to);
  }
}

TEST(CharacteristicMap, TooFewRingsAreAnError) {
  const Case unified = cases().front();
  EXPECT_THROW(ApproxCharacteristicMap(unified.rule, 2, 5, std::cos(std::numbers::pi / 5)), InputError);
}

/// The spectral condition holds, lambda = 1/2, but the diagonal points K = -(L_0 + L_1) of the eigenvector lie on the wrong side.
TEST(CharacteristicMap, AFoldHasNoClearSigns) {
  Case c = cases().front();
  const auto term = [](int a, int b, int sector, int numerator, int denominator, int harmonic = -1) {
    return RingTerm{{a, b}, sector, harmonic, RationalFunction::constant(2, Rational(numerator, denominator))};
  };
  c.rule.given[{1, 0}] = {term(0, 0, 0, 3, 4), term(1, 0, 0, 1, 4), term(1, 0, 0, 1, 2, 1)};
  c.rule.given[{1, 1}] = {term(0, 0, 0, 4, 5), term(1, 1, 0, 2, 5), term(1, 0, 0, -1, 10), term(1, 0, 1, -1, 10)};
  for (const int n : {3, 5, 8}) {
    EXPECT_NEAR(map_of(c, n).eigenvalue().value, 0.5, 1e-12);
    EXPECT_FALSE(approx_map_level(c.rule, c.rings, n)) << n;
  }
  EXPECT_TRUE(approx_map_pieces(c.rule, c.rings, Rational(1, 2)).empty());
}

}  // namespace
}  // namespace limes
