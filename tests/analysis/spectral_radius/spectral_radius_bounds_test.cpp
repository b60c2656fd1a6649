#include "analysis/spectral_radius/spectral_radius_bounds.hpp"
#include "tests/analysis/spectral_radius/families.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

using namespace limes;
using test::matrix;

namespace {

MatrixFamily random_family(std::mt19937& random, int n, int count) {
  std::uniform_int_distribution<int> entry(-3, 3);
  MatrixFamily family;
  for (int e = 0; e < count; ++e) {
    RationalMatrix b(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) b(i, j) = entry(random);
    }
    family.push_back(std::move(b));
  }
  return family;
}

SpectralRadiusBounds bound(const MatrixFamily& family, int digits = 3, std::size_t max_vectors = 60) {
  return bound_spectral_radius(family, {digits, {max_vectors, 64}}, {});
}

/// Both intervals hold the same number.
void expect_overlap(const SpectralRadiusBounds& a, const SpectralRadiusBounds& b) {
  EXPECT_LE(a.lower, b.upper);
  EXPECT_LE(b.lower, a.upper);
}

/// What the bounds claim is proved by what comes with them.
void expect_proved(const SpectralRadiusBounds& bounds, const MatrixFamily& family) {
  EXPECT_LE(bounds.lower, bounds.upper);
  if (bounds.lower > 0) {
    EXPECT_TRUE(exact_radius_at_least(product(family, bounds.word), int(bounds.word.size()), bounds.lower));
  }
  for (std::size_t k = 0; k < bounds.blocks.size(); ++k) {
    if (const auto* bounded = std::get_if<BoundedPolytope>(&bounds.blocks[k])) {
      EXPECT_LE(exact_polytope_bound(bounded->polytope, bounds.form.diagonal_block(k)), bounds.upper);
    }
  }
}

}  // namespace

TEST(SpectralRadiusBounds, GoldenRatioIsFoundExactly) {
  // The pair of Lagarias & Wang and others; the radius of the product of both, (3 + sqrt 5) / 2, is the golden ratio squared.
  const MatrixFamily family{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};
  const SpectralRadiusBounds bounds = bound(family);
  ASSERT_TRUE(bounds.exact);
  EXPECT_EQ(bounds.exact->polynomial, Polynomial({-1, -1, 1}));
  EXPECT_EQ(bounds.word, (Word{0, 1}));
  expect_proved(bounds, family);
}

TEST(SpectralRadiusBounds, Gripenberg1996Example) {
  const SpectralRadiusBounds bounds = bound(test::gripenberg(), 6, 1000);
  expect_proved(bounds, test::gripenberg());
  EXPECT_GE(bounds.lower, Rational(6596789, 10000000));
  EXPECT_LE(bounds.upper, Rational(6596924, 10000000));
}

TEST(SpectralRadiusBounds, RankOnePair) {
  // The radii of both matrices are 1, that of the product is 2: sqrt 2.
  const SpectralRadiusBounds bounds = bound({matrix({{1, 1}, {0, 0}}), matrix({{1, 0}, {1, 0}})});
  ASSERT_TRUE(bounds.exact);
  EXPECT_EQ(bounds.exact->polynomial, Polynomial({-2, 0, 1}));
}

TEST(SpectralRadiusBounds, BlondelMegretskiStylePair) {
  // Scaling one matrix of the golden pair by 4/5: the word 01 still leads, the radius is the golden ratio times sqrt(4/5).
  const MatrixFamily family{matrix({{1, 1}, {0, 1}}), matrix({{Rational(4, 5), 0}, {Rational(4, 5), Rational(4, 5)}})};
  const SpectralRadiusBounds bounds = bound(family, 6, 400);
  expect_proved(bounds, family);
  EXPECT_LE(bounds.upper, bounds.lower * Rational(1000001, 1000000));
  EXPECT_GE(approx_double(bounds.upper), (1 + std::sqrt(5.0)) / 2 * std::sqrt(0.8) - 1e-9);
}

TEST(SpectralRadiusBounds, ComplexLeadingEigenvalue) {
  const MatrixFamily family{matrix({{Rational(3, 5), Rational(-4, 5)}, {Rational(4, 5), Rational(3, 5)}}), matrix({{0, Rational(1, 2)}, {0, 0}})};
  const SpectralRadiusBounds bounds = bound(family, 6);
  expect_proved(bounds, family);
  EXPECT_LE(bounds.lower, 1);
  EXPECT_GE(bounds.upper, 1);
  EXPECT_LE(bounds.upper - bounds.lower, Rational(1, 1000000));
}

TEST(SpectralRadiusBounds, NilpotentFamiliesHaveRadiusZero) {
  const SpectralRadiusBounds bounds = bound({matrix({{0, 1, 5}, {0, 0, 2}, {0, 0, 0}}), matrix({{0, 7, 1}, {0, 0, -1}, {0, 0, 0}})});
  EXPECT_EQ(bounds.lower, 0);
  EXPECT_EQ(bounds.upper, 0);
}

TEST(SpectralRadiusBounds, OneMatrixHasItsSpectralRadius) {
  const SpectralRadiusBounds bounds = bound({matrix({{2, 1}, {1, 1}})}, 6);
  ASSERT_TRUE(bounds.exact);
  EXPECT_EQ(bounds.exact->polynomial, Polynomial({1, -3, 1}));
}

TEST(SpectralRadiusBounds, DefectiveLeadingEigenvalue) {
  // A Jordan block: products grow linearly, no norm has the value 1 itself, but the two 1 x 1 blocks have.
  const SpectralRadiusBounds bounds = bound({matrix({{1, 1}, {0, 1}})}, 6);
  EXPECT_EQ(bounds.lower, 1);
  EXPECT_EQ(bounds.upper, 1);
  EXPECT_EQ(bounds.form.sizes, (std::vector<int>{1, 1}));
}

