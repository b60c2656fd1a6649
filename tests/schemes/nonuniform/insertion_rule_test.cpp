#include "schemes/nonuniform/insertion_rule.hpp"

#include "algebra/error.hpp"
#include "tests/schemes/nonuniform/rules.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

using namespace test;

// Where sums of coefficients for independent ratios are fast.
const std::vector<std::string> up_to_eight_points{
    "cr1",    "a1-3-1",   "repeated-cr1", "repeated-a1-3-1",       "cr2", "cu2-4",
    "a2-5-3", "a3-5-3-3", "a3-5",         "eight-point-nonuniform"};
const std::vector<std::string> all = [] {
  auto names = up_to_eight_points;
  names.push_back("ten-point-nonuniform");
  return names;
}();

std::vector<Rational> random_parameters(Generator& random, const InsertionRule& rule) {
  return random.point(rule.parameters());
}

// ---- published formulas

// Karciauskas & Peters 2013, eq. (17); beta_i = b1, beta_{i+1} = b2.
TEST(InsertionRule, PrintedFormula17) {
  const VariableNames names{"w", "b1", "b2"};
  const auto e = catalogue_rule("cr1").symbolic_stencil();
  ASSERT_EQ(e.size(), 4u);
  EXPECT_EQ(e[0], read_rational_function("-2*b1^2/(1+b1)*w", names));
  EXPECT_EQ(e[1], read_rational_function("(1+b2+4*(b1+b1*b2-1)*w)/(2*(1+b2))", names));
  EXPECT_EQ(e[2], read_rational_function("(1+1/b1+4*(1/b2+1/b2/b1-1)*w)/(2*(1+1/b1))", names));
  EXPECT_EQ(e[3], read_rational_function("-2/b2^2/(1+1/b2)*w", names));
}

// Karciauskas & Peters 2013, eq. (19); beta_- = b1, beta = b2, beta_+ = b3.
TEST(InsertionRule, PrintedFormula19) {
  const VariableNames names{"w", "b1", "b2", "b3", "b4"};
  const auto e = catalogue_rule("cr2").symbolic_stencil();
  ASSERT_EQ(e.size(), 6u);
  const RationalFunction e1 = read_rational_function("4*b1^2*b2^2/((1+b1)*(1+b2))*w", names);
  const RationalFunction e2 = read_rational_function("-b2^2*(1+b3+32*(b1+b3+b1*b3)*w)/(8*(1+b2)*(1+b3))", names);
  EXPECT_EQ(e[0], e1);
  EXPECT_EQ(e[1], e2);
  EXPECT_EQ(e[2], read_rational_function("(3+4*b2+4*b3+5*b2*b3+32*w*(b2*b3-1))/(8*(1+b2)*(1+b3))", names) - e1 - e2);
}

// Karciauskas & Peters 2013, section 4.1: the same rule as a combination of interpolants.
TEST(InsertionRule, Cr1IsAnAverageOfQuadraticsAndTheChord) {
  const InsertionRule other =
      make_rule(4, {{"omega", "16*w"}}, "omega*(at(f(2,0),1/2)+at(f(2,1),1/2))/2 + (1-omega)*at(f(1,0),1/2)", {"w"});
  EXPECT_EQ(other.symbolic_stencil(), catalogue_rule("cr1").symbolic_stencil());
}

// Section 4: the mask of equal knots, computed and never looked up.
TEST(InsertionRule, EqualKnotsGiveTheUniformSchemes) {
  const std::pair<const char*, const char*> pairs[] = {
      {"cr1", "four-point"},     {"a1-3-1", "four-point"}, {"cr2", "six-point"},
      {"cu2-4", "six-point"},    {"a2-5-3", "six-point"},  {"eight-point-nonuniform", "eight-point"},
      {"a3-5-3-3", "six-point"}, {"a3-5", "six-point"},    {"ten-point-nonuniform", "ten-point"}};
  for (const auto& [name, uniform] : pairs) {
    EXPECT_EQ(uniform_mask(catalogue_rule(name)).symbol, catalogue_scheme(uniform).mask.symbol) << name;
    EXPECT_EQ(catalogue_scheme(name).mask.symbol, catalogue_scheme(uniform).mask.symbol) << name;
  }
  const std::vector<Rational> weissman{Rational(1) / 96};
  const LaurentPolynomial expected = at(catalogue_scheme("six-point").mask, weissman).symbol;
  for (const char* name : {"repeated-cr1", "repeated-a1-3-1"}) {
    EXPECT_EQ(uniform_mask(catalogue_rule(name)).symbol.rational_coefficients(), expected.rational_coefficients())
        << name;
  }
}

// ---- invariants

