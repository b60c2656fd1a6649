// Algorithm 5.1 of Moltaji, Runions & Samavati 2017: its printed examples, and properties for every mask.
#include "schemes/unity/multiresolution.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limes {
namespace {

std::vector<Rational> read(std::initializer_list<const char*> texts) {
  std::vector<Rational> result;
  for (const char* text : texts) result.push_back(read_rational(text));
  return result;
}

const std::vector<Rational> chaikin = read({"1/4", "3/4", "3/4", "1/4"});
const std::vector<Rational> cubic = read({"1/8", "1/2", "3/4", "1/2", "1/8"});
const std::vector<Rational> interpolating_cinpact =
    read({"0.0240126", "0", "-0.129882", "0", "0.606154", "0.99909", "0.606154", "0", "-0.129882", "0", "0.0240126"});
const std::vector<Rational> cinpact =
    read({"0.00561628", "0.206365", "0.482727", "0.610716", "0.482727", "0.206365", "0.00561628"});
const std::vector<Rational> asymmetric = read({"1/3", "-2", "5/7", "1", "0", "4", "1/9"});

Multiresolution found(const std::vector<Rational>& mask, int extension, Arithmetic arithmetic = Arithmetic::exact,
                      std::optional<int> shift = {}) {
  MultiresolutionOptions options;
  options.extension = extension;
  options.arithmetic = arithmetic;
  options.shift = shift;
  return find_multiresolution(mask, options);
}

/// The numbers of the paper, with their number of significant digits.
void expect_printed(const std::vector<Rational>& computed, const std::vector<double>& printed, double unit) {
  ASSERT_GE(computed.size(), printed.size());
  for (std::size_t i = 0; i < computed.size(); ++i)
    EXPECT_NEAR(approx_double(computed[i]), i < printed.size() ? printed[i] : 0, unit) << i;
}

double error(const Multiresolution& m) { return std::sqrt(approx_double(m.squared_error)); }

TEST(MoltajiRunionsSamavati2017, ChaikinEquations43And48) {
  const Multiresolution m = found(chaikin, 0);
  EXPECT_EQ(m.bank.q, read({"1/4", "3/4", "-3/4", "-1/4"}));
  EXPECT_EQ(m.bank.a, read({"-1/4", "3/4", "3/4", "-1/4"}));
  EXPECT_EQ(m.bank.b, read({"-1/4", "3/4", "-3/4", "1/4"}));
  EXPECT_EQ(m.bank.shift, 0);
  EXPECT_EQ(m.squared_error, Rational(9) / 32);
  EXPECT_NEAR(error(m), 0.53033, 5e-6);
}

TEST(MoltajiRunionsSamavati2017, ChaikinShiftedEquations55And56) {
  const Multiresolution right = found(chaikin, 0, Arithmetic::exact, -2),
                        left = found(chaikin, 0, Arithmetic::exact, 2);
  expect_printed(right.bank.q, {-1.30932, 0.0720339, 0.572034, 0.190678}, 5e-6);
  expect_printed(left.bank.q, {-0.190678, -0.572034, -0.0720339, 1.30932}, 5e-6);
  EXPECT_NEAR(error(right), 1.02588, 5e-6);
  EXPECT_EQ(right.squared_error, left.squared_error);
}

TEST(MoltajiRunionsSamavati2017, ChaikinExtendedEquation61) {
  const Multiresolution m = found(chaikin, 2);
  expect_printed(m.bank.q, {-0.0857226, -0.257168, 0.03642, 0.795041, -0.619237, -0.206412}, 5e-7);
  EXPECT_NEAR(error(m), 0.34716, 5e-6);
  EXPECT_EQ(m.bank.shift, 0);
  EXPECT_EQ(m.bank.p, read({"1/4", "3/4", "3/4", "1/4", "0", "0"}));
}

TEST(MoltajiRunionsSamavati2017, InterpolatingCinpactFilterIsOneOfTwoMirrorImages) {
  const std::vector<double> printed{0.00876249, 0, -0.0473956, 0, -0.779718, 0.36458,
                                    0.221193,   0, -0.0473956, 0, 0.00876249};
  const Multiresolution shifted = found(interpolating_cinpact, 0, Arithmetic::exact, -2);
  expect_printed(shifted.bank.q, printed, 5e-7);
  const Multiresolution ours = found(interpolating_cinpact, 0);
  EXPECT_EQ(ours.bank.shift, 0);  // the rule for ties
  EXPECT_EQ(ours.squared_error, shifted.squared_error);
  std::vector<double> mirrored(printed.rbegin(), printed.rend());
  expect_printed(ours.bank.q, mirrored, 5e-7);
}

TEST(MoltajiRunionsSamavati2017, Figure12HasNearlyTheSquaresOfTheErrors) {
  // 7.58657 and 0.285485 are printed; the squares are close and not equal.
  EXPECT_NEAR(approx_double(found(cinpact, 0).squared_error), 7.57748, 5e-6);
  EXPECT_NEAR(approx_double(found(cinpact, 8).squared_error), 0.285383, 5e-7);
}

/// "Increasing bandwidth decreases the orthogonality error"; "masks of the same size may have different errors"; the least errors are those of the polynomial
/// of degree 10 and of interpolating CINPACT.
TEST(MoltajiRunionsSamavati2017, Figure7ErrorAgainstFilterSize) {
  const std::vector<Rational> degree6 = read({"0.218601", "0.487201", "0.593167", "0.487201", "0.218601"}),
                              degree10 = read({"0.109218", "0.520687", "0.747163", "0.520687", "0.109218"});
  constexpr int greatest = 12;
  std::vector<double> last;
  for (const auto& mask : {interpolating_cinpact, degree10, cinpact, degree6}) {
    const Multiresolution m = found(mask, greatest);
    ASSERT_EQ(m.steps.size(), greatest / 2 + 1u);
    for (std::size_t k = 0; k + 1 < m.steps.size(); ++k) EXPECT_LT(m.steps[k + 1].squared_error, m.steps[k].squared_error) << k;
    last.push_back(error(m));
  }
  EXPECT_LT(std::max(last[0], last[1]), std::min(last[2], last[3]));
  EXPECT_EQ(degree6.size(), degree10.size());
}

TEST(Multiresolution, ExactBiorthogonalityForAllMasksExtensionsAndShifts) {
  for (const auto& mask : {chaikin, cubic, interpolating_cinpact, cinpact, asymmetric}) {
    for (const int extension : {0, 2, 6, 12}) {
      const Multiresolution m = found(mask, extension);
      EXPECT_EQ(exact_biorthogonality_defect(m.bank), 0);
      EXPECT_EQ(exact_squared_orthogonality_error(m.bank), m.squared_error);
      EXPECT_EQ(m.bank.length() % 2, 0);
      for (std::size_t i = 0; i < m.bank.p.size(); ++i) EXPECT_EQ(m.bank.p[i], i < mask.size() ? mask[i] : Rational(0));
      const int length = static_cast<int>(mask.size() + 1) / 2 * 2 + extension;
      for (int shift = 2 - length; shift <= length - 2 - extension; shift += 2)
        EXPECT_EQ(exact_biorthogonality_defect(found(mask, extension, Arithmetic::exact, shift).bank), 0) << shift;
    }
  }
}

TEST(Multiresolution, TheErrorIsLeastAmongAllSolutions) {
  // Every solution of the hard constraints is q + w(z^2) p(z): moving along any of them increases the error.
  std::mt19937 random(7);
  for (const auto& mask : {chaikin, interpolating_cinpact, asymmetric}) {
    const Multiresolution m = found(mask, 4);
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Rational> q = m.bank.q;
      for (int t = 0; t <= 2; ++t) {
        const Rational w = Rational(static_cast<int>(random() % 21) - 10) / 100;
        for (std::size_t j = 0; j + std::size_t(2 * t) < q.size(); ++j) q[j + std::size_t(2 * t)] += w * m.bank.p[j];
      }
      const FilterBank other = alternated_bank(m.bank.p, q, m.bank.shift, 4);
      EXPECT_EQ(exact_biorthogonality_defect(other), 0);
      EXPECT_GE(exact_squared_orthogonality_error(other), m.squared_error);
    }
  }
}

