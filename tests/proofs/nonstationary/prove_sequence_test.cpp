#include "proofs/nonstationary/sequence_proof.hpp"

#include "proofs/checker/checker.hpp"
#include "proofs/prove.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/nonstationary/angle.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace limes {
namespace {

Scheme load(const char* name) {
  return Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name);
}

Scheme scheme(const std::string& table,
              const std::string& types = "trigonometric = [\"0\", \"3\"], hyperbolic = [\"0\", \"10\"]") {
  return read_scheme(
      "name = \"test\"\nkind = \"nonstationary\"\n[nonstationary]\ntypes = { " + types + " }\n" + table + "\n",
      "test.toml");
}

/// Decides a statement; what is decided is left for script/test to check once more.
Verdict decide(const Scheme& s, const std::string& text, const std::string& angles,
               AngleType type = AngleType::trigonometric) {
  static int count = 0;
  Claim claim = read_statement(text);
  claim.region = {read_angles(angles)};
  claim.type = type;
  Verdict verdict = prove(s, claim);
  EXPECT_EQ(verdict.outcome != Outcome::undecided, verdict.certificate.has_value());
  EXPECT_FALSE(verdict.reason.empty());
  if (verdict.certificate) {
    const auto directory = std::filesystem::path(LIMES_BINARY_DIR) / "certificates/proofs";
    std::filesystem::create_directories(directory);
    std::ofstream(directory / ("nonstationary." + std::to_string(++count) + ".json")) << verdict.certificate_json;
  }
  return verdict;
}

Outcome outcome(const Scheme& s, const std::string& text, const std::string& angles,
                AngleType type = AngleType::trigonometric) {
  return decide(s, text, angles, type).outcome;
}

TEST(ProveSequence, TheUnifiedCurveIsC1) {
  const Scheme unified = load("unified-curve");
  for (const char* angles : {"[0, 3.141592653589793]", "2*pi/7", "(0, 2*pi/3]", "0", "3"}) {
    EXPECT_EQ(outcome(unified, "C1", angles), Outcome::certified) << angles;
    EXPECT_EQ(outcome(unified, "C2", angles), Outcome::undecided) << angles;
  }
  EXPECT_EQ(outcome(unified, "C1", "[0, 20]", AngleType::hyperbolic), Outcome::certified);
  const Verdict verdict = decide(unified, "C1", "[0, 3]");
  EXPECT_EQ(verdict.certificate->theorem, Theorem::s1);
  EXPECT_EQ(std::get<AsymptoticProof>(verdict.certificate->proof).bound.order, 2);
}

TEST(ProveSequence, FactorsGiveTheSmoothnessOfExponentialSplines) {
  EXPECT_EQ(outcome(load("exponential-b-spline-3"), "C1", "[0, 3]"), Outcome::certified);
  EXPECT_EQ(outcome(load("exponential-b-spline-3"), "C2", "[0, 3]"), Outcome::undecided);
  EXPECT_EQ(outcome(load("exponential-b-spline-4"), "C2", "[0, 3]"), Outcome::certified);
  EXPECT_EQ(outcome(load("exponential-b-spline-4"), "C3", "[0, 3]"), Outcome::undecided);
  EXPECT_EQ(outcome(load("six-point-nonstationary"), "C2", "[0, 3]"), Outcome::certified);
}

/// Theorem S1 has no converse: docs/theory.md, section 14.
TEST(ProveSequence, ALimitThatIsNotSmoothRefutesNothing) {
  const Scheme to_polygon = scheme(R"(mask = ["mu-1", "0", "3/2-mu", "1", "3/2-mu", "0", "mu-1"])");
  EXPECT_EQ(outcome(to_polygon, "C0", "[0, 1]"), Outcome::certified);
  EXPECT_EQ(outcome(to_polygon, "C1", "[0, 1]"), Outcome::undecided);
  EXPECT_EQ(outcome(to_polygon, "not C1", "[0, 1]"), Outcome::undecided);
}

TEST(ProveSequence, AMaskWithoutSumRulesButWithALimitThatHasThem) {
  EXPECT_EQ(outcome(scheme(R"(mask = ["1/4", "3/4*mu", "3/4", "1/4"])"), "C1", "[0, 3]"), Outcome::certified);
  EXPECT_EQ(outcome(scheme(R"(mask = ["1/4", "3/4", "3/4", "1/4+mu-1"])"), "C1", "[0, 3]"), Outcome::certified);
  // Too slow for C^2 of the cubic spline, without factors for every mu.
  EXPECT_EQ(outcome(scheme(R"(mask = ["1/8", "1/2", "3/4*mu", "1/2", "1/8"])"), "C2", "[0, 3]"), Outcome::undecided);
  EXPECT_EQ(outcome(scheme(R"(mask = ["1/8", "1/2", "3/4+(mu-1)^2", "1/2", "1/8"])"), "C2", "[0, 3]"),
            Outcome::certified);
}

