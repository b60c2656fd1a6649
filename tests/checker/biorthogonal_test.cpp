// Theorem B1: hand-made certificates, and for each field altered ones that must be rejected.
#include "tests/checker/certificates.hpp"

using namespace limes::test;

namespace {

/// Chaikin's filters [MoltajiRunionsSamavati2017, eqs. 43 and 48], with bounds somewhat wider than needed.
Json chaikin() {
  return Json::parse(R"({
    "format": "limes-certificate", "version": 1, "theorem": "B1", "verdict": "certified",
    "scheme": {"kind": "uniform", "name": "chaikin", "parameters": [], "arity": 2, "first_index": -1,
               "mask": ["1/4", "3/4", "3/4", "1/4"]},
    "claim": {"statement": "biorthogonal",
              "filters": {"p": ["1/4", "3/4", "3/4", "1/4"], "a": ["-1/4", "3/4", "3/4", "-1/4"],
                          "b": ["-1/4", "3/4", "-3/4", "1/4"], "q": ["1/4", "3/4", "-3/4", "-1/4"], "shift": 0},
              "squares": {"orthogonality_error": ["9/32", "9/32"], "sigma_min_p": ["499/1000", "1/2"],
                          "norm_a": ["2", "2001/1000"], "norm_b": ["2", "2001/1000"]}},
    "proof": {"sigma_min_p": "-1", "norm_a": "-1", "norm_b": "1"}})");
}

limes::checker::Result check(const Json& json) { return limes::checker::check(json.dump()); }

void expect_rejected(const Json& json, const std::string& step, const std::string& what) {
  const auto result = check(json);
  EXPECT_FALSE(result.valid) << what << ": " << result.statement;
  if (!step.empty()) {
    EXPECT_EQ(result.step, step) << what << ": " << result.reason;
  }
}

TEST(Biorthogonal, ChaikinIsValid) {
  const auto result = check(chaikin());
  EXPECT_TRUE(result.valid) << result.step << ": " << result.reason;
  EXPECT_NE(result.statement.find("PA + QB = I"), std::string::npos);
}

TEST(Biorthogonal, EveryAlteredEntryOfAFilterIsRejected) {
  for (const char* filter : {"p", "a", "b", "q"}) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (const char* value : {"0", "1/3", "1", "-1", "1000000000000000000000001/4000000000000000000000000"}) {
        Json json = chaikin();
        json["claim"]["filters"][filter][i] = value;
        expect_rejected(json, std::string(filter) == "p" ? "mask" : "biorthogonality", filter);
      }
    }
  }
  Json json = chaikin();
  json["scheme"]["mask"][2] = "1/2";
  expect_rejected(json, "mask", "mask");
  json = chaikin();
  json["scheme"]["mask"].push_back("1/8");
  expect_rejected(json, "mask", "mask longer than p");
  for (const int shift : {-4, -2, 2, 4}) {
    json = chaikin();
    json["claim"]["filters"]["shift"] = shift;
    expect_rejected(json, "biorthogonality", "shift");
  }
}

TEST(Biorthogonal, FalseBoundsAreRejectedAndWiderOnesAreTrue) {
  const auto with = [](const char* key, const char* low, const char* high) {
    Json json = chaikin();
    json["claim"]["squares"][key] = {low, high};
    return json;
  };
  expect_rejected(with("orthogonality_error", "1/4", "7/25"), "orthogonality_error", "above");
  expect_rejected(with("orthogonality_error", "283/1000", "1"), "orthogonality_error", "below");
  expect_rejected(with("sigma_min_p", "5000001/10000000", "1"), "singular_values", "a lower bound that is too high");
  expect_rejected(with("sigma_min_p", "1/10", "49/100"), "singular_values", "an upper bound that is too low");
  expect_rejected(with("norm_a", "1", "1999/1000"), "singular_values", "an upper bound that is too low");
  expect_rejected(with("norm_b", "1", "19999999/10000000"), "singular_values", "an upper bound that is too low");
  expect_rejected(with("norm_a", "2001/1000", "3"), "singular_values", "a lower bound that is too high");
  expect_rejected(with("norm_b", "2", "1"), "claim", "reversed");
  EXPECT_TRUE(check(with("norm_a", "0", "100")).valid);
  EXPECT_TRUE(check(with("sigma_min_p", "-1", "100")).valid);
  EXPECT_TRUE(
      check(with("sigma_min_p", "4999999999999999999999999999999/10000000000000000000000000000000", "1/2")).valid);
}

TEST(Biorthogonal, WitnessesAreNeeded) {
  for (const char* key : {"sigma_min_p", "norm_a", "norm_b"}) {
    for (const char* value : {"0", "2", "-2", "1000000"}) {
      Json json = chaikin();
      json["proof"][key] = value;
      expect_rejected(json, "singular_values", key);
    }
  }
}

/// Every node deleted, repeated, or replaced: a form that the page does not allow.
void mutate(const Json& original, const Json::json_pointer& at, std::size_t& count) {
  const Json& node = original.at(at);
  const auto expect = [&](const Json& value, const char* what) {
    Json json = original;
    json[at] = value;
    if (json == original) return;
    expect_rejected(json, "", at.to_string() + " " + what);
    ++count;
  };
  for (const Json& value : {Json(nullptr), Json(true), Json::array(), Json::object(), Json(1.5), Json("x"), Json(""),
                            Json(-7), Json("1/0"), Json(1e300)}) {
    const std::string key = at.empty() ? "" : at.back();
    if (key == "name" && value.is_string() && value != "") continue;  // a label
    if (key == "first_index" && value.is_number_integer()) continue;  // a shift proves nothing
    if (key == "parameters" && value == Json::array()) continue;
    expect(value, value.dump().c_str());
  }
  if (node.is_object()) {
    for (const auto& [key, value] : node.items()) {
      Json json = original;
      json[at].erase(key);
      expect_rejected(json, "", at.to_string() + " without " + key);
      json = original;
      json[at][key + "x"] = value;
      expect_rejected(json, "", at.to_string() + " with an unknown key");
      mutate(original, at / key, count);
    }
  }
  if (node.is_array()) {
    for (std::size_t i = 0; i < node.size(); ++i) {
      Json json = original;
      json[at].erase(i);
      expect_rejected(json, "", at.to_string() + " shorter");
      mutate(original, at / i, count);
    }
  }
}

TEST(Biorthogonal, EveryNodeOfAnotherFormIsRejected) {
  std::size_t count = 0;
  mutate(chaikin(), Json::json_pointer(), count);
  EXPECT_GT(count, 300u);
}

TEST(Biorthogonal, HugeWorkIsRefused) {
  Json json = chaikin();
  const std::string digits(9000, '7');
  Json filter = Json::array();
  for (int i = 0; i < 512; ++i) filter.push_back("1/" + digits + std::to_string(i + 1000));
  for (const char* name : {"p", "a", "b", "q"}) json["claim"]["filters"][name] = filter;
  json["scheme"]["mask"] = filter;
  expect_rejected(json, "limits", "large numbers");
}

}  // namespace
