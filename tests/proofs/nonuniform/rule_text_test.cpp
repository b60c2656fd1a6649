// What a scheme file may write and what a certificate may say differ; no true verdict is lost between them.

#include "algebra/error.hpp"
#include "schemes/nonuniform/normalized_rule.hpp"
#include "tests/proofs/nonuniform/decide.hpp"

namespace limes {
namespace {

using test::decide;
using test::own;
using test::own_coefficients;

constexpr const char* cubic = "16*w*at(f(3,0),1/2) + (1-16*w)*at(f(1,0),1/2)";

TEST(RuleText, NumbersOfEveryKind) {
  const char* const rules[] = {
      "16.0*w*at(f(3,0),0.5) + (1-1.6e1*w)*at(f(1,0),.5)",
      "+16*w*at(f(3,\t0),1/2)\n + (1-16*w)*at( f(1,0) ,\n+1/2)",
      "2^4*w*at(f(3,0),2^-1) + (1-16*w)*at(f(1,0),1/2)",
      "--16*w*at(f(3,0),1/2) - -(1-16*w)*at(f(1,0),1/2)",
      "at(16*w*f(3,0) - (16*w-1)*degree(3, f(1,0)), 1/2)",
      "16*w*(at(f(3,0),1/2) - at(f(1,0),1/2)) + at(f(1,0),1/2)/2*4/2",
  };
  for (const char* rule : rules) {
    EXPECT_EQ(decide(own(rule, 4), "C1", "[1/100, 3/25]").outcome, Outcome::certified) << rule;
    EXPECT_EQ(decide(own(rule, 4), "not C1", "[13/100, 7/50]").outcome, Outcome::certified) << rule;
    EXPECT_EQ(decide(own(rule, 4), "C1", "[1/100, 1/5]").outcome, Outcome::refuted) << rule;
  }
}

TEST(RuleText, DefinitionsOfNumbersSegmentsAndPoints) {
  const char* const let = "omega = \"1.6e1*v\"\nv = \"w\"\nF = \"f(3, zero)\"\nzero = \"0\"\nE = \"at(F,half)\"\nhalf = \"0.5\"";
  EXPECT_EQ(decide(own("omega*E + (1-omega)*at(f(1,0),half)", 4, let), "C1", "[1/100, 3/25]").outcome, Outcome::certified);
}

TEST(RuleText, DivisorsThatCancel) {
  // 1/12 lies in the region; in lowest terms there is no divisor.
  const std::string rule = std::string("(w-1/12)/(w-1/12)*(") + cubic + ") + 0/(w-1/12)*at(f(1,0),1/2)";
  EXPECT_EQ(decide(own(rule, 4), "C1", "[1/100, 3/25]").outcome, Outcome::certified);
  EXPECT_EQ(decide(own(cubic, 4, "unused = \"1/(1-12*w)-1/(1-12*w)\""), "C1", "[1/100, 3/25]").outcome, Outcome::certified);
  // One that does not cancel, but only in the end: the weights of both points have the pole.
  const std::string pole = std::string(cubic) + " + 1/(w-1/12)*(at(f(1,0),1/2) - at(f(1,0),1/2))";
  const Verdict verdict = decide(own(pole, 4), "C1", "[1/100, 3/25]");
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_NE(verdict.reason.find("pole"), std::string::npos) << verdict.reason;
  EXPECT_EQ(decide(own(pole, 4), "C1", "[1/100, 1/13]").outcome, Outcome::certified);
}

TEST(RuleText, DivisorsWithoutZeroWhoseCoefficientsHaveNoSign) {
  // (w-1/12)^2 + 1/10000 has negative Bernstein coefficients on the whole region.
  const std::string rule = std::string(cubic) + " + 1/((w-1/12)^2+1/10000)*(at(f(1,0),1/2) - at(f(1,0),1/2))";
  EXPECT_EQ(decide(own(rule, 4), "C1", "[1/100, 3/25]").outcome, Outcome::certified);
  EXPECT_EQ(decide(own(rule, 4), "not C1", "[13/100, 7/50]").outcome, Outcome::certified);
  EXPECT_EQ(decide(own(rule, 4), "not C1", "[1/10, 7/50]").outcome, Outcome::undecided);
}

TEST(RuleText, Coefficients) {
  const char* const plain = R"x("-2*b1^2/(1+b1)*w", "(1+b2+4*(b1+b1*b2-1)*w)/(2*(1+b2))", )x"
                            R"x("(1+1/b1+4*(1/b2+1/b2/b1-1)*w)/(2*(1+1/b1))", "-2/b2^2/(1+1/b2)*w")x";
  EXPECT_EQ(decide(own_coefficients(plain, 4), "C1", "[1/100, 3/20]").outcome, Outcome::certified);
  const char* const defined = R"x("-2.0*b1^2/(1+b1)*w", "(1+b2+4*c*w)/q*(b1-b2)/(b1-b2)", )x"
                              R"x("(1+1/b1+4*(1/b2+1/b2/b1-1)*w)/(2*(1+1/b1))", "-2/b2^2/(1+1/b2)*w")x";
  const char* const let = "q = \"2*(1+b2)\"\nc = \"b1+b1*b2-1\"";
  EXPECT_EQ(decide(own_coefficients(defined, 4, let), "C1", "[1/100, 3/20]").outcome, Outcome::certified);
  EXPECT_EQ(decide(own_coefficients(defined, 4, let), "C2", "1/16").outcome, Outcome::refuted);
}

TEST(RuleText, MorePointsThanACertificateMayHave) {
  const Verdict verdict = decide(own("at(f(3,0),1/2)", 18), "C1", "1/16");
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_NE(verdict.reason.find("at most 16 points"), std::string::npos) << verdict.reason;
  EXPECT_EQ(decide(own("at(f(3,0),1/2)", 6), "C1", "1/16").outcome, Outcome::certified);
  std::string list;
  for (int k = 0; k < 16; ++k) list += k == 7 || k == 8 ? "\"1/2\"," : "\"0\",";
  EXPECT_EQ(decide(own_coefficients(list, 16), "C1", "1/16").outcome, Outcome::refuted);
  Scheme scheme = own_coefficients(list, 16);
  scheme.parameters.push_back({"v", Interval::point(1)});
  scheme.parameters.push_back({"u", Interval::point(1)});
  EXPECT_NE(decide(scheme, "C1").reason.find("at most 16 parameters and ratios"), std::string::npos);
}

TEST(RuleText, NamesThatTheVocabularyUses) {
  for (const char* name : {"gamma", "at", "f", "again"}) {
    InsertionRuleText text;
    text.new_point.text = "at(f(3,0),1/2)";
    EXPECT_THROW(InsertionRule(text, VariableNames{name}), InputError) << name;
  }
}

TEST(RuleText, DeeplyNestedRules) {
  std::string rule = "f(3,0)";
  for (int k = 0; k < 90; ++k) rule = "degree(3," + rule + ")";
  EXPECT_EQ(decide(own("at(" + rule + ",1/2)", 4), "C1", "1/16").outcome, Outcome::certified);
  rule = "at(f(3,0),1/2)";
  for (int k = 0; k < 30; ++k) rule = "2*(-(" + rule + ")/2)";
  EXPECT_EQ(decide(own(rule, 4), "C1", "1/16").outcome, Outcome::certified);
}

TEST(RuleText, NormalizedTextMeansTheSameRule) {
  const char* const rules[] = {
      "omega*at(cr2,1/2) + (1-omega)*dot([1/12,1/6,0.5,1/6,1/12], cr2)",
      "again(omega*at(f(3,0),0.5) - (omega-1)*at(split(2,f(3,0)),1/3))",
      "at(split(2,degree(4,f(3,0)),2) - 2*(split(2,degree(4,f(3,0)),2) - split(2,degree(4,f(3,0)),2))/omega, .25)",
      "at(tension(omega/(1+w), cr1),1/2) - (at(cr1,1/2) - at(cr1,1/2)) - -at(cr1,0) + -at(cr1,0)",
  };
  for (const char* rule : rules) {
    InsertionRuleText text;
    text.points = 6;
    text.let = {{"cr1", {"hermite(1, f(2,0), f(2,1))", 0}}, {"omega", {"576*w - 2", 0}}, {"cr2", {"join(2, degree(4, cr1))", 0}}};
    text.new_point = {rule, 0};
    const InsertionRule original(text, {"w"});
    const InsertionRule normalized(normalized_text(original), {"w"});
    std::vector<Rational> knots{0};
    for (int k = 1; k < text.points; ++k) knots.push_back(knots.back() + Rational(1 + k * k % 5) / (1 + k % 3));
    for (const Rational& w : {Rational(1) / 7, Rational(3) / 100}) {
      EXPECT_EQ(original.stencil(knots, std::vector{w}), normalized.stencil(knots, std::vector{w})) << rule;
    }
    EXPECT_EQ(normalized_text(normalized).new_point.text, normalized_text(original).new_point.text);
    EXPECT_EQ(normalized.text().points, text.points);
  }
}

}  // namespace
}  // namespace limes