TEST(InsertionRule, RowsSumToOneForAllRatios) {
  for (const std::string& name : up_to_eight_points) {
    const auto e = catalogue_rule(name).symbolic_stencil();
    RationalFunction sum(e[0].variables());
    for (const RationalFunction& c : e) sum += c;
    EXPECT_EQ(sum, RationalFunction::constant(e[0].variables(), 1)) << name;
  }
}

// The replacement after eq. (12): beta_{i-n+2+s} -> 1/beta_{i+n-1-s} swaps e_j and e_{2n+1-j}.
TEST(InsertionRule, MirroredRatiosMirrorTheStencil) {
  for (const std::string& name : up_to_eight_points) {
    const InsertionRule rule = catalogue_rule(name);
    const int count = rule.points() - 2, variables = rule.parameters() + count;
    std::vector<RationalFunction> mirrored;
    for (int k = 0; k < count; ++k) {
      mirrored.push_back(RationalFunction::constant(variables, 1) /
                         RationalFunction::variable(variables, rule.parameters() + count - 1 - k));
    }
    auto e = rule.stencil(KnotRatios(mirrored).knots(variables));
    std::reverse(e.begin(), e.end());
    EXPECT_EQ(e, rule.symbolic_stencil()) << name;
  }
}

TEST(InsertionRule, MirroredKnotsMirrorTheStencil) {
  Generator random(4);
  for (const std::string& name : all) {
    const InsertionRule rule = catalogue_rule(name);
    const auto knots = random_knots(random, rule.points());
    const auto parameters = random_parameters(random, rule);
    std::vector<Rational> mirrored;
    for (auto t = knots.rbegin(); t != knots.rend(); ++t) mirrored.push_back(3 - 2 * *t);
    auto e = rule.stencil(mirrored, parameters);
    std::reverse(e.begin(), e.end());
    EXPECT_EQ(e, rule.stencil(knots, parameters)) << name;
  }
}

TEST(InsertionRule, OnlyTheRatiosOfTheKnotsMatter) {
  for (const std::string& name : up_to_eight_points) {
    const InsertionRule rule = catalogue_rule(name);
    const int variables = rule.parameters() + rule.points() - 2;
    auto knots = KnotRatios::independent(rule.points(), variables, rule.parameters()).knots(variables);
    for (RationalFunction& t : knots)
      t = t * RationalFunction::constant(variables, Rational(3) / 7) + RationalFunction::constant(variables, -5);
    EXPECT_EQ(rule.stencil(knots), rule.symbolic_stencil()) << name;
  }
}

TEST(InsertionRule, AllFieldsAgree) {
  Generator random(5);
  for (const std::string& name : all) {
    const InsertionRule rule = catalogue_rule(name);
    const auto symbolic = rule.symbolic_stencil();
    for (int round = 0; round < 5; ++round) {
      const auto knots = random_knots(random, rule.points());
      const auto parameters = random_parameters(random, rule);
      const auto exact = rule.stencil(knots, parameters);
      std::vector<Rational> point = parameters;
      for (std::size_t k = 1; k + 1 < knots.size(); ++k) {
        point.push_back((knots[k + 1] - knots[k]) / (knots[k] - knots[k - 1]));
      }
      for (std::size_t j = 0; j < exact.size(); ++j) EXPECT_EQ(symbolic[j](point), exact[j]) << name;
      std::vector<double> approx_knots, approx_parameters;
      for (const Rational& t : knots) approx_knots.push_back(approx_double(t));
      for (const Rational& w : parameters) approx_parameters.push_back(approx_double(w));
      const auto approx = rule.approx_stencil(approx_knots, approx_parameters);
      double scale = 1;
      for (const Rational& c : exact) scale = std::max(scale, std::abs(approx_double(c)));
      for (std::size_t j = 0; j < exact.size(); ++j)
        EXPECT_NEAR(approx[j], approx_double(exact[j]), 1e-8 * scale) << name;
    }
  }
}

