#include "reports/proof/proof_report.hpp"

#include "proofs/prove.hpp"
#include "reports/proof/formulas.hpp"

#include <gmock/gmock.h>

namespace limes {
namespace {

using testing::HasSubstr;

ReportedScheme decided(const std::string& text) {
  ReportedScheme reported;
  reported.scheme = read_scheme(text, "test.toml");
  for (const Claim& claim : reported.scheme.claims) {
    reported.claims.push_back({claim, prove(reported.scheme, claim), "certificate.json"});
  }
  return reported;
}

std::string latex_of(const std::string& text) { return to_latex(proof_report({decided(text)}, {}), {}); }

constexpr const char* four_point = R"(name = "mine"
title = "My scheme"
kind = "uniform"
source = "DynLevinGregory1987"
[parameters]
w = ["0", "1/4"]
[uniform]
mask = ["-w", "0", "1/2+w", "1", "1/2+w", "0", "-w"]
[[claims]]
claim = "C1"
region = { w = "1/16" }
[[claims]]
claim = "not C2"
[[claims]]
claim = "C1"
region = { w = ["1/1000", "1/5"] }
expect = "refuted"
erratum = "C1 ends at w* = 0.19272"
)";

TEST(ProofReport, DefinitionVerdictsAndProofs) {
  const std::string text = latex_of(four_point);
  EXPECT_THAT(text, HasSubstr("q_{2i+1}&=-w\\,p_{i-1}+\\left(w+\\frac{1}{2}\\right)p_{i}"));
  EXPECT_THAT(text, HasSubstr("a(z)&=(1+z)^{2}\\,2^{-1}\\,b(z),"));
  EXPECT_THAT(text, HasSubstr("For $w=1/16$ the scheme is $C^{1}$."));
  EXPECT_THAT(text, HasSubstr("=3/4=0.75<1")) << "the norm for l = 2";
  EXPECT_THAT(text, HasSubstr("For no $w\\in[0,1/4]$ the scheme is $C^{2}$."));
  EXPECT_THAT(text, HasSubstr("It is false that for every $w\\in[1/1000,1/5]$"));
  EXPECT_THAT(text, HasSubstr("\\begin{erratum}\n$C^{1}$ ends at w* = 0.19272."));
  EXPECT_THAT(text, HasSubstr("exactly $C^{1}$ for $w=1/16$"));
  EXPECT_THAT(text, HasSubstr("Of $3$ claims about $1$ scheme, $2$ are certified, $1$ refuted, and $0$ undecided."));
}

constexpr const char* surface = R"toml(name = "mine"
title = "Mine"
kind = "surface"
[surface]
curve = "b-spline-2"
[surface.rules]
"0,0" = "1/4*at(0,0) + 3/4*mean(0,0) + 1/2*harmonic(1,0,0)"
[[claims]]
claim = "spectral-condition"
valence = "[3, 8]"
[[claims]]
claim = "C1"
valence = "[3, inf)"
)toml";

/// A spectral condition is no smoothness, and C1 at extraordinary faces is no C1 of a curve scheme.
TEST(ProofReport, SurfacesSayWhereAndForWhichNets) {
  const std::string text = latex_of(surface);
  EXPECT_THAT(text, HasSubstr("The spectral condition holds at isolated extraordinary faces of the valences $n=3,\\dots,8$."));
  EXPECT_THAT(text, HasSubstr("Near isolated extraordinary faces of every valence $n\\ge3$ the limit surface of almost every control net is $C^{1}$."));
  EXPECT_THAT(text, HasSubstr("$3\\le n\\le8$"));
  EXPECT_THAT(text, HasSubstr("It alone does not prove $C^1$"));
  EXPECT_THAT(text, HasSubstr("have it enclosed, for all their points at once"));
  EXPECT_THAT(text, HasSubstr("Characteristic maps of the limit rules"));
  EXPECT_THAT(text, testing::Not(HasSubstr("The scheme is")));
}

TEST(ProofReport, EveryReferenceHasItsLabel) {
  const std::string text = latex_of(four_point) + latex_of(surface);
  for (std::size_t at = 0; (at = text.find("\\hyperref[", at)) != std::string::npos; ++at) {
    const std::string label = text.substr(at + 10, text.find(']', at) - at - 10);
    EXPECT_THAT(text, HasSubstr("\\label{" + label + "}"));
  }
}

TEST(ProofReport, NonuniformSchemeWithItsCharacteristicPolynomial) {
  const std::string text = latex_of(R"toml(name = "cr"
kind = "nonuniform"
[parameters]
w = ["0", "1/4"]
[nonuniform]
points = 4
[nonuniform.let]
cr1 = "hermite(1, f(2,0), f(2,1))"
[nonuniform.rule]
new = "at(tension(16*w, cr1), 1/2)"
[[claims]]
claim = "C1"
region = { w = "1/16" }
[[claims]]
claim = "not C1"
region = { w = "1/4" }
)toml");
  EXPECT_THAT(text, HasSubstr("is of size $7\\times7$"));
  EXPECT_THAT(text, HasSubstr("(\\lambda-1)(\\lambda-\\tfrac1{2})"));
  EXPECT_THAT(text, HasSubstr("For $w=1/16$ the scheme is $C^{1}$, for every knot sequence."));
  EXPECT_THAT(text, HasSubstr("For $w=1/4$ the scheme is not $C^{1}$ for all knot sequences."));
}

TEST(ProofReport, UndecidedSaysWhy) {
  ReportedScheme reported = decided(four_point);
  reported.claims.front().verdict = Verdict{};
  reported.claims.front().verdict.reason = "the budget ended";
  const std::string text = to_latex(proof_report({reported}, {}), {});
  EXPECT_THAT(text, HasSubstr("\\emph{Undecided:} For $w=1/16$ the scheme is $C^{1}$."));
  EXPECT_THAT(text, HasSubstr("the budget ended"));
}

TEST(ProofReport, SameInputSameBytes) { EXPECT_EQ(latex_of(four_point), latex_of(four_point)); }

TEST(Formulas, GuaranteedDigits) {
  EXPECT_EQ(digits_latex(Interval::point(Rational(3) / 4)), "3/4");
  EXPECT_EQ(digits_latex({Rational(12341) / 100000, Rational(12342) / 100000}), "0.1234");
  EXPECT_EQ(inline_latex(Rational(1) / 3), "1/3");
}

TEST(Formulas, SumsHaveSigns) {
  const VariableNames names{"w"};
  const RationalFunction w = RationalFunction::variable(1, 0), one = RationalFunction::constant(1, 1);
  EXPECT_EQ(joined_sum(power_sum_terms({{0, -w}, {1, one}, {2, -one}, {3, w + one}, {4, w - w}}, "z", names)), "-w+z-z^{2}+\\left(w+1\\right)z^{3}");
  EXPECT_EQ(joined_sum(power_sum_terms({}, "z", names)), "0");
}

}  // namespace
}  // namespace limes
