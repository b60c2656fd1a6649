#include "schemes/unity/derive_mask.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

RefinementEquation equation_of(const std::string& weight) { return refinement_equation(read_weight(weight)); }

DerivedMask sampled(const std::string& weight, const MaskConstraints& constraints = {}, int samples = 2000, int precision = 53) {
  const RefinementEquation equation = equation_of(weight);
  return derive_mask(equation, sampled_least_squares(equation, samples, precision, {}), constraints);
}

DerivedMask integrated(const std::string& weight, const MaskConstraints& constraints = {}) {
  const RefinementEquation equation = equation_of(weight);
  return derive_mask(equation, integral_least_squares(equation, 4096, 53, {}), constraints);
}

/// sum_k (-1)^k k^j c_k
Rational alternating_moment(const std::vector<Rational>& mask, int j) {
  Rational sum;
  for (std::size_t k = 0; k < mask.size(); ++k) sum += (k % 2 ? -1 : 1) * power(Rational(static_cast<int>(k)), j) * mask[k];
  return sum;
}

Rational sum(const std::vector<Rational>& mask) {
  Rational total;
  for (const Rational& c : mask) total += c;
  return total;
}

template <class Call>
std::string reason_of(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.reason();
  }
  return "";
}

TEST(DeriveMask, SplinesGiveTheirExactMasks) {
  for (int degree = 1; degree <= 8; ++degree) {
    std::vector<Rational> binomial{Rational(1) / power(Rational(2), degree)};
    for (int k = 0; k <= degree; ++k) binomial.push_back(binomial.back() * (degree + 1 - k) / (k + 1));
    const std::string weight = "bspline(degree=" + std::to_string(degree) + ")";
    const DerivedMask by_samples = sampled(weight), by_integrals = integrated(weight);
    EXPECT_EQ(by_samples.mask, binomial) << weight;
    EXPECT_EQ(by_integrals.mask, binomial) << weight;
    EXPECT_TRUE(by_integrals.exact);
    EXPECT_EQ(by_integrals.error, 0);
    EXPECT_EQ(by_samples.equation.first_index(), -(degree + 2) / 2);
  }
}

TEST(MoltajiRunionsSamavati2016, Equation31WithFiveSamples) {
  // Chaikin's mask from the quadratic spline at 1/2, 1, .., 5/2 of [0, 3].
  const RefinementEquation equation =
      refinement_equation(read_weight("bspline(degree=2, centre=3/2)"), Interval{read_rational("1/2"), read_rational("5/2")}, {{0, 3}});
  const DerivedMask derived = derive_mask(equation, sampled_least_squares(equation, 5, 53, {}), {});
  EXPECT_EQ(derived.mask, (std::vector<Rational>{read_rational("1/4"), read_rational("3/4"), read_rational("3/4"), read_rational("1/4")}));
}

TEST(MoltajiRunionsSamavati2016, Figure7GlobalQuartic) {
  const RefinementEquation equation =
      refinement_equation(read_weight("polynomial(1+u+u^2+u^3+u^4, domain=[-1,1], global)"), std::nullopt, {{-2, 2}});
  const DerivedMask derived = derive_mask(equation, integral_least_squares(equation, 0, 53, {}), {});
  const std::vector<std::string> printed{"0.0386556", "-0.123698", "0.236816", "-0.116536", "0.0272624"};
  for (std::size_t k = 0; k < printed.size(); ++k) EXPECT_EQ(rounded_to_digits(derived.mask, 6)[k], read_rational(printed[k]));
  EXPECT_EQ(derived.error, 0);  // a global polynomial is refinable
}

