// Theorems P0, P1 and P2: valid certificates, and what alterations of each field must come to.
#include "tests/checker/certificates.hpp"

namespace limes::test {
namespace {

Json load(const std::string& name) { return Json::parse(read_text(std::string(LIMES_SOURCE_DIR "/tests/checker/unity_data/") + name + ".json")); }

const std::vector<std::string> names{"polynomial-5-only-zero-limits", "polynomial-5-not-c0", "polynomial-5-projective-c0", "polynomial-5-not-projective-c1",
                                     "interpolating-cinpact-5-not-projective-c1"};

Json with_mask(Json json, const std::vector<std::string>& mask) {
  json["scheme"]["mask"] = mask;
  return json;
}

TEST(Projective, CertificatesAreValid) {
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    expect_valid(load(name));
  }
}

TEST(Projective, StatementSaysWhatIsProved) {
  EXPECT_EQ(check(load(names[3])).statement, "certified: \"polynomial-weight-5\" is not projective C1 (theorem P2)");
  Json refuted = load(names[3]);
  refuted["verdict"] = "refuted";
  refuted["claim"]["statement"] = "projective C3";
  EXPECT_EQ(check(refuted).statement, "refuted: \"polynomial-weight-5\" is projective C3; it is not projective C1 (theorem P2)");
  refuted = load(names[1]);
  refuted["verdict"] = "refuted";
  refuted["claim"]["statement"] = "C2";
  expect_valid(refuted);
  refuted = load(names[2]);
  refuted["verdict"] = "refuted";
  refuted["claim"]["statement"] = "not projective C0";
  expect_valid(refuted);
}

TEST(Projective, OtherStatementsAreRejected) {
  for (const std::string& name : names) {
    for (const std::string statement : {"C0", "C1", "not C1 ", "projective", "projective C", "not projective C0", "projective C1", "zero limits", ""}) {
      Json json = load(name);
      json["claim"]["statement"] = statement;
      expect_invalid(json, "claim");
    }
    Json json = load(name);
    json["verdict"] = "refuted";
    expect_invalid(json, "claim");
    json["verdict"] = "proved";
    expect_invalid(json, "format");
    json = load(name);
    json["claim"]["region"]["w"] = "[0, 1]";
    expect_invalid(json, "claim");
  }
}

TEST(Projective, MissingUnknownAndMistypedKeysAreRejected) {
  for (const std::string& name : names) {
    const Json valid = load(name);
    for (const std::string part : {"scheme", "claim", "proof"}) {
      for (const auto& [key, value] : valid[part].items()) {
        Json json = valid;
        json[part].erase(key);
        expect_invalid(json, part);
        for (const Json& other : {Json(nullptr), Json(-1), Json(1.5), Json::object(), Json("x"), Json::array({7})}) {
          json = valid;
          if (json[part][key].type() == other.type() || (part == "scheme" && (key == "name" || key == "first_index"))) continue;
          json[part][key] = other;
          EXPECT_FALSE(check(json).valid) << name << ' ' << part << ' ' << key << ' ' << other;
        }
      }
      Json json = valid;
      json[part]["more"] = 1;
      expect_invalid(json, part);
    }
    Json json = valid;
    json["theorem"] = "P3";
    expect_invalid(json, "format");
  }
}

TEST(Projective, OnlyMasksWithoutSumRulesHaveNoLimitsButZero) {
  for (const std::string& name : {names[0], names[1]}) expect_invalid(with_mask(load(name), {"1/4", "3/4", "3/4", "1/4"}), "sums");
  expect_valid(with_mask(load(names[0]), {"1/4", "3/4", "3/4", "26/100"}));
  // With all coefficients halved the data tend to zero: there is a limit, zero.
  expect_valid(with_mask(load(names[0]), {"1/8", "3/8", "3/8", "1/8"}));
  expect_invalid(with_mask(load(names[1]), {"1/8", "3/8", "3/8", "1/8"}), "word");
  expect_invalid(with_mask(load(names[1]), {"1"}), "scheme");
}

TEST(Projective, WordsOfP0) {
  Json json = load(names[1]);
  json["proof"]["word"] = Json::array();
  expect_invalid(json, "proof");
  json["proof"]["word"] = {2};
  expect_invalid(json, "proof");
  json["proof"]["word"] = std::vector<int>(65, 0);
  expect_invalid(json, "proof");
}

TEST(Projective, ConesMustBeProved) {
  for (const std::string& name : {names[2], names[3], names[4]}) {
    const Json valid = load(name);
    const std::size_t n = valid["proof"]["cone"]["lower"].size();
    Json json = valid;
    std::swap(json["proof"]["cone"]["lower"], json["proof"]["cone"]["upper"]);
    expect_invalid(json, "cone");
    for (const std::string key : {"lower", "upper"}) {
      for (std::size_t k = 0; k < n; ++k) {
        for (const std::string value : {"0", "-1", key == "lower" ? "2" : "1/2", "1000000", "1/0", "1e9", ""}) {
          json = valid;
          json["proof"]["cone"][key][k] = value;
          EXPECT_FALSE(check(json).valid) << name << ' ' << key << ' ' << k << ' ' << value;
        }
      }
      json = valid;
      json["proof"]["cone"][key].erase(0);
      expect_invalid(json, "proof");
      json = valid;
      json["proof"]["cone"][key].push_back("1");
      expect_invalid(json, "proof");
    }
    json = valid;  // an invariant cone in the wrong place: the ones are outside
    for (std::size_t k = 0; k < n; ++k) json["proof"]["cone"]["lower"][k] = "1001/1000", json["proof"]["cone"]["upper"][k] = "1002/1000";
    expect_invalid(json, "cone");
    for (const int level : {0, 13, -1}) {
      json = valid;
      json["proof"]["level"] = level;
      expect_invalid(json, "proof");
    }
    json = valid;
    json["proof"]["level"] = 1;
    expect_invalid(json, "cone contraction visible");
  }
}

TEST(Projective, MasksThatDoNotContract) {
  const Json valid = load(names[2]);
  const auto with_cone = [&](const std::vector<std::string>& mask) {
    Json json = with_mask(valid, mask);
    json["proof"]["cone"] = {{"lower", std::vector<std::string>(mask.size() - 1, "99/100")}, {"upper", std::vector<std::string>(mask.size() - 1, "101/100")}};
    return json;
  };
  expect_invalid(with_cone({"1", "0", "0", "1"}), "contraction cone");
  expect_invalid(with_cone({"1", "1"}), "scheme");              // constants on dyadic intervals: no continuous limits
  expect_invalid(with_cone({"1", "-1", "1", "1"}), "weights cone");
  expect_invalid(with_cone({"0", "0", "0"}), "scheme");
}

TEST(Projective, EigenpairsMustBeProved) {
  for (const std::string& name : {names[3], names[4]}) {
    const Json valid = load(name);
    Json json = valid;
    json["proof"]["second"] = json["proof"]["dominant"];
    expect_invalid(json, "second");
    json = valid;
    std::swap(json["proof"]["second"], json["proof"]["dominant"]);
    expect_invalid(json, "dominant");
    for (const std::string key : {"dominant", "second"}) {
      json = valid;
      json["proof"][key]["value"] = "2";
      expect_invalid(json, "eigenvector");
      json["proof"][key]["value"] = std::string(401, '1');
      expect_invalid(json, "proof");
      json = valid;
      for (auto& x : json["proof"][key]["vector"]) x = "0";
      expect_invalid(json, "eigenvector");
      for (auto& x : json["proof"][key]["vector"]) x = "1";
      EXPECT_FALSE(check(json).valid);
      json = valid;
      json["proof"][key]["vector"].erase(0);
      expect_invalid(json, "proof");
      for (std::size_t k = 0; k < valid["proof"][key]["vector"].size(); ++k) {
        json = valid;
        json["proof"][key]["vector"][k] = "-7/3";
        EXPECT_FALSE(check(json).valid) << name << ' ' << key << ' ' << k;
      }
    }
    json = valid;  // the eigenvalues of another word
    json["proof"]["word"].push_back(0);
    expect_invalid(json, "eigenvector");
    json["proof"]["word"] = Json::array();
    expect_invalid(json, "proof");
    json = valid;
    json["proof"]["window"].push_back(0);
    expect_invalid(json, valid["proof"]["level"] == 1 ? "" : "visible");
  }
}

TEST(Projective, WindowsMustShowTheSecondEigenvector) {
  const Json valid = load(names[4]);
  const int level = valid["proof"]["level"];
  int visible = 0;
  for (int bits = 0; bits < 1 << level; ++bits) {
    Json json = valid;
    json["proof"]["window"] = Json::array();
    for (int k = 0; k < level; ++k) json["proof"]["window"].push_back(bits >> k & 1);
    const auto result = check(json);
    visible += result.valid;
    EXPECT_TRUE(result.valid || result.step == "visible") << result.step;
  }
  EXPECT_LT(visible, 1 << level);  // some windows lie about a zero of the limit
}

/// The cubic B-spline's projective scheme is the linear one, which is C^2: no word can show anything else.
TEST(Projective, SmoothSchemesHaveNoRoughWords) {
  Json json = with_mask(load(names[2]), {"1/8", "1/2", "3/4", "1/2", "1/8"});
  json["proof"]["cone"] = {{"lower", {"999/1000", "999/1000", "999/1000", "999/1000"}}, {"upper", {"1001/1000", "1001/1000", "1001/1000", "1001/1000"}}};
  json["proof"]["level"] = 2;
  expect_valid(json);
  json["theorem"] = "P2";
  json["claim"]["statement"] = "not projective C1";
  json["proof"]["word"] = {0};
  json["proof"]["dominant"] = {{"value", "1"}, {"vector", {"1", "1", "1", "1"}}};
  // A_0 (2, 1, 0, -1) = 1/2 (2, 1, 0, -1): the samples of a linear function
  json["proof"]["second"] = {{"value", "1/2"}, {"vector", {"2", "1", "0", "-1"}}};
  json["proof"]["window"] = {0, 0};
  expect_invalid(json, "second");
}

}  // namespace
}  // namespace limes::test