TEST(InsertionRule, ReproducesPolynomialsUpToItsDegreeAndNoFurther) {
  const struct {
    const char* name;
    std::vector<Rational> parameters;
    int degree;
  } cases[] = {{"cr1", {Rational(1) / 10}, 1},
               {"cr1", {Rational(1) / 16}, 2},
               {"a1-3-1", {Rational(1) / 10}, 1},
               {"a1-3-1", {Rational(1) / 16}, 3},
               {"repeated-cr1", {}, 2},
               {"repeated-a1-3-1", {}, 3},
               {"cr2", {Rational(1) / 50}, 2},
               {"cu2-4", {Rational(1) / 50}, 3},
               {"a2-5-3", {Rational(1) / 50}, 3},
               {"a2-5-3", {Rational(3) / 256}, 5},
               {"a3-5-3-3", {Rational(1) / 50}, 3},
               {"a3-5-3-3", {Rational(3) / 256}, 5},
               {"a3-5", {Rational(1) / 50}, 3},
               {"a3-5", {Rational(3) / 256}, 5},
               {"eight-point-nonuniform", {Rational(1) / 500}, 5},
               {"eight-point-nonuniform", {Rational(5) / 2048}, 7},
               {"ten-point-nonuniform", {Rational(1) / 1000}, 7},
               {"ten-point-nonuniform", {Rational(35) / 65536}, 7}};
  Generator random(6);
  for (const auto& c : cases) {
    const InsertionRule rule = catalogue_rule(c.name);
    const auto knots = random_knots(random, rule.points());
    const auto e = rule.stencil(knots, c.parameters);
    const std::size_t i = std::size_t(rule.points() / 2 - 1);
    const Rational middle = (knots[i] + knots[i + 1]) / 2;
    for (int d = 0; d <= c.degree; ++d)
      EXPECT_EQ(combination(e, powers(knots, d)), power(middle, d)) << c.name << " degree " << d;
    EXPECT_NE(combination(e, powers(knots, c.degree + 1)), power(middle, c.degree + 1)) << c.name;
  }
}

// ---- the repeated rule

TEST(InsertionRule, RepeatedCubicIsTheCompositionByHand) {
  const InsertionRule rule = catalogue_rule("repeated-a1-3-1");
  const auto cubic = [](const std::vector<Rational>& t, const std::vector<Rational>& p) {
    const Rational x = (t[1] + t[2]) / 2;
    Rational sum = 0;
    for (std::size_t s = 0; s < 4; ++s) {
      Rational weight = p[s];
      for (std::size_t r = 0; r < 4; ++r) {
        if (r != s) weight *= (x - t[r]) / (t[s] - t[r]);
      }
      sum += weight;
    }
    return sum;
  };
  Generator random(7);
  for (int round = 0; round < 10; ++round) {
    const auto t = random_knots(random, 6), p = random.point(6);
    const Rational left = cubic({t[0], t[1], t[2], t[3]}, {p[0], p[1], p[2], p[3]});
    const Rational right = cubic({t[2], t[3], t[4], t[5]}, {p[2], p[3], p[4], p[5]});
    const Rational twice = cubic({(t[1] + t[2]) / 2, t[2], t[3], (t[3] + t[4]) / 2}, {left, p[2], p[3], right});
    EXPECT_EQ(combination(rule.stencil(t, {}), p), twice);
  }
}

// With the printed formula (17) at w = 1/16, the second time at the ratios 2 beta_i and beta_{i+1} / 2.
TEST(InsertionRule, RepeatedCatmullRomIsTheCompositionByHand) {
  const InsertionRule rule = catalogue_rule("repeated-cr1");
  const auto four_point = [](const Rational& b1, const Rational& b2, const std::vector<Rational>& p) {
    const Rational w = Rational(1) / 16, c1 = 1 / b2, c2 = 1 / b1;
    const Rational e1 = -2 * b1 * b1 / (1 + b1) * w, e4 = -2 * c1 * c1 / (1 + c1) * w;
    const Rational e2 = (1 + b2 + 4 * (b1 + b1 * b2 - 1) * w) / (2 * (1 + b2));
    const Rational e3 = (1 + c2 + 4 * (c1 + c1 * c2 - 1) * w) / (2 * (1 + c2));
    return Rational(e1 * p[0] + e2 * p[1] + e3 * p[2] + e4 * p[3]);
  };
  Generator random(8);
  for (int round = 0; round < 10; ++round) {
    const auto t = random_knots(random, 6), p = random.point(6);
    std::vector<Rational> b;  // b[0] = beta_{i-1}, ..
    for (std::size_t k = 1; k < 5; ++k) b.push_back((t[k + 1] - t[k]) / (t[k] - t[k - 1]));
    const Rational left = four_point(b[0], b[1], {p[0], p[1], p[2], p[3]});
    const Rational right = four_point(b[2], b[3], {p[2], p[3], p[4], p[5]});
    EXPECT_EQ(combination(rule.stencil(t, {}), p), four_point(2 * b[1], b[2] / 2, {left, p[2], p[3], right}));
  }
}

// ---- poles

TEST(InsertionRule, DenominatorsHaveCoefficientsOfOneSign) {
  for (const std::string& name : all) {
    for (const RationalFunction& e : catalogue_rule(name).symbolic_stencil()) {
      for (const auto& term : e.denominator().terms()) EXPECT_GT(term.coefficient, 0) << name;
    }
  }
}

