#include "reports/proof/proof_report.hpp"

#include "proofs/prove.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

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
  EXPECT_THAT(text, HasSubstr("q_{2i+1}&=-w\\,p_{i-1}+(w+\\tfrac{1}{2})\\,p_{i}"));
  EXPECT_THAT(text, HasSubstr("a(z)&=2^{-1}(1+z)^{2}\\,b(z),"));
  EXPECT_THAT(text, HasSubstr("For $w=1/16$ the scheme is $C^{1}$."));
  EXPECT_THAT(text, HasSubstr("=3/4=0.75<1")) << "the norm for l = 2";
  EXPECT_THAT(text, HasSubstr("For no $w\\in[0,1/4]$ the scheme is $C^{2}$."));
  EXPECT_THAT(text, HasSubstr("It is false that for every $w\\in[0.001,0.2]$"));
  EXPECT_THAT(text, HasSubstr("\\begin{erratum}\n$C^{1}$ ends at $w^{*}=0.19272$."));
  EXPECT_THAT(text, HasSubstr("exactly $C^{1}$ for $w=1/16$"));
  EXPECT_THAT(text, HasSubstr("Of $3$ claims about $1$ scheme, $2$ are certified, $1$ refuted, and $0$ undecided."));
}

TEST(ProofReport, ClaimsInOrderAndErrataInFront) {
  const std::string text = latex_of(four_point);
  EXPECT_LT(text.find("It is false that for every $w"), text.find("For no $w\\in[0,1/4]$")) << "all about C1 before what is about C2";
  EXPECT_THAT(text, HasSubstr("\\label{errata}"));
  EXPECT_THAT(text, HasSubstr("$C^{1}$, $w\\in[0.001,0.2]$ & $C^{1}$ ends at"));
  EXPECT_THAT(text, testing::Not(HasSubstr("\\label{undecided}")));
  EXPECT_THAT(text, testing::Not(HasSubstr("\\part{"))) << "one kind of scheme";
}

constexpr const char* catmull_rom = R"toml(name = "cr"
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
)toml";

TEST(ProofReport, ManySchemesOfSeveralKindsAreInParts) {
  std::vector<ReportedScheme> schemes;
  const auto add = [&](const char* text, const std::string& name) {
    schemes.push_back({read_scheme(text, name + ".toml"), {}});
    schemes.back().scheme.name = name;
  };
  add(catmull_rom, "first");
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) add(four_point, name);
  const std::string text = to_latex(proof_report(schemes, {.figures = false, .polygons = {}, .nets = {}}), {});
  const std::size_t uniform = text.find("\\part{Uniform schemes for curves}"), nonuniform = text.find("\\part{Non-uniform schemes for curves}");
  ASSERT_NE(uniform, std::string::npos);
  ASSERT_NE(nonuniform, std::string::npos);
  EXPECT_LT(uniform, text.find("\\label{scheme-a}"));
  EXPECT_LT(text.find("\\label{scheme-f}"), nonuniform);
  EXPECT_LT(nonuniform, text.find("\\label{scheme-first}"));
  schemes.resize(3);
  EXPECT_THAT(to_latex(proof_report(schemes, {.figures = false, .polygons = {}, .nets = {}}), {}), testing::Not(HasSubstr("\\part{"))) << "few schemes need no parts";
}

TEST(ProofReport, ComparesSchemesWithTheSameUniformRule) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "limes-comparison";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "beetle.csv") << "0,0\n4,0\n5,2\n4.5,2.5\n1,3\n0,2\n";
  std::vector<ReportedScheme> schemes{decided(four_point), decided(catmull_rom)};
  const Document document = proof_report(schemes, {.polygons = folder, .nets = {}});
  const Figure* comparison = nullptr;
  for (const Figure* figure : figures(document)) {
    if (figure->name == "comparison-mine") comparison = figure;
  }
  ASSERT_NE(comparison, nullptr);
  ASSERT_EQ(comparison->panels.size(), 2u);
  const Plot &left = comparison->panels[0].plot, &right = comparison->panels[1].plot;
  EXPECT_EQ(left.title, "mine");
  EXPECT_EQ(right.title, "cr");
  ASSERT_TRUE(left.x.lower && left.y.upper);
  EXPECT_EQ(left.x.lower, right.x.lower);
  EXPECT_EQ(left.y.upper, right.y.upper);
  EXPECT_NE(comparison->panels[0].data, comparison->panels[1].data) << "the edges have different lengths";
  schemes.pop_back();
  for (const Figure* figure : figures(proof_report(schemes, {.polygons = folder, .nets = {}}))) EXPECT_THAT(figure->name, testing::Not(testing::StartsWith("comparison")));
  std::filesystem::remove_all(folder);
}

TEST(ProofReport, EveryReferenceHasItsLabel) {
  const std::string text = latex_of(four_point);
  for (std::size_t at = 0; (at = text.find("\\hyperref[", at)) != std::string::npos; ++at) {
    const std::string label = text.substr(at + 10, text.find(']', at) - at - 10);
    EXPECT_THAT(text, HasSubstr("\\label{" + label + "}"));
  }
}

