#include "analysis/spectral_radius/polytope_norm.hpp"

#include "analysis/spectral_radius/leading_words.hpp"
#include "tests/analysis/spectral_radius/families.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace limes;
using test::golden;
using test::matrix;

TEST(LeadingWords, GoldenRatioPair) {
  const std::vector<LeadingWord> words = approx_leading_words(golden(), {}, 1e-9, {});
  EXPECT_EQ(words.front().word, (Word{0, 1}));
  EXPECT_NEAR(words.front().radius, (1 + std::sqrt(5.0)) / 2, 1e-12);
}

TEST(PolytopeNorm, GoldenRatioPairToSixDigits) {
  const Rational bound = Rational(1618035) / 1000000;
  const auto norm = find_polytope(golden(), bound, {}, {});
  ASSERT_TRUE(norm);
  EXPECT_EQ(norm->form.sizes, (std::vector<int>{2}));
  EXPECT_LE(exact_polytope_bound(norm->blocks[0], golden()), bound);
  EXPECT_FALSE(find_polytope(golden(), Rational(1618033) / 1000000, {200, 64}, {}));
}

TEST(PolytopeNorm, RotationHasAComplexLeadingEigenvalue) {
  const MatrixFamily family{matrix({{Rational(3) / 5, Rational(-4) / 5}, {Rational(4) / 5, Rational(3) / 5}})};
  const auto norm = find_polytope(family, Rational(1000000001) / 1000000000, {}, {});
  ASSERT_TRUE(norm);
  EXPECT_EQ(norm->blocks[0].vectors.size(), 1u);  // a complex one: its multiples are a circle
  EXPECT_FALSE(find_polytope(family, Rational(99) / 100, {200, 64}, {}));
}

TEST(PolytopeNorm, BlockTriangularFamily) {
  const MatrixFamily family{matrix({{1, 5, 7}, {0, 1, 1}, {0, 0, 1}}), matrix({{1, 0, 3}, {0, 1, 0}, {0, 1, 1}})};
  const auto norm = find_polytope(family, Rational(1619) / 1000, {}, {});
  ASSERT_TRUE(norm);
  EXPECT_EQ(norm->form.sizes.size(), 2u);
}
