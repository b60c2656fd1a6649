#include "analysis/surface/vertex_spectrum.hpp"

#include "algebra/error.hpp"
#include "analysis/surface/cosine_field.hpp"
#include "analysis/surface/spectrum_settings.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace limes {
namespace {

const LevelParameter limit{Rational(1), {}};

/// Whether the eigenvalues of Fourier index j are the expected reals, with their multiplicities in one block.
void expect_block(const std::vector<VertexEigenvalue>& all, int n, int j, std::vector<double> expected) {
  SCOPED_TRACE("n = " + std::to_string(n) + ", j = " + std::to_string(j));
  for (const VertexEigenvalue& e : all) {
    if (e.fourier != j) continue;
    EXPECT_FALSE(e.is_cluster);
    const int blocks = j == 0 || 2 * j == n ? 1 : 2;
    EXPECT_EQ(e.multiplicity % blocks, 0);
    for (int k = 0; k < e.multiplicity / blocks; ++k) {
      const auto found = std::find_if(expected.begin(), expected.end(), [&](double x) { return std::abs(x - approx_double(e.re.midpoint())) < 1e-12; });
      ASSERT_NE(found, expected.end()) << approx_double(e.re.midpoint());
      EXPECT_TRUE(e.im.is_point());
      EXPECT_LE(e.re.width(), Rational(1) / power(Rational(2), 60));
      expected.erase(found);
    }
  }
  EXPECT_TRUE(expected.empty());
}

int total(const std::vector<VertexEigenvalue>& all) {
  int sum = 0;
  for (const VertexEigenvalue& e : all) sum += e.multiplicity;
  return sum;
}

// Doo & Sabin 1978: 1; 1/2 in the blocks 1 and n-1; 1/4 in the others.
TEST(VertexSpectrum, DooSabin) {
  const VertexSpectrum spectrum(load_scheme("doo-sabin").surface->rings);
  for (int n = 3; n <= 50; ++n) {
    const std::vector<VertexEigenvalue> all = spectrum.eigenvalues(n, limit);
    EXPECT_EQ(total(all), spectrum.size(n));
    EXPECT_EQ(spectrum.size(n), n);
    EXPECT_EQ(all[0].re, Interval::point(1));
    EXPECT_EQ(all[1].re, Interval::point(Rational(1) / 2));
    EXPECT_EQ(all[1].multiplicity, 2);
    EXPECT_EQ(all[1].fourier, 1);
    for (std::size_t k = 2; k < all.size(); ++k) EXPECT_EQ(all[k].re, Interval::point(Rational(1) / 4));
  }
}

// Doo & Sabin 1978; Peters & Reif 2008: (5 + c +- sqrt((c + 9)(c + 1)))/16, and (3 n - 7 +- sqrt(5 n^2 - 30 n + 49))/(8 n).
TEST(VertexSpectrum, CatmullClark) {
  const VertexSpectrum spectrum(load_scheme("catmull-clark").surface->rings);
  for (int n = 3; n <= 50; ++n) {
    const std::vector<VertexEigenvalue> all = spectrum.eigenvalues(n, limit);
    EXPECT_EQ(total(all), 2 * n + 1);
    const double root = std::sqrt(5. * n * n - 30. * n + 49);
    expect_block(all, n, 0, {1, (3 * n - 7 + root) / (8 * n), (3 * n - 7 - root) / (8 * n)});
    for (int j = 1; 2 * j <= n; ++j) {
      const double c = std::cos(2 * M_PI * j / n), square = std::sqrt(std::max((c + 9) * (c + 1), 0.));
      expect_block(all, n, j, {(5 + c + square) / 16, (5 + c - square) / 16});
    }
    EXPECT_EQ(all[1].fourier, 1);
    EXPECT_EQ(all[1].multiplicity, 2);
  }
}

// At n = 4 the scheme is a tensor product: 1/2 twice for every mu, exactly.
TEST(VertexSpectrum, UnifiedAtValenceFourHasOneHalfTwice) {
  const Scheme scheme = load_scheme("unified");
  const VertexSpectrum spectrum(scheme.surface->rings);
  for (const std::string settings : {"mu=1", "mu=1/2", "mu=7", "theta=pi/3", "theta=2*pi/5", "theta=1"}) {
    for (int level = 0; level < 2; ++level) {
      const std::vector<VertexEigenvalue> all = spectrum.eigenvalues(4, spectrum_settings(scheme, {settings}).at_level(level));
      const auto half = std::find_if(all.begin(), all.end(), [](const VertexEigenvalue& e) { return e.re == Interval::point(Rational(1) / 2) && e.im == Interval::point(0); });
      ASSERT_NE(half, all.end()) << settings;
      EXPECT_EQ(half->fourier, 1);
      EXPECT_EQ(half->multiplicity, 2);
      EXPECT_EQ(total(all), 25);
    }
  }
}

// The products of the curve's eigenvalues on five points, 1, 1/2, 1/4 (twice), 1/8, at mu = 1.
TEST(VertexSpectrum, UnifiedAtValenceFourIsTheTensorProduct) {
  const std::vector<VertexEigenvalue> all = VertexSpectrum(load_scheme("unified").surface->rings).eigenvalues(4, limit);
  const std::vector<Rational> curve{1, Rational(1) / 2, Rational(1) / 4, Rational(1) / 4, Rational(1) / 8};
  std::map<Rational, int> expected, found;
  for (const Rational& x : curve) {
    for (const Rational& y : curve) ++expected[x * y];
  }
  for (const VertexEigenvalue& e : all) {
    ASSERT_TRUE(e.re.is_point() && e.im == Interval::point(0));
    found[e.re.lower] += e.multiplicity;
  }
  EXPECT_EQ(found, expected);
}

TEST(VertexSpectrum, MoreRingsAddOnlySmallEigenvalues) {
  const RingRule rule = load_scheme("unified").surface->rings;
  const VertexSpectrum two(rule, 2), three(rule, 3);
  for (const int n : {3, 5, 6, 7}) {
    const std::vector<VertexEigenvalue> inner = two.eigenvalues(n, limit), outer = three.eigenvalues(n, limit);
    EXPECT_EQ(total(inner), 1 + 6 * n);
    EXPECT_EQ(total(outer), 1 + 12 * n);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LE(outer[k].modulus.lower, inner[k].modulus.upper);
      EXPECT_GE(outer[k].modulus.upper, inner[k].modulus.lower);
      EXPECT_EQ(outer[k].multiplicity, inner[k].multiplicity);
    }
  }
}

