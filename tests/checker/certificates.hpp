#pragma once

#include "proofs/checker/checker.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace limes::test {

using Json = nlohmann::json;

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The certificates of tests/checker/data by name; all of them are valid.
inline std::map<std::string, Json> valid_certificates() {
  std::map<std::string, Json> result;
  for (const auto& entry : std::filesystem::directory_iterator(LIMES_SOURCE_DIR "/tests/checker/data"))
    if (entry.path().extension() == ".json")
      result[entry.path().stem().string()] = Json::parse(read_text(entry.path()));
  EXPECT_GE(result.size(), 14u);
  return result;
}

struct Range {
  double low, high;
};

/// The ends of an interval, widened to closed; only for intervals that the checker accepted.
inline Range range(const std::string& text) {
  const auto number = [](const std::string& t) {
    const auto slash = t.find('/');
    return std::stod(t) / (slash == std::string::npos ? 1 : std::stod(t.substr(slash + 1)));
  };
  if (text[0] != '[' && text[0] != '(') return {number(text), number(text)};
  const auto comma = text.find(',');
  return {number(text.substr(1, comma - 1)), number(text.substr(comma + 1))};
}

struct Claim {
  std::vector<std::string> parameters;
  std::vector<std::string> mask;
  std::string statement;
  Json region = Json::object();
  int arity = 2;
};

inline Json certificate(const Claim& claim, const std::string& verdict, const std::string& theorem, const Json& proof) {
  return {{"format", "limes-certificate"},
          {"version", 1},
          {"scheme",
           {{"kind", "uniform"},
            {"name", "test"},
            {"parameters", claim.parameters},
            {"arity", claim.arity},
            {"first_index", 0},
            {"mask", claim.mask}}},
          {"claim", {{"statement", claim.statement}, {"region", claim.region}}},
          {"verdict", verdict},
          {"theorem", theorem},
          {"proof", proof}};
}

/// "C^m certified by U1" with one leaf, the region.
inline Json smooth(const Claim& claim, int level) {
  return certificate(claim, "certified", "U1", {{"leaves", {{{"region", claim.region}, {"level", level}}}}});
}

/// "not C^m certified by U2" with one leaf, the region, and a word; without a word, by a missing factor.
inline Json rough(const Claim& claim, const std::string& stability, const std::vector<int>& word = {}) {
  Json leaf{{"region", claim.region}};
  if (word.empty())
    leaf["missing_factor"] = true;
  else
    leaf["word"] = word;
  return certificate(claim, "certified", "U2", {{"stability", stability}, {"leaves", Json::array({leaf})}});
}

inline checker::Result check(const Json& json) { return checker::check(json.dump()); }

inline void expect_valid(const Json& json) {
  const auto result = check(json);
  EXPECT_TRUE(result.valid) << result.step << ": " << result.reason << '\n' << json.dump();
}

/// Expects a rejection at one of the steps, separated by blanks.
inline void expect_invalid(const Json& json, const std::string& steps) {
  const auto result = check(json);
  EXPECT_FALSE(result.valid) << result.statement << '\n' << json.dump();
  EXPECT_NE((" " + steps + " ").find(" " + result.step + " "), std::string::npos)
      << result.step << ": " << result.reason << '\n'
      << json.dump();
  EXPECT_FALSE(result.reason.empty());
  EXPECT_TRUE(result.statement.empty());
}

inline const std::vector<std::string> four_point{"-w", "0", "1/2 + w", "1", "1/2 + w", "0", "-w"};

}  // namespace limes::test
