#include "tests/checker/certificates.hpp"

using namespace limes::test;

TEST(Valid, EveryStoredCertificateIsValidAndSaysWhatItProves) {
  const std::map<std::string, std::string> statements{
      {"chaikin-c1", "certified: chaikin is C1 (theorem U1, 1 leaf)"},
      {"four-point-c1", "certified: four-point is C1 for w in (0, 18/100] (theorem U1, 5 leaves)"},
      {"four-point-c2-refuted",
       "refuted: four-point is C2 for w in [0, 1/8]; it is not C2 for w = 1/16 (theorem U2, 2 leaves)"},
      {"four-point-not-c1-refuted",
       "refuted: four-point is not C1 for w in [0, 1/4); it is C1 for w = 1/16 (theorem U1, 1 leaf)"},
      {"cubic-b-spline-not-c3", "certified: b-spline-3 is not C3 (theorem U2, 1 leaf)"},
      {"ternary-four-point-c1", "certified: \"ternary four-point (Deslauriers & Dubuc)\" is C1 (theorem U1, 1 leaf)"},
      {"two-parameters-c1",
       "certified: two-parameters is C1 for u in [1/8, 1/2], v in (0, 3/8] (theorem U1, 4 leaves)"}};
  std::size_t seen = 0;
  for (const auto& [name, json] : valid_certificates()) {
    const auto result = check(json);
    EXPECT_TRUE(result.valid) << name << ": " << result.step << ": " << result.reason;
    EXPECT_TRUE(result.step.empty() && result.reason.empty()) << name;
    if (const auto found = statements.find(name); found != statements.end()) {
      EXPECT_EQ(result.statement, found->second);
      ++seen;
    }
  }
  EXPECT_EQ(seen, statements.size());
}

TEST(Valid, TheExampleOfTheSpecificationIsValid) {
  const std::string text = read_text(LIMES_SOURCE_DIR "/docs/certificate.md");
  const auto start = text.find("```json\n");
  ASSERT_NE(start, std::string::npos);
  const auto end = text.find("```", start + 8);
  ASSERT_NE(end, std::string::npos);
  const auto result = limes::checker::check(text.substr(start + 8, end - start - 8));
  EXPECT_TRUE(result.valid) << result.step << ": " << result.reason;
  EXPECT_NE(text.find(result.statement), std::string::npos)
      << "the specification shows the answer: " << result.statement;
}

TEST(Valid, BSplinesAreExactlyOneDegreeLessSmooth) {
  // B-spline of degree d: mask binom(d + 1, i) / 2^d, C^{d-1} and not C^d.
  std::vector<long> row{1, 1};
  for (int d = 1; d <= 12; ++d) {
    row.push_back(1);
    for (std::size_t i = row.size() - 2; i > 0; --i) row[i] += row[i - 1];
    std::vector<std::string> mask;
    for (const long c : row) mask.push_back(std::to_string(c) + "/" + std::to_string(1 << d));
    expect_valid(smooth({{}, mask, "C" + std::to_string(d - 1)}, 1));
    expect_invalid(smooth({{}, mask, "C" + std::to_string(d)}, 3), "contractivity");
    expect_invalid(smooth({{}, mask, "C" + std::to_string(d + 1)}, 3), "factor");
    expect_valid(rough({{}, mask, "not C" + std::to_string(d)}, "linear-independence", {0}));
    expect_valid(rough({{}, mask, "not C" + std::to_string(d + 1)}, "linear-independence"));
    expect_invalid(rough({{}, mask, "not C" + std::to_string(d - 1)}, "linear-independence", {0}), "word");
    expect_invalid(rough({{}, mask, "not C" + std::to_string(d - 1)}, "linear-independence"), "missing_factor");
  }
}

TEST(Valid, ShiftAndZeroPaddingChangeNothing) {
  for (auto [name, json] : valid_certificates()) {
    json["scheme"]["first_index"] = 12345;
    auto& mask = json["scheme"]["mask"];
    mask.insert(mask.begin(), "0");
    mask.push_back("0");
    expect_valid(json);
  }
}

TEST(Valid, ReversalChangesNothing) {
  for (auto [name, json] : valid_certificates()) {
    if (json["theorem"] != "U1") continue;  // a word is tied to the direction of the mask
    auto& mask = json["scheme"]["mask"];
    std::reverse(mask.begin(), mask.end());
    expect_valid(json);
  }
}

TEST(Valid, ReparametrisationChangesNothing) {
  // w = 1/(8 + k) and w = x^2 for the four-point scheme, with an open end where the norm tends to 1.
  const auto mask = [](const std::string& w) {
    return std::vector<std::string>{"-" + w, "0", "1/2 + " + w, "1", "1/2 + " + w, "0", "-" + w};
  };
  expect_valid(smooth({{"k"}, mask("(1/(8 + k))"), "C1", {{"k", "[0, 8]"}}}, 2));
  expect_valid(smooth({{"x"}, mask("x^2"), "C1", {{"x", "(0, 1/3]"}}}, 2));
  expect_valid(smooth({{"x"}, mask("x^2"), "C1", {{"x", "[-1/3, 0)"}}}, 2));
  expect_valid(smooth({{"w", "unused"}, four_point, "C1", {{"w", "(0, 1/8]"}, {"unused", "[-1, 5/2)"}}}, 2));
}

TEST(Valid, HighLevelsAreFast) {
  const std::vector<std::string> six{"w",          "0", "-3*w - 1/16", "0", "2*w + 9/16", "1",
                                     "2*w + 9/16", "0", "-3*w - 1/16", "0", "w"};
  expect_valid(smooth({{"w"}, six, "C2", {{"w", "[1/100, 1/50]"}}}, 12));
  expect_valid(smooth({{"w"}, six, "C2", {{"w", "1/50"}}}, 16));
}
