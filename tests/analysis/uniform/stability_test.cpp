#include "analysis/uniform/stability.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

Mask binary(const std::vector<Rational>& coefficients) { return {2, LaurentPolynomial::from_rationals(0, coefficients)}; }

TEST(Stability, BSplinesHaveIndependentShifts) {
  for (int degree = 1; degree <= 8; ++degree) {
    const RationalFunction scale = RationalFunction::constant(0, power(Rational(2), -degree));
    const Mask mask{2, scale * power(sigma(0, 2), degree + 1)};
    // The hat function and the box are cardinal.
    EXPECT_EQ(prove_stability(mask), degree <= 1 ? Stability::interpolatory : Stability::linear_independence);
  }
}

TEST(Stability, StretchedSplinesAreUnstable) {
  // (1 + z)(1 + z^3), which vanishes at the primitive 6th roots of unity, and (1 + z)(1 + z^2): dependent shifts.
  EXPECT_EQ(prove_stability(binary({Rational(1) / 2, Rational(1) / 2, 0, Rational(1) / 2, Rational(1) / 2})), std::nullopt);
  EXPECT_EQ(prove_stability(binary({Rational(1) / 2, Rational(1) / 2, Rational(1) / 2, Rational(1) / 2})), std::nullopt);
  // (1 + z)^2 (1 + z^3) / 4.
  EXPECT_EQ(prove_stability(binary({Rational(1) / 4, Rational(1) / 2, Rational(1) / 4, Rational(1) / 4, Rational(1) / 2, Rational(1) / 4})), std::nullopt);
}

TEST(Stability, SymmetricZerosOffTheCircleAreRefusedToo) {
  // (4 z^2 - 1)(1 + z)^2 / 6
  EXPECT_EQ(prove_stability(binary({Rational(-1) / 6, Rational(-1) / 3, Rational(1) / 2, Rational(4) / 3, Rational(2) / 3})), std::nullopt);
}

TEST(Stability, AWrongSumIsRefused) {
  EXPECT_EQ(prove_stability(binary({Rational(9) / 10, Rational(9) / 5, Rational(9) / 10})), std::nullopt);
}

TEST(InterpolatoryIndex, FindsTheShift) {
  EXPECT_EQ(interpolatory_index(binary({Rational(1) / 2, 1, Rational(1) / 2})), 1);
  EXPECT_EQ(interpolatory_index(binary({Rational(1) / 4, Rational(3) / 4, Rational(3) / 4, Rational(1) / 4})), std::nullopt);
}

}  // namespace
}  // namespace limes