TEST(InsertionRule, DivisorsAreSumsOfIntervals) {
  const auto divisors = catalogue_rule("cr1").divisors();
  const std::vector<InsertionRule::Divisor> expected{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}};
  EXPECT_EQ(divisors, expected);
  for (const char* name : {"repeated-cr1", "cu2-4", "a3-5", "ten-point-nonuniform"}) {
    const InsertionRule rule = catalogue_rule(name);
    ASSERT_FALSE(rule.divisors().empty());
    for (const auto& [from, to] : rule.divisors()) {
      EXPECT_LT(from, to);
      EXPECT_GE(from, 0);
      EXPECT_LE(to, rule.points() - 1);
    }
  }
  const auto halves = catalogue_rule("repeated-cr1").divisors();
  EXPECT_TRUE(std::any_of(halves.begin(), halves.end(), [](const auto& d) { return denominator(d.from) == 2; }));
}

TEST(InsertionRule, PolesInTheParametersAreListed) {
  EXPECT_TRUE(catalogue_rule("cr2").parameter_denominators().empty());
  const auto poles = make_rule(4, {{"c", "1/(1-2*w)"}}, "at(f(1,0),1/2) + c*(at(f(3,0),1/2) - at(f(1,0),1/2))", {"w"})
                         .parameter_denominators();
  ASSERT_EQ(poles.size(), 1u);
  EXPECT_EQ(to_string(poles[0], {"w"}), "w - 1/2");
  // The two terms cancel for equal knots; the pole stays.
  EXPECT_EQ(make_rule(4, {}, "at(f(1,0),1/2) + (at(f(2,0),1/2) + at(f(2,1),1/2) - 2*at(f(3,0),1/2))/w", {"w"})
                .parameter_denominators()
                .size(),
            1u);
}

// ---- rules by coefficients

TEST(InsertionRule, CoefficientsInTheRatiosGiveTheSameScheme) {
  InsertionRuleText text;
  text.points = 4;
  text.let = {{"c", {"2*w*b1", 0}}};
  for (const char* e : {"-c*b1/(1+b1)", "(1+b2+4*(b1+b1*b2-1)*w)/(2*(1+b2))",
                        "(1+1/b1+4*(1/b2+1/b2/b1-1)*w)/(2*(1+1/b1))", "-2/b2^2/(1+1/b2)*w"}) {
    text.coefficients.push_back({e, 0});
  }
  const InsertionRule rule(text, {"w"}), cr1 = catalogue_rule("cr1");
  EXPECT_EQ(rule.symbolic_stencil(), cr1.symbolic_stencil());
  EXPECT_EQ(rule.uniform_stencil(), cr1.uniform_stencil());
  const auto knots = KnotRatios::isolated(4, 1, RationalFunction::variable(2, 1)).knots(2);
  EXPECT_EQ(rule.stencil(knots), cr1.stencil(knots));
  Generator random(9);
  const auto rational_knots = random_knots(random, 4);
  const std::vector<Rational> w{Rational(1) / 7};
  EXPECT_EQ(rule.stencil(rational_knots, w), cr1.stencil(rational_knots, w));
}

// ---- wrong knots

TEST(InsertionRule, KnotsMustIncreaseStrictly) {
  const InsertionRule rule = catalogue_rule("repeated-cr1");
  const auto fails = [&](std::vector<double> knots) { EXPECT_THROW(rule.approx_stencil(knots, {}), DomainError); };
  fails({0, 1, 2, 2, 3, 4});
  fails({0, 1, 2, 1, 3, 4});
  fails({0, 1, 2, std::nan(""), 3, 4});
  fails({0, 1, 2, 3, 4, INFINITY});
  fails({0, 1, 2, 3, 4});
  const std::vector<Rational> repeated{0, 1, 1, 2, 3, 4};
  EXPECT_THROW(rule.stencil(repeated, {}), DomainError);
  EXPECT_THROW(catalogue_rule("cr1").stencil(KnotRatios::uniform(4, 0).knots(0)), DomainError);
}

// E_k of eq. (14): the isolated knot is number 2n-1-k of t_{i-n+1} .. t_{i+n}, counted from 0.
TEST(KnotRatios, AnIsolatedRatioChangesTheSpacingAtItsKnot) {
  const auto knots = KnotRatios::isolated(6, 1, RationalFunction::variable(1, 0)).knots(1);
  const RationalFunction gamma = RationalFunction::variable(1, 0);
  ASSERT_EQ(knots.size(), 6u);
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    EXPECT_EQ(knots[k + 1] - knots[k], k < 2 ? RationalFunction::constant(1, 1) : gamma) << k;
  }
  EXPECT_THROW(KnotRatios::isolated(6, 4, gamma), DomainError);
  EXPECT_THROW(KnotRatios::uniform(5, 0), DomainError);
}

}  // namespace
}  // namespace limes
