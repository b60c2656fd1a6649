#include "schemes/nonuniform/insertion_rule.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

Mask rule(const std::string& text, const VariableNames& names = {}) { return uniform_mask(InsertionRule(read_expression(text), names)); }

std::string failure(const std::string& text) {
  try {
    rule(text, {"w"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(UniformMask, CubicInterpolantIsTheFourPointScheme) {
  const std::vector<Rational> expected{Rational(-1) / 16, 0, Rational(9) / 16, 1, Rational(9) / 16, 0, Rational(-1) / 16};
  const Mask mask = rule("at(f(3,0),1/2)");
  EXPECT_EQ(mask.symbol.lowest(), -3);
  EXPECT_EQ(mask.symbol.rational_coefficients(), expected);
}

TEST(UniformMask, QuadraticInterpolantIsOneSided) {
  // f(2,0) interpolates p_{i-1}, p_i, p_{i+1}; at i + 1/2: (-p_{i-1} + 6 p_i + 3 p_{i+1}) / 8.
  const Mask mask = rule("at(f(2,0),1/2)");
  EXPECT_EQ(mask.symbol.coefficient(3), RationalFunction::constant(0, Rational(-1) / 8));
  EXPECT_EQ(mask.symbol.coefficient(1), RationalFunction::constant(0, Rational(3) / 4));
  EXPECT_EQ(mask.symbol.coefficient(-1), RationalFunction::constant(0, Rational(3) / 8));
}

// Karciauskas & Peters 2013, eq. (18) with equal knots: the 4-point scheme with parameter w.
TEST(UniformMask, WeightsMayDependOnParameters) {
  const Mask mask = rule("16*w*at(f(3,0),1/2) + (1-16*w)*at(f(1,0),1/2)", {"w"});
  const RationalFunction w = RationalFunction::variable(1, 0);
  EXPECT_EQ(mask.symbol.coefficient(3), -w);
  EXPECT_EQ(mask.symbol.coefficient(1), w + RationalFunction::constant(1, Rational(1) / 2));
  EXPECT_TRUE(interpolatory_index(mask).has_value());
}

// Karciauskas & Peters 2013, eq. (21) with equal knots is Weissman's scheme.
TEST(UniformMask, ShiftedInterpolantsAverageToWeissman) {
  const Mask mask = rule("(8/5-256/5*w)*at(f(5,0),1/2) + (1-8/5+256/5*w)/2*(at(f(3,-1),1/2)+at(f(3,1),1/2))", {"w"});
  const RationalFunction w = RationalFunction::variable(1, 0);
  EXPECT_EQ(mask.symbol.coefficient(5), w);
  EXPECT_EQ(mask.symbol.coefficient(3), RationalFunction::constant(1, -3) * w - RationalFunction::constant(1, Rational(1) / 16));
}

TEST(UniformMask, ErrorsNameTheReasonAndTheColumn) {
  EXPECT_NE(failure("at(g(3,0),1/2)").find("unknown function 'g'"), std::string::npos);
  EXPECT_NE(failure("f(3,0)").find("combination of sampled interpolants"), std::string::npos);
  EXPECT_NE(failure("f(3,0) + 1").find("sample it"), std::string::npos);
  EXPECT_NE(failure("at(f(3,0),w)").find("without parameters"), std::string::npos);
  EXPECT_NE(failure("at(f(3.5,0),1/2)").find("integer"), std::string::npos);
  EXPECT_NE(failure("at(f(3000,0),1/2)").find("integer from 0 to 63"), std::string::npos);
  EXPECT_NE(failure("at(f(3,0),1/2)/at(f(3,0),1/2)").find("divide by a sampled point"), std::string::npos);
  EXPECT_NE(failure("at(f(3,0),1/2)*at(f(3,0),1/2)").find("multiply two"), std::string::npos);
  EXPECT_NE(failure("at(f(3,0),1/2)/(w-w)").find("division by zero"), std::string::npos);
  EXPECT_NE(failure("1 + w").find("combination of sampled interpolants"), std::string::npos);
  EXPECT_NE(failure("2*at(f(3),1/2)").find("f takes two arguments"), std::string::npos);
}

// Each factor is harmless, and so is each weight at first.
TEST(UniformMask, ChainsThatWouldExplodeAreRefused) {
  const auto chain = [](const std::string& link, int times) {
    std::string text = "at(f(1,0),1/2)";
    for (int k = 0; k < times; ++k) text += link;
    return text;
  };
  EXPECT_THROW(rule(chain("*(1+w)^1000", 900), {"w"}), LimitError);
  EXPECT_THROW(rule(chain("*((1+w)*(1-w))^200", 3), {"w"}), LimitError);
  EXPECT_THROW(rule("at(f(63,0),1/" + std::string(9990, '7') + ")"), LimitError);
  EXPECT_NO_THROW(rule(chain("*(1+w)", 300), {"w"}));
}

}  // namespace
}  // namespace limes