// The irrational level parameter and the nearby rational one.
TEST(VertexSpectrum, EnclosuresAtALevelAreNearThoseOfANearbyRationalParameter) {
  const Scheme scheme = load_scheme("unified");
  const VertexSpectrum spectrum(scheme.surface->rings);
  const SpectrumSettings settings = spectrum_settings(scheme, {"theta=9/10", "type=hyperbolic"});
  for (const int n : {3, 5, 8, 9}) {
    const LevelParameter level = settings.at_level(1);
    const std::vector<VertexEigenvalue> irrational = spectrum.eigenvalues(n, level);
    const std::vector<VertexEigenvalue> rational = spectrum.eigenvalues(n, {simplest_between(level.enclosure(60).lower, level.enclosure(60).upper), {}});
    EXPECT_EQ(total(irrational), 1 + 6 * n);
    EXPECT_EQ(total(rational), 1 + 6 * n);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LT(std::abs(approx_double(irrational[k].modulus.midpoint() - rational[k].modulus.midpoint())), 1e-12);
      EXPECT_FALSE(irrational[k].is_cluster);
    }
  }
}

// The eigenvalues c/4 and -(4 c^2 - 1)/8 differ as polynomials in c, and are equal at n = 5, where c^2 = 1/4 - c/2.
TEST(VertexSpectrum, EigenvaluesThatAreEqualAtOneValenceOnlyAreADoubleOneThere) {
  const Scheme scheme = read_scheme(R"toml(
name = "double"
kind = "surface"
[surface]
curve = "b-spline-1"
[surface.rules]
"0,0" = "at(0,0)"
"1,0" = "3/4*at(0,0) + 1/8*at(1,0,1) + 1/8*at(1,0,-1)"
"1,1" = "11/8*at(0,0) - 1/8*at(1,1,2) - 1/8*at(1,1,-2) - 1/8*at(1,1)"
)toml", "double.toml");
  const VertexSpectrum spectrum(scheme.surface->rings);
  for (const int n : {5, 7}) {
    const std::vector<VertexEigenvalue> all = spectrum.eigenvalues(n, limit);
    EXPECT_EQ(total(all), 1 + 2 * n);
    for (int j = 1; 2 * j < n; ++j) {
      std::vector<int> multiplicities;
      for (const VertexEigenvalue& e : all) {
        if (e.fourier != j) continue;
        EXPECT_FALSE(e.is_cluster);
        multiplicities.push_back(e.multiplicity);
        if (n == 5) { EXPECT_NEAR(approx_double(e.re.midpoint()), std::cos(2 * M_PI * j / n) / 4, 1e-15); }
      }
      EXPECT_EQ(multiplicities, n == 5 ? std::vector<int>{4} : (std::vector<int>{2, 2}));
    }
  }
}