TEST(DeriveMask, ConstraintsHoldExactlyAndCostSomething) {
  double before = sampled("cinpact(c=4, sigma=8.67)").error;
  for (int order = 1; order <= 6; ++order) {
    const DerivedMask derived = sampled("cinpact(c=4, sigma=8.67)", {.sum_rules = order});
    EXPECT_EQ(sum(derived.mask), 2);
    for (int j = 0; j < order; ++j) EXPECT_EQ(alternating_moment(derived.mask, j), 0) << order << ' ' << j;
    EXPECT_GE(derived.error, before * (1 - 1e-12));
    before = derived.error;
    EXPECT_EQ(derived.rank, 9 - 1 - order);
    for (const Rational& c : derived.mask) EXPECT_LE(denominator(c), Integer("1000000000000000000000")) << to_string(c);
  }
}

TEST(DeriveMask, InterpolationKeepsTheCentreAndKillsEvenShifts) {
  const DerivedMask derived = sampled("interpolating-cinpact(c=5, sigma=4.79)", {.sum_rules = 2, .interpolation = true});
  for (int k = 1; k < 11; k += 2) EXPECT_EQ(derived.mask[k] == 0, k != 5);
  EXPECT_EQ(derived.mask[5], 1);
  for (int k = 0; k < 11; ++k) EXPECT_EQ(derived.mask[k], derived.mask[10 - k]);
}

TEST(DeriveMask, SamplesIntegralsAndPrecisionsAgree) {
  for (const std::string weight : {"cinpact(c=3, sigma=7.27)", "polynomial(64-48*u^2+12*u^4-u^6, domain=[-2,2])"}) {
    const DerivedMask by_samples = sampled(weight, {}, 20001), by_mpfr = sampled(weight, {}, 20001, 160), by_integrals = integrated(weight);
    EXPECT_LT(by_mpfr.error / by_samples.error - 1, 1e-12);
    for (std::size_t k = 0; k < by_samples.mask.size(); ++k) {
      EXPECT_LT(abs(by_samples.mask[k] - by_mpfr.mask[k]), read_rational("1e-12"));
      EXPECT_LT(abs(by_samples.mask[k] - by_integrals.mask[k]), read_rational("1e-7"));
    }
  }
}

TEST(DeriveMask, ErrorDoesNotDependOnScale) {
  const DerivedMask once = integrated("polynomial(4-u^2, domain=[-2,2])"), twice = integrated("polynomial(8-2*u^2, domain=[-2,2])");
  EXPECT_EQ(once.mask, twice.mask);
  EXPECT_EQ(once.error, twice.error);
  EXPECT_GT(once.error, 0);
}

TEST(DeriveMask, NeighboursOfTheMinimumAreWorse) {
  const DerivedMask derived = integrated("polynomial(-125*u^2+75*u^3-15*u^4+u^5, domain=[0,5])");
  for (std::size_t k = 0; k < derived.mask.size(); ++k) {
    std::vector<Rational> moved = derived.mask;
    moved[k] += read_rational("1/1000");
    EXPECT_GT(derived.error_of(moved), derived.error);
  }
}

TEST(RefinementEquation, DefaultShifts) {
  EXPECT_EQ(equation_of("cinpact(c=5/2, sigma=6)").first_shift, read_rational("-5/2"));
  EXPECT_EQ(equation_of("cinpact(c=5/2, sigma=6)").count, 6);
  EXPECT_EQ(equation_of("cinpact(c=5/2, sigma=6)").first_index(), -3);
  EXPECT_EQ(equation_of("cinpact(c=3.684, sigma=6)").first_shift, -3);
  EXPECT_EQ(equation_of("polynomial(u^2*(5-u)^3, domain=[0,5])").count, 6);
  const RefinementEquation padded = refinement_equation(read_weight("cinpact(c=3.684, sigma=6)"), Interval{-4, 4});
  EXPECT_EQ(padded.first_shift, -4);
  EXPECT_EQ(padded.count, 9);
}