TEST(Multiresolution, ThreeArithmeticsAgree) {
  for (const auto& mask : {chaikin, cubic, interpolating_cinpact, cinpact, asymmetric}) {
    for (const int extension : {0, 2, 8}) {
      const Multiresolution exact = found(mask, extension), rounded = found(mask, extension, Arithmetic::binary64),
                            digits = found(mask, extension, Arithmetic::multiprecision);
      ASSERT_EQ(exact.bank.shift, rounded.bank.shift);
      ASSERT_EQ(exact.bank.shift, digits.bank.shift);
      ASSERT_EQ(exact.bank.extension, rounded.bank.extension);
      for (std::size_t i = 0; i < exact.bank.q.size(); ++i) {
        EXPECT_NEAR(approx_double(exact.bank.q[i]), approx_double(rounded.bank.q[i]), 1e-9);
        EXPECT_LT(abs(exact.bank.q[i] - digits.bank.q[i]), power(Rational(10), -40));
      }
    }
  }
}

TEST(Multiresolution, AMirroredMaskGivesMirroredFilters) {
  const std::vector<Rational> even = read({"2", "1/3", "-2", "5/7", "1", "0", "4", "1/9"});
  const std::vector<Rational> mirrored(even.rbegin(), even.rend());
  const Multiresolution x = found(even, 0), y = found(mirrored, 0);
  EXPECT_EQ(x.squared_error, y.squared_error);
  EXPECT_EQ(x.bank.shift, -y.bank.shift);
  for (std::size_t i = 0; i < x.bank.q.size(); ++i) EXPECT_EQ(abs(x.bank.q[i]), abs(y.bank.q[x.bank.q.size() - 1 - i]));
}