TEST(VertexSpectrum, ASpokeRuleThatIsNotMirrorSymmetricIsRefused) {
  RingRule rule = load_scheme("doo-sabin").surface->rings;
  rule.given.at({0, 0}).push_back({{0, 0}, 1, -1, RationalFunction::constant(2, Rational(1) / 9)});
  EXPECT_THROW(VertexSpectrum{rule}, InputError);
}

TEST(CosineField, MinimalPolynomials) {
  for (int n = 1; n <= 30; ++n) {
    for (int j = 0; j <= n; ++j) {
      const Polynomial p = minimal_polynomial_of_cosine(n, j);
      double value = 0;
      for (int k = p.degree(); k >= 0; --k) value = value * std::cos(2 * M_PI * j / n) + approx_double(p.coefficient(k));
      EXPECT_LT(std::abs(value), 1e-9) << n << " " << j;
      EXPECT_EQ(p.leading_coefficient(), 1);
    }
  }
  EXPECT_EQ(minimal_polynomial_of_cosine(5, 2), Polynomial({-Rational(1) / 4, Rational(1) / 2, 1}));
}

// (x - c)^2 (x + 1) over Q(cos(2 pi/7)).
TEST(CosineField, SquareFreeParts) {
  const Polynomial minimal = minimal_polynomial_of_cosine(7, 1), one = Polynomial::constant(1), c = Polynomial::monomial(1, 1);
  const CosinePolynomial a{-c, one}, b{one, one};
  const auto parts = square_free_factorisation(multiply(multiply(a, b, minimal), a, minimal), minimal);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0], (std::pair{b, 1}));
  EXPECT_EQ(parts[1], (std::pair{a, 2}));
}

TEST(SpectrumSettings, AngleTypesAndErrors) {
  const Scheme scheme = load_scheme("unified");
  EXPECT_EQ(spectrum_settings(scheme, {}).mu, Rational(1));
  EXPECT_EQ(spectrum_settings(scheme, {"theta=2*pi/3"}).at_level(0).exact, Rational(1) / 2);
  EXPECT_FALSE(spectrum_settings(scheme, {"theta=pi/3"}).at_level(0).exact);
  const Interval mu = spectrum_settings(scheme, {"theta=pi/3"}).at_level(1).enclosure(100);
  EXPECT_LT(std::abs(approx_double(mu.midpoint()) - std::cos(M_PI / 12)), 1e-15);
  EXPECT_LT(mu.width(), Rational(1) / power(Rational(2), 95));
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"theta=4"}, {"theta=1", "theta=1"}, {"mu=1", "theta=1"}, {"type=hyperbolic"}, {"type=cubic"}, {"nu=1"}, {"theta=[0,1]"}, {"theta"}})
    { EXPECT_THROW(spectrum_settings(scheme, bad), InputError) << bad.front(); }
}

}  // namespace
}  // namespace limes
