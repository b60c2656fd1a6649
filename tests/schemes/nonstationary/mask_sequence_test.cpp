#include "schemes/nonstationary/mask_sequence.hpp"

#include "algebra/error.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <array>

namespace limes {
namespace {

std::vector<ExponentialFunction> space(const std::string& text) { return read_exponential_functions(text); }
Scheme load(const char* name) {
  return Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name);
}

Scheme read(const std::string& table, const std::string& rest = "") {
  return read_scheme("name = \"s\"\nkind = \"nonstationary\"\n[nonstationary]\n" + table + "\n" + rest, "s.toml");
}

void expect_error(const std::string& text, const std::string& rest = "") {
  try {
    read(text, rest);
    FAIL() << text;
  } catch (const InputError& error) {
    EXPECT_GE(error.position().line, 3) << error.what();
  }
}

TEST(MaskSequence, ChebyshevPolynomials) {
  const MultivariatePolynomial x = MultivariatePolynomial::variable(1, 0);
  EXPECT_EQ(chebyshev_t(3), Rational(4) * x * x * x - Rational(3) * x);
  EXPECT_EQ(chebyshev_u(2), Rational(4) * x * x - MultivariatePolynomial::constant(1, 1));
  EXPECT_TRUE(chebyshev_u(-1).is_zero());
  EXPECT_EQ(chebyshev_u(0), MultivariatePolynomial::constant(1, 1));
}

// Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, section 2.1: the weights are those of the interpolant.
TEST(MaskSequence, UnifiedCurveIsTheInterpolantFromItsSpace) {
  const Mask published = load("unified-curve").sequence->mask;
  for (const char* text : {"{1, y, cos, sin}", "{1, y, cosh, sinh}"}) {
    EXPECT_EQ(interpolation_mask(space(text)).symbol, published.symbol) << text;
  }
}

// Lemma 2.1 there: affine invariance, as 2 (alpha + beta) = 1.
TEST(MaskSequence, Lemma21TheWeightsOfTheUnifiedCurveSumToOne) {
  const LaurentPolynomial a = load("unified-curve").sequence->mask.symbol;
  EXPECT_EQ(a(Rational(1)), RationalFunction::constant(1, 2));
  EXPECT_EQ(a.coefficient(1) + a.coefficient(3), RationalFunction::constant(1, Rational(1) / 2));
}

// Remark 2.2 there, and section 2.5: mu = 1 and the limit are the four-point scheme with w = 1/16.
TEST(MaskSequence, Remark22TheLimitIsTheFourPointScheme) {
  const Scheme unified = load("unified-curve"), four_point = load("four-point");
  EXPECT_EQ(unified.mask.symbol.at(std::array<Rational, 1>{0}),
            at(four_point.mask, std::array<Rational, 1>{Rational(1) / 16}).symbol);
}

TEST(MaskSequence, PolynomialSpacesGiveTheDeslauriersDubucSchemes) {
  for (const auto& [text, name] : {std::pair{"{1, y, y^2, y^3, y^4, y^5}", "deslauriers-dubuc-6"},
                                   {"{1, y, y^2, y^3, y^4, y^5, y^6, y^7}", "deslauriers-dubuc-8"}}) {
    const Mask mask = interpolation_mask(space(text));
    EXPECT_EQ(mask.symbol.at(std::array<Rational, 1>{Rational(1) / 3}), load(name).mask.symbol) << name;
  }
}

TEST(MaskSequence, ExponentialSpacesTendToTheDeslauriersDubucSchemes) {
  EXPECT_EQ(load("six-point-nonstationary").mask.symbol.at(std::array<Rational, 1>{0}),
            load("deslauriers-dubuc-6").mask.symbol);
  for (const char* text : {"{1, y, cos, sin, y cos, y sin}", "{1, y, cos, sin, cos(2y), sin(2y)}"}) {
    const MaskSequence sequence{
        .types = {}, .mask = interpolation_mask(space(text)), .first_levels = {}, .interpolated = {}};
    EXPECT_EQ(limit_mask(sequence, 0).symbol, load("deslauriers-dubuc-6").mask.symbol) << text;
  }
}

TEST(MaskSequence, SpacesThatDoNotFitAreErrors) {
  for (const char* text : {"{1}", "{1, y, cos}", "{1, cos, sin, y}", "{y, y^2}", "{1, y^2}", "{1, y, cos, cosh}",
                           "{1, y, y cos, y sin}", "{cos, sin, cos(2y), sin(3y)}", "{1, y, cos(5y), sin(5y)}"}) {
    if (std::string(text) == "{1, cos, sin, y}") {
      EXPECT_NO_THROW(interpolation_mask(space(text)));  // the order plays no part
    } else {
      EXPECT_THROW(interpolation_mask(space(text)), InputError) << text;
    }
  }
}

TEST(ReadNonstationary, AFileOfAUser) {
  const Scheme scheme = read(R"toml(angle = "phi"
level_parameter = "c"
types = { hyperbolic = "(0, 2]" }
arity = 3
mask = ["1/(3*c)", "2/3", "1", "2/3", "1/(3*c)"]
first_levels = [{ mask = ["1", "1", "1"], first_index = 0 }]
[[claims]]
claim = "C1"
[[claims]]
claim = "reproduces {1, cosh}"
region = { phi = "1" })toml");
  EXPECT_EQ(scheme.kind, SchemeKind::nonstationary);
  EXPECT_EQ(scheme.parameter_names(), VariableNames{"phi"});
  EXPECT_EQ(scheme.claims[0].type, AngleType::hyperbolic);
  EXPECT_EQ(scheme.claims[0].region, (Box{{0, 2, true, false}}));
  EXPECT_EQ(scheme.claims[1].region, Box{Interval::point(1)});
  EXPECT_EQ(scheme.sequence->first_levels.size(), 1u);
  EXPECT_EQ(scheme.sequence->at_level(0).symbol.length(), 3);
  EXPECT_EQ(scheme.sequence->at_level(1).symbol.length(), 5);
}

TEST(ReadNonstationary, ErrorsNameTheLine) {
  const std::string types = "types = { trigonometric = [\"0\", \"3\"] }\n";
  const std::string mask = types + "mask = [\"1/2\", \"1\", \"1/2\"]\n";
  EXPECT_NO_THROW(read(mask));
  expect_error("\nmask = [\"1\"]");
  expect_error("types = { trigonometric = [\"0\", \"7\"] }\nmask = [\"1\"]");
  expect_error("types = { trigonometric = [\"-1\", \"1\"] }\nmask = [\"1\"]");
  expect_error("types = { polynomial = [\"0\", \"1\"] }\nmask = [\"1\"]");
  expect_error("types = { }\nmask = [\"1\"]");
  expect_error(types);
  expect_error(mask + "interpolate = [\"1\", \"y\"]");
  expect_error(types + "interpolate = [\"1\", \"tan\"]");
  expect_error(types + "interpolate = [\"1\", \"y\", \"cos\"]");
  expect_error(types + "mask = [\"1/(mu-1)\", \"1\"]");  // no limit
  expect_error(types + "mask = [\"mu-1\"]");             // the limit is zero
  expect_error(types + "mask = [\"nu\"]");
  expect_error(mask + "colour = 1");
  expect_error(mask + "angle = \"mu\"");
  expect_error(mask + "first_levels = [[\"1\"]]");
  expect_error(mask + "[parameters]\nw = [\"0\", \"1\"]");
  expect_error(mask, "[[claims]]\nclaim = \"C1\"\ntype = \"hyperbolic\"");
  expect_error(mask, "[[claims]]\nclaim = \"C1\"\nregion = { theta = \"4\" }");
  expect_error(mask, "[[claims]]\nclaim = \"reproduces {cosh}\"");
}

TEST(ReadNonstationary, OnlyNonstationarySchemesHaveClaimsAboutSpaces) {
  EXPECT_THROW(read_scheme("name = \"s\"\nkind = \"uniform\"\n[uniform]\nmask = [\"1\", \"1\"]\n[[claims]]\nclaim = "
                           "\"reproduces {1}\"\n",
                           "s.toml"),
               InputError);
}

}  // namespace
}  // namespace limes