TEST(Multiresolution, ExtensionsNeverIncreaseTheErrorAndUselessOnesAreNotTaken) {
  const Multiresolution m = found(cinpact, 16);
  ASSERT_EQ(m.steps.size(), 9u);
  for (std::size_t i = 1; i < m.steps.size(); ++i) EXPECT_LE(m.steps[i].squared_error, m.steps[i - 1].squared_error);
  const Multiresolution haar = found(read({"1", "1"}), 6);
  EXPECT_EQ(haar.squared_error, 0);
  EXPECT_EQ(haar.bank.extension, 0);
  EXPECT_EQ(haar.bank.q, read({"-1/2", "1/2"}));
}

TEST(Multiresolution, ThresholdStopsAtTheFirstExtensionThatReachesIt) {
  MultiresolutionOptions options;
  options.extension = 20;
  options.threshold = Rational(1) / 10;
  const Multiresolution m = find_multiresolution(chaikin, options);
  EXPECT_TRUE(m.threshold_reached);
  EXPECT_LE(m.squared_error, Rational(1) / 100);
  ASSERT_GE(m.steps.size(), 2u);
  EXPECT_GT(m.steps[m.steps.size() - 2].squared_error, Rational(1) / 100);
  options.extension = 2;
  EXPECT_FALSE(find_multiresolution(chaikin, options).threshold_reached);
}

TEST(Multiresolution, DetailsOfConstantsAreTheAlternatingSum) {
  EXPECT_EQ(exact_detail_of_constants(found(chaikin, 2).bank), 0);
  EXPECT_EQ(abs(exact_detail_of_constants(found(cinpact, 2).bank)),
            abs(read_rational("0.610716") -
                2 * (read_rational("0.482727") + read_rational("0.00561628") - read_rational("0.206365"))));
}

TEST(Multiresolution, Errors) {
  EXPECT_THROW(found(read({"1/2", "1/2", "1/2", "1/2"}), 0), InputError);  // both parts vanish at -1
  EXPECT_THROW(found(read({"1"}), 0), InputError);
  EXPECT_THROW(found(chaikin, 3), InputError);
  EXPECT_THROW(found(chaikin, 1000), InputError);
  EXPECT_THROW(found(chaikin, 0, Arithmetic::exact, 4), InputError);
  EXPECT_THROW(found(chaikin, 0, Arithmetic::exact, 1), InputError);
}

}  // namespace
}  // namespace limes