TEST(ProofReport, NonuniformSchemeWithItsCharacteristicPolynomial) {
  const std::string text = latex_of(catmull_rom);
  EXPECT_THAT(text, HasSubstr("is of size $7\\times7$"));
  EXPECT_THAT(text, HasSubstr("(\\lambda-1)(\\lambda-\\tfrac1{2})"));
  EXPECT_THAT(text, HasSubstr("For $w=1/16$ the scheme is $C^{1}$, for every knot sequence."));
  EXPECT_THAT(text, HasSubstr("For $w=1/4$ the scheme is not $C^{1}$ over some knot sequence."));
}

TEST(ProofReport, RulesAreFormulas) {
  const InsertionRuleText text{.points = 6, .let = {{"cr1", {"hermite(1, f(2,0), f(2,1))", 0}}, {"omega", {"576*w-2", 0}}},
                               .new_point = {"omega*at(degree(4, cr1),1/2) - (1-omega)/2*dot([1/12,5/6,0,5/6,1/12], join(2, cr1))", 0}, .coefficients = {}};
  Document document{.title = "", .subtitle = {}, .blocks = report_impl::rule_text(text)};
  const std::string latex = to_latex(document, {});
  EXPECT_THAT(latex, HasSubstr("\\mathit{cr}_{1}&=\\mathrm{hermite}_{1}(f^{2}_{i},\\,f^{2}_{i+1}),"));
  EXPECT_THAT(latex, HasSubstr("\\omega&=576\\,w-2,"));
  EXPECT_THAT(latex, HasSubstr("\\omega\\,\\mathrm{degree}_{4}(\\mathit{cr}_{1})(\\tfrac{1}{2})-\\tfrac{1-\\omega}{2}\\,(\\tfrac{1}{12},"));
  EXPECT_THAT(latex, HasSubstr("made $C^r$ at the knots"));
  EXPECT_THAT(latex, testing::Not(HasSubstr("halved intervals"))) << "only the words that the rule uses are explained";

  const InsertionRuleText plain{.points = 6, .let = {}, .new_point = {"dot([1/12,0,5/12,5/12,0,1/12], f(5,0))", 0}, .coefficients = {}};
  document.blocks = report_impl::rule_text(plain);
  EXPECT_THAT(to_latex(document, {}), HasSubstr(")\\cdot f^{5}_{i}")) << "a control word ends before a letter";
}

TEST(ProofReport, ExponentsWithTheirProofs) {
  ReportedScheme reported = decided(four_point);
  std::vector<Claim> claims;
  for (const DecidedClaim& one : reported.claims) claims.push_back(one.claim);
  const auto points = exponent_points(reported.scheme, claims);
  ASSERT_EQ(points, (std::vector<std::vector<Rational>>{{Rational(1) / 16}}));
  reported.exponents.push_back(*decide_exponent(reported.scheme, points.front()));
  const std::string text = to_latex(proof_report({reported}, {}), {});
  EXPECT_THAT(text, HasSubstr("For $w=1/16$ the H\u00f6lder exponent is exactly $2$."));
  EXPECT_THAT(text, HasSubstr("\\varrho=\\rho("));
  EXPECT_THAT(text, HasSubstr("\\label{theorem-U3}"));
}

TEST(ProofReport, MapOfTheClaims) {
  const Document document = proof_report({decided(four_point)}, {});
  const Figure* map = nullptr;
  for (const Figure* figure : figures(document)) {
    if (figure->name == "mine-map") map = figure;
  }
  ASSERT_NE(map, nullptr);
  EXPECT_THAT(map->panels.front().data, HasSubstr("1,certified,1/16,1/16,closed,closed"));
  EXPECT_THAT(map->panels.front().data, HasSubstr("2,refuted,0,1/4,closed,closed"));
  EXPECT_THAT(map->panels.front().data, HasSubstr("1,refuted,1/5,1/5,closed,closed"));
}

TEST(ProofReport, NonstationarySchemes) {
  const std::string text = latex_of(R"toml(name = "sequence"
kind = "nonstationary"
[nonstationary]
types = { trigonometric = ["0", "2"] }
first_index = -1
mask = ["1/(2*(1+mu))", "(1+2*mu)/(2*(1+mu))", "(1+2*mu)/(2*(1+mu))", "1/(2*(1+mu))"]
[[claims]]
claim = "C1"
)toml");
  EXPECT_THAT(text, HasSubstr("\\mu_k=\\cos(\\theta\\,2^{-(k+1)})"));
  EXPECT_THAT(text, HasSubstr("\\limesplot{sequence-angles-1}"));
}

