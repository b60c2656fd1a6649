#include "analysis/unity/projective_roughness.hpp"

#include "algebra/number/read_rational.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

std::vector<Rational> numbers(const std::vector<std::string>& texts) {
  std::vector<Rational> result;
  for (const std::string& text : texts) result.push_back(read_rational(text));
  return result;
}

const std::vector<std::vector<Rational>> masks{
    numbers({"0.109218", "0.520687", "0.747163", "0.520687", "0.109218"}),
    numbers({"0.353395", "0.397012", "0.436764", "0.418329", "0.226328", "0.170216"}),
    numbers({"0.0240126", "0", "-0.129882", "0", "0.606154", "0.99909", "0.606154", "0", "-0.129882", "0", "0.0240126"})};

TEST(MaskSection, RefinesWindows) {
  // A_e on the window f_s, f_{s-1}, .. is the window of S_a f at 2s + e.
  const std::vector<Rational>& mask = masks[1];
  const int n = static_cast<int>(mask.size()) - 1;
  std::vector<Rational> f;
  for (int k = 0; k < 40; ++k) f.push_back(Rational(k * k % 17) / 3);
  const int s = 20;
  for (const int e : {0, 1}) {
    std::vector<Rational> window;
    for (int i = 0; i < n; ++i) window.push_back(f[s - i]);
    const std::vector<Rational> image = mask_section(mask, e) * window;
    for (int i = 0; i < n; ++i) {
      Rational refined;
      for (int j = 0; j < 40; ++j) {
        const int k = 2 * s + e - i - 2 * j;
        if (k >= 0 && k <= n) refined += mask[k] * f[j];
      }
      EXPECT_EQ(image[i], refined);
    }
  }
}

/// The bounds hold for points and weights of the cone taken at random.
TEST(ProjectiveContraction, BoundsHoldForSamples) {
  std::mt19937 random(7);
  for (const auto& mask : masks) {
    const auto found = find_projective_contraction(mask, 1, 8, {});
    ASSERT_TRUE(found);
    EXPECT_LT(found->factor, 1);
    EXPECT_GE(found->norm, 1);
    const std::size_t n = mask.size() - 1;
    for (int trial = 0; trial < 60; ++trial) {
      std::vector<int> word;
      for (int k = 0; k < found->level; ++k) word.push_back(static_cast<int>(random() % 2));
      std::vector<Rational> weights, points, weighted;
      for (std::size_t k = 0; k < n; ++k) {
        const Rational t = Rational(static_cast<int>(random() % 5)) / 4;
        weights.push_back(found->cone.lower[k] + t * (found->cone.upper[k] - found->cone.lower[k]));
        points.push_back(Rational(static_cast<int>(random() % 2)));
        weighted.push_back(points[k] * weights[k]);
      }
      const RationalMatrix product = word_product(mask, word);
      const std::vector<Rational> x = product * weighted, y = product * weights;
      Rational least = x[0] / y[0], greatest = least, scale = y[0] / found->cone.lower[0];
      for (std::size_t i = 0; i < n; ++i) {
        least = std::min(least, Rational(x[i] / y[i]));
        greatest = std::max(greatest, Rational(x[i] / y[i]));
        scale = std::min(scale, Rational(y[i] / found->cone.lower[i]));
      }
      EXPECT_LE(greatest - least, found->factor);
      EXPECT_LE(std::max(abs(least - Rational(1) / 2), abs(greatest - Rational(1) / 2)), found->norm / 2);
      for (std::size_t i = 0; i < n; ++i) EXPECT_LT(y[i], scale * found->cone.upper[i]);
    }
  }
}

TEST(ProjectiveRoughness, EigenpairsAndQuotients) {
  for (const auto& mask : masks) {
    const auto contraction = find_projective_contraction(mask, 1, 8, {});
    const auto rough = find_projective_roughness(mask, *contraction, 8, 8, {});
    ASSERT_TRUE(rough);
    EXPECT_EQ(rough->window.size() % rough->contraction.level, 0u);
    EXPECT_GT(abs(rough->second.value) * power(Rational(2), static_cast<int>(rough->word.size())), rough->dominant.value);
    for (const ApproxEigenpair* pair : {&rough->dominant, &rough->second}) {
      const std::vector<Rational> image = word_product(mask, rough->word) * pair->vector;
      for (std::size_t i = 0; i < image.size(); ++i) EXPECT_LT(abs(image[i] - pair->value * pair->vector[i]), read_rational("1e-25"));
    }
  }
}

TEST(GrowingWord, ScaledSplines) {
  EXPECT_TRUE(find_growing_word(numbers({"1/4", "3/4", "3/4", "1/4"}), 4, {}));
  EXPECT_FALSE(find_growing_word(numbers({"0.24", "0.74", "0.74", "0.24"}), 6, {}));
}

}  // namespace
}  // namespace limes