TEST(SpectralRadiusBounds, RandomFamilies) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 1000; ++trial) {
    const MatrixFamily family = random_family(random, 2, 1 + trial % 3);
    const SpectralRadiusBounds bounds = bound(family, 2, 30);
    ASSERT_LE(bounds.lower, bounds.upper) << "trial " << trial;
    if (trial % 20 == 0) expect_proved(bounds, family);
  }
}

TEST(SpectralRadiusBounds, Invariances) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 40; ++trial) {
    const MatrixFamily family = random_family(random, 2 + trial % 2, 2);
    const SpectralRadiusBounds bounds = bound(family);
    // Transposition.
    expect_overlap(bounds, bound(transposed(family)));
    // Scaling.
    SpectralRadiusBounds tripled = bound(scaled(family, Rational(-3, 2)));
    tripled.lower *= Rational(2, 3);
    tripled.upper *= Rational(2, 3);
    expect_overlap(bounds, tripled);
    // Similarity by a unipotent matrix.
    const int n = family_size(family);
    RationalMatrix t = RationalMatrix::identity(n), inverse = t;
    t(0, n - 1) = 2;
    inverse(0, n - 1) = -2;
    MatrixFamily similar;
    for (const RationalMatrix& b : family) similar.push_back(inverse * b * t);
    expect_overlap(bounds, bound(similar));
  }
}

TEST(SpectralRadiusBounds, BlockTriangularFamiliesHaveTheGreatestRadiusOfTheirBlocks) {
  std::mt19937 random(13);
  std::uniform_int_distribution<int> entry(-2, 2);
  for (int trial = 0; trial < 25; ++trial) {
    const MatrixFamily top = random_family(random, 2, 2), bottom = random_family(random, 2, 2);
    MatrixFamily family;
    RationalMatrix t = RationalMatrix::identity(4), inverse = t;   // hides the blocks
    t(3, 0) = 1;
    inverse(3, 0) = -1;
    for (int e = 0; e < 2; ++e) {
      RationalMatrix b(4, 4);
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          b(i, j) = top[std::size_t(e)](i, j);
          b(i, 2 + j) = entry(random);
          b(2 + i, 2 + j) = bottom[std::size_t(e)](i, j);
        }
      }
      family.push_back(inverse * b * t);
    }
    const SpectralRadiusBounds whole = bound(family), first = bound(top), second = bound(bottom);
    EXPECT_GE(whole.form.sizes.size(), 2u);
    EXPECT_LE(whole.lower, std::max(first.upper, second.upper));
    EXPECT_GE(whole.upper, std::max(first.lower, second.lower));
  }
}

TEST(SpectralRadiusBounds, MoreDigitsNarrowTheBounds) {
  const MatrixFamily family{matrix({{1, 2}, {-1, 1}}), matrix({{0, 1}, {1, 1}})};
  SpectralRadiusBounds last = bound(family, 1, 400);
  for (int digits = 2; digits <= 7; ++digits) {
    const SpectralRadiusBounds next = bound(family, digits, 400);
    expect_overlap(last, next);
    EXPECT_LE(next.upper - next.lower, last.upper - last.lower);
    EXPECT_LE(next.upper - next.lower, next.lower * power(Rational(1, 10), digits));
    last = next;
  }
}

TEST(SpectralRadiusBounds, StoppedAtOnceTheBoundsStillHold) {
  const std::atomic<bool> flag{true};
  const Stop stop(&flag);
  const SpectralRadiusBounds bounds = bound_spectral_radius({matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})}, {}, stop);
  EXPECT_TRUE(bounds.interrupted);
  EXPECT_EQ(bounds.lower, 0);
  EXPECT_EQ(bounds.upper, 2);
}

TEST(SpectralRadiusBounds, FieldsUpToADegree) {
  const MatrixFamily golden{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};
  for (const int degree : {1, 2}) {
    const SpectralRadiusBounds bounds = bound_spectral_radius(golden, {.digits = 3, .polytopes = {.max_vectors = 200, .max_degree = degree}}, {});
    EXPECT_EQ(bounds.exact.has_value(), degree == 2);
    expect_proved(bounds, golden);
    EXPECT_LE(bounds.upper, bounds.lower * Rational(1001, 1000));
  }
  const SpectralRadiusBounds rational = bound_spectral_radius({matrix({{1, 1}, {0, 2}})}, {.digits = 3, .polytopes = {.max_degree = 1}}, {});
  ASSERT_TRUE(rational.exact);
  EXPECT_EQ(rational.lower, 2);
}

TEST(SpectralRadiusBounds, AKnownBoundTakesThePlaceOfPolytopes) {
  // Radius (3 + sqrt 5) / 2 to the power 1/2, the exact value not being looked for.
  const MatrixFamily golden{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};
  SpectralRadiusOptions options{.digits = 3, .polytopes = {.max_vectors = 200, .max_degree = 1}};
  const SpectralRadiusBounds without = bound_spectral_radius(golden, options, {});
  options.known_upper = without.upper;
  const SpectralRadiusBounds narrow = bound_spectral_radius(golden, options, {});
  EXPECT_EQ(narrow.lower, without.lower);
  EXPECT_GT(narrow.upper, without.upper) << "the row sums alone";
  expect_proved(narrow, golden);
  options.known_upper = without.lower * Rational(11, 10);
  const SpectralRadiusBounds wide = bound_spectral_radius(golden, options, {});
  EXPECT_LE(wide.upper, wide.lower * Rational(1001, 1000));
  expect_proved(wide, golden);
}
