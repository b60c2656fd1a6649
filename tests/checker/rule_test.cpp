#include "proofs/checker/rule.hpp"

#include <gtest/gtest.h>

using namespace limes::checker;

namespace {

std::vector<Stencil> stencils(const Rule& rule) {
  Budget budget;
  std::vector<Stencil> result;
  for (int k = 0; k < rule.points; ++k) result.push_back(isolated_stencil(rule, k, budget));
  return result;
}

std::vector<Stencil> stencils(const std::string& text, int points, const Definitions& definitions = {}) {
  Budget budget;
  return stencils(read_rule(definitions, text, {"w"}, points, budget));
}

/// The greatest k <= 9 such that all stencils are exact for the powers 0..k of the knots, identically; -1: none.
int reproduced_degree(const std::vector<Stencil>& rows) {
  Budget budget;
  const auto points = static_cast<int>(rows.size());
  const auto knot = [&](int j) { return multiply(constant(j), j > 0 ? variable(1) : constant(1), budget); };
  const auto power = [&](const Polynomial& p, int n) {
    Polynomial result = constant(1);
    for (int k = 0; k < n; ++k) result = multiply(result, p, budget);
    return result;
  };
  for (int k = 0; k <= 9; ++k) {
    for (int row = 0; row < points; ++row) {
      const Stencil& stencil = rows[static_cast<std::size_t>(row)];
      Polynomial sum;
      for (int j = 0; j < points; ++j)
        sum =
            add(sum,
                multiply(stencil.numerators[static_cast<std::size_t>(j)], power(knot(row + j + 1 - points), k), budget),
                budget);
      const Polynomial middle =
          multiply(constant(mpq_class(1, 2)), add(knot(row - points / 2), knot(row - points / 2 + 1), budget), budget);
      if (sum != multiply(stencil.denominator, power(middle, k), budget)) return k - 1;
    }
  }
  return 9;
}

void expect_equal(const std::vector<Stencil>& x, const std::vector<Stencil>& y) {
  Budget budget;
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t j = 0; j < x[k].numerators.size(); ++j)
      EXPECT_EQ(multiply(x[k].numerators[j], y[k].denominator, budget),
                multiply(y[k].numerators[j], x[k].denominator, budget))
          << "E_" << k << ", weight " << j + 1;
}

const Definitions catmull_rom{{"cr1", "hermite(1, f(2,0), f(2,1))"}};

}  // namespace

// An r-jet or spline construction that is exact on polynomials of a degree has as many conditions as weights: a wrong
// weight in eqs. (3)-(5) or (7) would lower one of these numbers.
TEST(Rule, ReproducesPolynomials) {
  const auto degree_of = [](const std::string& text, int points) {
    return reproduced_degree(stencils(text, points, catmull_rom));
  };
  for (int k = 1; k <= 9; k += 2) EXPECT_EQ(degree_of("at(f(" + std::to_string(k) + ",0),1/2)", k + 1), k);
  EXPECT_EQ(degree_of("at(f(2,0),1/2)", 4), 2);
  EXPECT_EQ(degree_of("at(f(3,-1),1/2)", 6), 3);
  EXPECT_EQ(degree_of("at(f(0,0),1/2)", 2), 0);
  EXPECT_EQ(degree_of("at(cr1,1/2)", 4), 2);
  EXPECT_EQ(degree_of("at(hermite(2, f(5,0), f(5,0)),1/2)", 6), 5);
  EXPECT_EQ(degree_of("at(hermite(3, f(5,0), f(4,1)),1/2)", 6), 4);
  EXPECT_EQ(degree_of("at(hermite(2, f(1,0), f(1,0)),1/2)", 4), 1);
  EXPECT_EQ(degree_of("at(degree(9, f(5,0)),1/2)", 6), 5);
  EXPECT_EQ(degree_of("at(tension(1, cr1),1/2)", 4), 2);
  EXPECT_EQ(degree_of("at(tension(16*w, cr1),1/2)", 4), 1);
  EXPECT_EQ(degree_of("at(tension(w/(w+1), cr1),1/2)", 4), 1);
  EXPECT_EQ(degree_of("at(join(1, degree(2, f(1,0))),1/2)", 4), 1);
  EXPECT_EQ(degree_of("at(join(1, f(3,0)),1/2)", 6), 3);
  EXPECT_EQ(degree_of("at(join(2, degree(4, f(3,0))),1/2)", 6), 3);
  EXPECT_EQ(degree_of("at(join(2, degree(4, f(3,0))),1/3) + at(join(2, degree(4, f(3,0))),2/3) - at(f(3,0),1/2)", 6),
            1);
  EXPECT_EQ(degree_of("at(join(3, degree(6, f(3,0))),1/2)", 6), 3);
  EXPECT_EQ(degree_of("at(join(3, degree(6, join(2, degree(4, cr1)))),1/2)", 8), 2);
  EXPECT_EQ(degree_of("at(split(1, f(3,0)),1/2)", 4), 3);  // only in the middle: section 2.2
  EXPECT_EQ(degree_of("at(split(2, f(3,0)),1/2)", 4), 3);
  EXPECT_EQ(degree_of("at(split(3, f(5,0)),1/2)", 6), 5);
  EXPECT_EQ(degree_of("at(split(2, degree(4, f(3,0)), 2),1/2)", 4), 3);
  EXPECT_EQ(degree_of("again(at(f(3,0),1/2))", 6), 3);
  EXPECT_EQ(degree_of("again(again(at(f(2,0),1/2)))", 8), 2);
  EXPECT_EQ(degree_of("2*at(f(3,0),1/2)", 4), -1);
  EXPECT_EQ(degree_of("-(-at(f(3,0),1/2)/2) + at(f(3,0),1/2)*(1/2)", 4), 3);
}

