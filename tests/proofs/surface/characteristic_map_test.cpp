#include "proofs/checker/checker.hpp"
#include "schemes/catalogue.hpp"
#include "tests/proofs/surface/decide.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>

using namespace limes;

namespace {

using test::decide;

using Json = nlohmann::json;

Claim smooth(const Scheme& scheme, const std::string& valences, const std::string& statement = "C1") {
  Claim claim = read_statement(statement);
  claim.valences = read_valences(valences);
  for (std::size_t k = 0; k < scheme.parameters.size(); ++k) claim.region.push_back(Interval::point(0));
  return claim;
}

/// L_i is an eigenvector to 1/2, K_i = side (L_i + L_{i+1}).
Scheme folded(const std::string& rule) {
  return read_scheme(
      "name = \"folded\"\nkind = \"surface\"\n[surface]\ncurve = \"four-point-1-16.toml\"\n[surface.rules]\n\"0,0\" = \"at(0,0)\"\n"
      "\"1,0\" = \"3/4*at(0,0) + 1/4*at(1,0) + 1/2*harmonic(1,1,0)\"\n\"1,1\" = \"" + rule + "\"\n",
      std::filesystem::path(LIMES_BINARY_DIR) / "folded.toml");
}

// Unified (Kobbelt 1996 at theta = 0), Catmull & Clark and Doo & Sabin are C^1 at extraordinary points of every valence.
TEST(CharacteristicMapProof, KnownSchemesAreSmoothAtEveryValence) {
  for (const char* name : {"unified", "catmull-clark", "doo-sabin"}) {
    const Scheme scheme = load_scheme(name);
    for (const char* valences : {"[3, inf)", "[5, 6]"}) {
      const std::string file = std::string(name) + ".C1." + std::to_string(valences[1]) + ".json";
      const Verdict verdict = decide(scheme, smooth(scheme, valences), file);
      ASSERT_EQ(verdict.outcome, Outcome::certified) << name << " " << valences << ": " << verdict.reason;
      EXPECT_EQ(verdict.certificate->theorem, Theorem::e2);
      EXPECT_NE(verdict.reason.find("regular and injective"), std::string::npos);
    }
  }
}

TEST(CharacteristicMapProof, ValencesTo50OneByOne) {
  const Scheme scheme = load_scheme("unified");
  const Verdict verdict = decide(scheme, smooth(scheme, "[3, 50]"), "unified.C1.50.json");
  EXPECT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
}

TEST(CharacteristicMapProof, NothingElseIsSaidOfSurfaces) {
  const Scheme scheme = load_scheme("unified");
  Claim claim = smooth(scheme, "5");
  claim.region = {Interval::point(Rational(1, 2))};
  const Verdict verdict = prove(scheme, claim);
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_NE(verdict.reason.find("theta != 0"), std::string::npos) << verdict.reason;
  for (const char* statement : {"C2", "not C1", "C0"}) EXPECT_EQ(prove(scheme, smooth(scheme, "5", statement)).outcome, Outcome::undecided);
}

TEST(CharacteristicMapProof, AFoldedMapIsUndecidedAlthoughTheSpectrumIsRight) {
  std::ofstream(std::filesystem::path(LIMES_BINARY_DIR) / "four-point-1-16.toml")
      << "name = \"four-point-1-16\"\nkind = \"uniform\"\n[uniform]\nmask = [\"-1/16\", \"0\", \"9/16\", \"1\", \"9/16\", \"0\", \"-1/16\"]\n";
  const Scheme wrong = folded("4/5*at(0,0) + 2/5*at(1,1) - 1/10*at(1,0) - 1/10*at(1,0,1)");
  const Scheme right = folded("2/5*at(0,0) + 2/5*at(1,1) + 1/10*at(1,0) + 1/10*at(1,0,1)");
  EXPECT_EQ(prove(right, smooth(right, "[3, 8]")).outcome, Outcome::certified) << prove(right, smooth(right, "[3, 8]")).reason;
  for (const char* valences : {"3", "5", "[3, 8]", "[3, inf)"}) {
    EXPECT_EQ(prove(wrong, smooth(wrong, valences, "spectral-condition")).outcome, Outcome::certified);
    const Verdict verdict = prove(wrong, smooth(wrong, valences));
    EXPECT_EQ(verdict.outcome, Outcome::undecided);
    EXPECT_NE(verdict.reason.find("the spectral condition holds, but the characteristic map"), std::string::npos) << verdict.reason;
  }
}

/// Every altered certificate is rejected.
TEST(CharacteristicMapProof, ForgeriesAreRejected) {
  const Scheme scheme = load_scheme("doo-sabin");
  const Json valid = Json::parse(decide(scheme, smooth(scheme, "[3, inf)"), "doo-sabin.C1.all.json").certificate_json);
  ASSERT_TRUE(checker::check(valid.dump()).valid);
  ASSERT_GE(valid["proof"]["map"]["pieces"].size(), 3u);
  const auto step = [&](const std::function<void(Json&)>& change) {
    Json altered = valid;
    change(altered);
    EXPECT_NE(altered, valid);
    const checker::Result result = checker::check(altered.dump());
    EXPECT_FALSE(result.valid) << result.statement;
    return result.step;
  };
  const auto map = [&](const std::function<void(Json&)>& change) { return step([&](Json& c) { change(c["proof"]["map"]); }); };
  EXPECT_EQ(map([](Json& m) { m["start"] = "9/10"; }), "proof");
  EXPECT_EQ(map([](Json& m) { m["start"] = "-1/2"; }), "proof");
  EXPECT_EQ(map([](Json& m) { m["pieces"].erase(m["pieces"].size() - 1); }), "proof");
  EXPECT_EQ(map([](Json& m) { m["pieces"].back()["to"] = "2"; }), "proof");
  map([](Json& m) { std::swap(m["pieces"][1], m["pieces"][2]); });
  EXPECT_EQ(map([](Json& m) { m["pieces"][0]["level"] = 0; }), "map");
  EXPECT_EQ(map([](Json& m) { m["pieces"][0]["level"] = 7; }), "proof");
  EXPECT_EQ(map([](Json& m) { m["pieces"] = Json::array({{{"to", "1"}, {"level", 3}}}); }), "map") << "too wide";
  EXPECT_EQ(map([](Json& m) { m.erase("pieces"); }), "proof");
  EXPECT_EQ(map([](Json& m) { m["levels"].push_back(3); }), "proof");
  EXPECT_EQ(step([](Json& c) { c["proof"].erase("map"); }), "proof");
  EXPECT_EQ(step([](Json& c) { c["claim"]["region"] = {{"theta", "0"}}; }), "claim");
  EXPECT_EQ(step([](Json& c) { c["claim"]["statement"] = "C2"; }), "claim");
  EXPECT_EQ(step([](Json& c) { c["theorem"] = "E1"; }), "claim");
  // a forged eigenvalue: a separator above it, or another root of the cell
  const auto cell = [&](const std::function<void(Json&)>& change) { return step([&](Json& c) { change(c["proof"]["all"]["cells"][0]); }); };
  EXPECT_EQ(cell([](Json& c) { c["separator"] = "3/5"; }), "spectrum");
  EXPECT_EQ(cell([](Json& c) { c["root"] = {"3/5", "7/10"}; }), "spectrum");
  // another scheme
  EXPECT_EQ(step([](Json& c) { c["scheme"]["rules"][0]["terms"][1]["weight"] = "1/7"; }), "sum");
}

/// Of a nonstationary scheme there is nothing beside the angle 0.
TEST(CharacteristicMapProof, OtherAnglesAreRejected) {
  const Scheme scheme = load_scheme("unified");
  Json json = Json::parse(prove(scheme, smooth(scheme, "5")).certificate_json);
  EXPECT_TRUE(checker::check(json.dump()).valid);
  for (const char* angles : {"[0, 1]", "1/1000", "(0, 1]"}) {
    json["claim"]["region"]["theta"] = angles;
    EXPECT_EQ(checker::check(json.dump()).step, "claim") << angles;
  }
}

}  // namespace