TEST(ProveSequence, PolesAreFoundAtTheirLevel) {
  // mu = 9/10: at step 0 for theta = 0.902..; angles beyond pass it at a later step, or between two steps.
  const Scheme pole = scheme(R"toml(mask = ["1/2", "1", "1/2*(mu-9/10)/(mu-9/10)+(mu-1)/(mu-9/10)"])toml");
  EXPECT_EQ(outcome(pole, "C0", "[0, 0.9]"), Outcome::certified);
  EXPECT_EQ(outcome(pole, "C0", "[0, 0.91]"), Outcome::undecided);
  EXPECT_EQ(outcome(pole, "C0", "[1, 1.7]"), Outcome::certified);
  EXPECT_EQ(outcome(pole, "C0", "[1.8, 1.81]"), Outcome::undecided);
  EXPECT_EQ(outcome(pole, "reproduces {1}", "[0, 0.91]"), Outcome::refuted);
}

TEST(ProveSequence, FirstLevelsAreFree) {
  const std::string mask = R"toml(mask = ["1/4", "3/4", "3/4", "1/4"]
first_levels = [{ mask = ["7", "mu"] }, { mask = ["1/(mu-1/2)", "1"] }])toml";
  EXPECT_EQ(outcome(scheme(mask), "C1", "[0, 3]"), Outcome::certified);
  EXPECT_EQ(outcome(scheme(mask), "reproduces {1}", "[0, 3]"),
            Outcome::undecided);  // the common mask does, the first ones do not
}

TEST(ProveSequence, TernarySchemesToo) {
  const Scheme ternary = scheme(R"(arity = 3
mask = ["1/3", "2/3", "mu", "2/3", "1/3"])");
  EXPECT_EQ(outcome(ternary, "C0", "[0, 3]"), Outcome::certified);
}

TEST(ProveSequence, Spaces) {
  const Scheme unified = load("unified-curve");
  EXPECT_EQ(outcome(unified, "reproduces {1, y, cos, sin}", "[0, 3.14]"), Outcome::certified);
  EXPECT_EQ(outcome(unified, "reproduces {1, y^2}", "[0, 3.14]"), Outcome::refuted);
  EXPECT_EQ(outcome(unified, "reproduces {1, y, y^2, y^3}", "0"), Outcome::certified);
  EXPECT_EQ(outcome(unified, "reproduces {y^4}", "0"), Outcome::refuted);
  EXPECT_EQ(outcome(unified, "does not reproduce {y^2, y cos, cos(2y)}", "(0, 3]"), Outcome::certified);
  EXPECT_EQ(outcome(unified, "does not reproduce {y^2}", "[0, 3]"), Outcome::refuted);  // theta = 0
  EXPECT_EQ(outcome(unified, "does not reproduce {y^2, cos}", "(0, 3]"), Outcome::refuted);
  EXPECT_EQ(outcome(unified, "generates {1, y, cos, sin}", "[0, 3]"), Outcome::certified);
  EXPECT_EQ(outcome(unified, "does not generate {y^2}", "(0, 3]"), Outcome::certified);
  const Scheme spline = load("exponential-b-spline-3");
  EXPECT_EQ(outcome(spline, "generates {1, cosh, sinh}", "[0, 20]", AngleType::hyperbolic), Outcome::certified);
  EXPECT_EQ(outcome(spline, "does not reproduce {y, cosh}", "(0, 20]", AngleType::hyperbolic), Outcome::certified);
}

TEST(ProveSequence, TheSameTextEveryTime) {
  const Scheme unified = load("unified-curve");
  EXPECT_EQ(decide(unified, "C1", "[0, 3]").certificate_json, decide(unified, "C1", "[0, 3]").certificate_json);
  for (const char* key : {"from_level", "factors", "order", "constant", "limit"}) {
    EXPECT_TRUE(nlohmann::json::parse(decide(unified, "C1", "[0, 3]").certificate_json)["proof"].contains(key));
  }
}

}  // namespace
}  // namespace limes