TEST(Rule, TwoPiecesShareTheMiddlePointOfEquation10) {
  for (const std::string s : {"degree(4, f(3,0))", "degree(4, cr1)", "join(2, degree(4, cr1))"})
    expect_equal(stencils("at(split(2, " + s + ", 2),1/2)", 6, catmull_rom),
                 stencils("dot([1/12,1/6,1/2,1/6,1/12], " + s + ")", 6, catmull_rom));
}

TEST(Rule, KarciauskasPeters2013Formula17) {
  Budget budget;
  const std::vector<std::string> printed{"-2*b1^2/(1+b1)*w", "(1+b2+4*(b1+b1*b2-1)*w)/(2*(1+b2))",
                                         "(1+1/b1+4*(1/b2+1/(b1*b2)-1)*w)/(2*(1+1/b1))", "-2*(1/b2)^2/(1+1/b2)*w"};
  expect_equal(stencils(read_coefficients(printed, {"w"}, budget)),
               stencils("at(tension(16*w, cr1),1/2)", 4, catmull_rom));
}

TEST(Rule, KarciauskasPeters2013Formula19) {
  Budget budget;
  const std::string e1 = "4*b1^2*b2^2/((1+b1)*(1+b2))*w", e6 = "4/(b3^2*b4^2)/((1+1/b4)*(1+1/b3))*w";
  const std::string e2 = "(-b2^2*(1+b3+32*(b1+b3+b1*b3)*w)/(8*(1+b2)*(1+b3)))";
  const std::string e5 = "(-1/b3^2*(1+1/b2+32*(1/b4+1/b2+1/(b2*b4))*w)/(8*(1+1/b3)*(1+1/b2)))";
  const std::string e3 = "(3+4*b2+4*b3+5*b2*b3+32*w*(b2*b3-1))/(8*(1+b2)*(1+b3)) - " + e1 + " - " + e2;
  const std::string e4 = "(3+4/b3+4/b2+5/(b2*b3)+32*w*(1/(b2*b3)-1))/(8*(1+1/b3)*(1+1/b2)) - " + e6 + " - " + e5;
  const Definitions definitions{{"cr1", "hermite(1, f(2,0), f(2,1))"}, {"cr2", "join(2, degree(4, cr1))"}};
  const std::string rule = "(576*w-2)*at(cr2,1/2) + (3-576*w)*dot([1/12,1/6,1/2,1/6,1/12], cr2)";
  expect_equal(stencils(read_coefficients({e1, e2, e3, e4, e5, e6}, {"w"}, budget)), stencils(rule, 6, definitions));
}

TEST(Rule, AgainLeavesOutTheMiddleKnot) {
  // E(2 b1, b2 / 2) on the refined points: for equal intervals, Weissman's scheme with w = 1/96.
  const Stencil uniform = stencils("again(at(f(3,0),1/2))", 6).front();
  const mpq_class w(1, 96);
  const std::vector<mpq_class> expected{w, -3 * w - mpq_class(1, 16), 2 * w + mpq_class(9, 16)};
  Budget budget;
  for (std::size_t j = 0; j < 6; ++j)
    EXPECT_EQ(uniform.numerators[j], multiply(constant(expected[std::min(j, 5 - j)]), uniform.denominator, budget));
}

TEST(Rule, EveryDivisorInTheParametersIsRemembered) {
  Budget budget;
  const auto count = [&](const Definitions& definitions, const std::string& rule) {
    return read_rule(definitions, rule, {"w"}, 4, budget).divisors.size();
  };
  EXPECT_EQ(count({}, "at(f(1,0),1/2)"), 0u);
  EXPECT_EQ(count({}, "at(f(1,0),1/2)/2"), 0u);
  EXPECT_EQ(count({}, "w/w*at(f(1,0),1/2)"), 1u);
  EXPECT_EQ(count({}, "at(f(1,0),1/2) + 0/(w-1)*at(f(3,0),1/2)"), 1u);
  EXPECT_EQ(count({{"unused", "1/(w-2)"}}, "at(f(1,0),1/2)"), 1u);
  EXPECT_EQ(count({{"c", "1/(w-2)"}, {"s", "tension(c, f(1,0))"}}, "dot([1/2, 1/w], s)"), 2u);
  const Stencil first =
      isolated_stencil(read_rule({{"unused", "1/(w-2)"}}, "at(f(1,0),1/2)", {"w"}, 2, budget), 0, budget);
  EXPECT_EQ(first.denominator, add(variable(0), constant(-2), budget));
}