TEST(WeightFunction, SmoothnessAndSymmetry) {
  for (int degree = 0; degree <= 6; ++degree) EXPECT_EQ(bspline_weight(degree).smoothness(), degree - 1);
  EXPECT_EQ(read_weight("polynomial(64-48*u^2+12*u^4-u^6, domain=[-2,2])").smoothness(), 2);
  EXPECT_EQ(read_weight("polynomial(1+u, domain=[-2,2])").smoothness(), -1);
  EXPECT_EQ(read_weight("cinpact(c=2, sigma=3)").smoothness(), WeightFunction::infinitely_smooth);
  EXPECT_EQ(read_weight("polynomial(u^2*(4-u)^2, domain=[0,4])").axis(), Rational(2));
  EXPECT_EQ(read_weight("polynomial(-125*u^2+75*u^3-15*u^4+u^5, domain=[0,5])").axis(), std::nullopt);
  EXPECT_EQ(read_weight("cinpact(c=2, sigma=3, centre=1/2)").axis(), read_rational("1/2"));
}

TEST(WeightFunction, PiecewiseExpressions) {
  const auto expressions = [](const std::vector<std::string>& texts) {
    std::vector<Expression> result;
    for (const std::string& text : texts) result.push_back(read_expression(text));
    return result;
  };
  const WeightFunction hat = piecewise_weight({-1, 0, 1}, expressions({"1+u", "1-u"}));
  EXPECT_EQ(hat.smoothness(), 0);
  EXPECT_EQ(hat.axis(), Rational(0));
  const RefinementEquation equation = refinement_equation(hat);
  EXPECT_EQ(derive_mask(equation, integral_least_squares(equation, 0, 53, {}), {}).mask,
            (std::vector<Rational>{read_rational("1/2"), 1, read_rational("1/2")}));
  const WeightFunction cosine = piecewise_weight({-1, 1}, expressions({"(1+cos(pi*u))/2"}));
  EXPECT_NEAR(approx_values(cosine, {0.5})[0], 0.5, 1e-15);
  EXPECT_NE(reason_of([&] { piecewise_weight({-1, 1}, expressions({"tan(u)"})); }).find("tan"), std::string::npos);
  EXPECT_NE(reason_of([&] { refinement_equation(piecewise_weight({-1, 1}, expressions({"log(u-2)"}))); }).find("not finite"), std::string::npos);
}

TEST(DeriveMask, InputErrors) {
  const auto expect = [](const std::string& part, auto call) { EXPECT_NE(reason_of(call).find(part), std::string::npos) << reason_of(call); };
  expect("unknown weight function", [] { read_weight("gauss(sigma=1)"); });
  expect("needs 'sigma=..'", [] { read_weight("cinpact(c=1)"); });
  expect("no argument 'kappa'", [] { read_weight("cinpact(c=1, sigma=2, kappa=3)"); });
  expect("given twice", [] { read_weight("cinpact(c=1, c=2, sigma=3)"); });
  expect("no polynomial", [] { read_weight("polynomial(1/u, domain=[1,2])"); });
  expect("sum of the weights", [] { equation_of("cinpact(c=1/2, sigma=3)"); });
  expect("sum of the weights", [] { equation_of("polynomial(u, domain=[-2,2])"); });
  expect("no dilate", [] { refinement_equation(read_weight("cinpact(c=4, sigma=9)"), Interval{-1, 1}); });
  expect("whole number", [] { refinement_equation(read_weight("cinpact(c=4, sigma=9)"), std::nullopt, {{0, read_rational("1/2")}}); });
  expect("infeasible", [] { sampled("cinpact(c=1, sigma=3)", {.sum_rules = 4}); });
  expect("shift 0", [] { sampled("cinpact(c=5/2, sigma=3)", {.interpolation = true}); });
  expect("rank-deficient", [] {
    const RefinementEquation equation = refinement_equation(read_weight("bspline(degree=3)"), std::nullopt, {{-9, 9}});
    derive_mask(equation, sampled_least_squares(equation, 1000, 53, {}), {});
  });
  MaskConstraints constraints;
  expect("unknown constraint", [&] { read_constraint("smooth", constraints); });
  expect("order", [&] { read_constraint("sum-rules=0", constraints); });
}

}  // namespace
}  // namespace limes