TEST(ProofReport, MaskOfAWeightFunction) {
  ReportedScheme reported = decided(R"toml(name = "degree-6"
kind = "uniform"
source = "MoltajiRunionsSamavati2016"
[uniform]
mask = ["0.218601", "0.487201", "0.593167", "0.487201", "0.218601"]
[weight]
function = "polynomial(64-48*u^2+12*u^4-u^6, domain=[-2,2])"
samples = 501
[[claims]]
claim = "only zero limits"
[[claims]]
claim = "not C0"
[[claims]]
claim = "projective C0"
[[claims]]
claim = "not projective C1"
)toml");
  reported.weight = study_weight(reported.scheme, {});
  reported.filters = decide_filters(reported.scheme, 4, {});
  ASSERT_TRUE(reported.filters);
  EXPECT_GE(reported.weight->error, reported.weight->derived.least_error);
  const Document document = proof_report({reported}, {});
  const std::string text = to_latex(document, {});
  EXPECT_THAT(text, HasSubstr("differ from $1$ by $30369/1000000$ and $-12799/500000$, exactly"));
  EXPECT_THAT(text, HasSubstr("What smoothness costs"));
  EXPECT_THAT(text, HasSubstr("not $C^{3}$"));
  EXPECT_THAT(text, HasSubstr("has a real eigenvalue of at least $1$"));
  EXPECT_THAT(text, HasSubstr("multiply the oscillation of the points of a window by at most $q="));
  EXPECT_THAT(text, HasSubstr("|\\lambda_2/\\lambda_1|^{1/"));
  EXPECT_THAT(text, HasSubstr("Theorem B1"));
  EXPECT_THAT(text, HasSubstr("These filters are biorthogonal"));
  std::vector<std::string> names;
  for (const Figure* figure : figures(document)) names.push_back(figure->name);
  EXPECT_THAT(names, testing::IsSupersetOf({"degree-6-weight", "degree-6-cost", "degree-6-filters"}));
  for (const Figure* figure : figures(document)) {
    for (const Figure::Panel& panel : figure->panels) EXPECT_FALSE(panel.data.empty()) << figure->name;
  }
  EXPECT_EQ(exponent_certificates(reported.scheme, *reported.weight).size(), 2u);
  const std::string fragment = to_latex(proof_report({reported}, {.title = {}, .front_matter = false, .figures = false, .polygons = {}, .nets = {}}), {}, {.fragment = true, .date = {}});
  EXPECT_THAT(fragment, testing::Not(HasSubstr("includegraphics")));
}

TEST(ProofReport, UndecidedSaysWhy) {
  ReportedScheme reported = decided(four_point);
  reported.claims.front().verdict = Verdict{};
  reported.claims.front().verdict.reason = "the budget ended";
  const std::string text = to_latex(proof_report({reported}, {}), {});
  EXPECT_THAT(text, HasSubstr("\\emph{Undecided:} For $w=1/16$ the scheme is $C^{1}$."));
  EXPECT_THAT(text, HasSubstr("the budget ended"));
  EXPECT_THAT(text, HasSubstr("The joint spectral radius of the sections of $b$ at $w=1/16$ lies in $[0."));
  EXPECT_THAT(text, HasSubstr("level $l$ & $1$ & $2$"));
}

TEST(ProofReport, SameInputSameBytes) { EXPECT_EQ(latex_of(four_point), latex_of(four_point)); }

TEST(Formulas, GuaranteedDigits) {
  EXPECT_EQ(digits_latex(Interval::point(Rational(3) / 4)), "3/4");
  EXPECT_EQ(digits_latex({Rational(12341) / 100000, Rational(12342) / 100000}), "0.1234");
  EXPECT_EQ(inline_latex(Rational(1) / 3), "1/3");
  EXPECT_EQ(scientific_latex("-8.3e-8"), "-8.3\\cdot10^{-8}");
  EXPECT_EQ(scientific_latex("0.25"), "0.25");
}

TEST(Formulas, ParameterValuesAreExactAndShort) {
  const auto value = [](const Rational& x) { return point_latex({"w"}, std::vector{x}); };
  EXPECT_EQ(value(Rational(1) / 16), "w=1/16");
  EXPECT_EQ(value(Rational(1) / 128), "w=1/128") << "longer as a decimal";
  EXPECT_EQ(value(Rational(1) / 65), "w=1/65") << "no decimal";
  EXPECT_EQ(value(Rational(141) / 10000), "w=0.0141");
  EXPECT_EQ(value(Rational(-1) / 1000), "w=-0.001");
}

TEST(Formulas, SumsHaveSigns) {
  const VariableNames names{"w"};
  const RationalFunction w = RationalFunction::variable(1, 0), one = RationalFunction::constant(1, 1);
  EXPECT_EQ(joined_sum(power_sum_terms({{0, -w}, {1, one}, {2, -one}, {3, w + one}, {4, w - w}}, "z", names)), "-w+z-z^{2}+(w+1)\\,z^{3}");
  EXPECT_EQ(joined_sum(power_sum_terms({}, "z", names)), "0");
}

}  // namespace
}  // namespace limes
