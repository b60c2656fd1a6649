#include "tests/checker/certificates.hpp"

using namespace limes::test;

// Each of these states something false, or true without a proof; each has been seen to slip through some check.

TEST(Soundness, MasksWithTheWrongSum) {
  for (int level = 1; level <= 6; ++level) {
    expect_invalid(smooth({{}, {"9/10", "9/5", "9/10"}, "C0"}, level), "sum");  // 9/10 (1+z)^2 diverges
    expect_invalid(smooth({{}, {"9/20", "9/10", "9/20"}, "C0"}, level), "sum");
    expect_invalid(smooth({{}, {"3/8", "9/8", "9/8", "3/8"}, "C1"}, level), "sum");  // 3/8 (1+z)^3
    expect_invalid(smooth({{}, {"1/8", "3/8", "3/8", "1/8"}, "C1"}, level), "sum");  // tends to zero
  }
  // (1+z)(1/2 + 3z/10 + 7z^2/10): b(1) = 3/2, and as a ternary scheme 1+z is no factor of smoothness at all.
  expect_invalid(smooth({{}, {"1/2", "4/5", "1", "7/10"}, "C0", Json::object(), 3}, 2), "factor");
  expect_invalid(smooth({{}, {"1/2", "4/5", "1", "7/10"}, "C0"}, 2), "sum");
}

TEST(Soundness, EmptyAndVanishingMasks) {
  for (const auto& mask :
       std::vector<std::vector<std::string>>{{"0"}, {"0", "0", "0"}, {"w - w", "0*w"}, {"w - 1/16", "1/16 - w"}}) {
    const Claim yes{{"w"}, mask, "C0", {{"w", "1/16"}}}, no{{"w"}, mask, "not C0", {{"w", "1/16"}}};
    expect_invalid(smooth(yes, 1), "sum");
    for (const auto& stability : {"interpolatory", "linear-independence"}) {
      expect_invalid(rough(no, stability, {0}), "stability");
      expect_invalid(rough(no, stability), "stability");
    }
  }
}

TEST(Soundness, ClaimsOneOrderTooHigh) {
  expect_invalid(smooth({{}, {"1/4", "3/4", "3/4", "1/4"}, "C2"}, 5), "contractivity");
  expect_invalid(smooth({{"w"}, four_point, "C2", {{"w", "1/16"}}}, 12), "contractivity");
  expect_invalid(smooth({{"w"}, four_point, "C2", {{"w", "[1/16, 1/15]"}}}, 4), "factor");
  expect_invalid(smooth({{}, {"1/2", "1", "1/2"}, "C1"}, 8), "contractivity");
}

TEST(Soundness, RegionsThatReachTooFar) {
  // C^1 holds for 0 < w < 0.1927..
  for (const char* region :
       {"[0, 1/16]", "0", "-1/100", "1/5", "193/1000", "(0, 1/5]", "[-1/100, 1/16]", "(-1/1000, 1/16]", "[1/16, 1/4)"})
    for (const int level : {1, 2, 5, 9})
      expect_invalid(smooth({{"w"}, four_point, "C1", {{"w", region}}}, level), "contractivity");
  // Not C^1 holds for w <= 0 and w >= 0.1927.. only.
  for (const char* region : {"1/8", "[1/8, 1/4]", "(19/100, 1/4]", "[1/5, 1/8]"})
    for (const std::vector<int>& word : {std::vector<int>{0}, {0, 1}, {0, 0, 1}, {0, 1, 1, 0}})
      expect_invalid(rough({{"w"}, four_point, "not C1", {{"w", region}}}, "interpolatory", word), "word claim");
}

TEST(Soundness, UnstableSchemesAreNotRefuted) {
  // 1/2 (1+z)(1+z^2) has the symmetric zeros +-i; (1+z^3) the zero exp(i pi/3); both limits have linearly dependent shifts.
  const std::vector<std::vector<std::string>> unstable{
      {"1/2", "1/2", "1/2", "1/2"},
      {"1", "0", "0", "1"},
      {"1", "0", "0", "0", "0", "1"},
      {"1", "0", "1"},
      {"1/2", "0", "0", "1", "0", "0", "1/2"},              // the hat function with spacing 3, which is C^0
      {"1/4", "1/2", "1/2", "1/2", "1/4"},                  // (1+z)^2 (1+z^2)/4: C^1 although the shifts are dependent
      {"0", "1", "0", "0", "0", "0", "0", "0", "0", "1"}};  // 1 + z^9
  for (const auto& mask : unstable) {
    for (const char* m : {"0", "1", "2", "3"}) {
      const Claim claim{{}, mask, std::string("not C") + m};
      expect_invalid(rough(claim, "linear-independence"), "stability");
      expect_invalid(rough(claim, "linear-independence", {0}), "stability");
    }
  }
  expect_invalid(rough({{}, {"1/4", "3/4", "3/4", "1/4"}, "not C2"}, "interpolatory", {0}), "stability");
  expect_invalid(rough({{}, {"1/2", "1", "1", "1/2"}, "not C2"}, "linear-independence", {0}), "stability");  // a(1) = 3
  expect_invalid(
      rough({{}, {"1/3", "2/3", "1", "2/3", "1/3"}, "not C1", Json::object(), 3}, "linear-independence", {0}),
      "stability");
  expect_invalid(rough({{"w"}, four_point, "not C2", {{"w", "[1/8, 1/4]"}}}, "linear-independence"), "stability");
  // Linear independence does hold for the stable four-point scheme at one value.
  expect_valid(rough({{"w"}, four_point, "not C2", {{"w", "1/8"}}}, "linear-independence"));
}

TEST(Soundness, InterpolatoryMeansOneWholeResidueClass) {
  const Json none = Json::object();
  expect_valid(rough({{}, {"1", "1", "1"}, "not C0", none, 3}, "interpolatory", {0}));
  expect_invalid(rough({{}, {"1/2", "2", "1/2"}, "not C0"}, "interpolatory"), "stability");  // a_0 = 2
  expect_invalid(rough({{}, {"-1", "1", "1", "1", "1", "-1"}, "not C1"}, "interpolatory"),
                 "stability");  // a second entry
  expect_invalid(rough({{"w"}, {"w", "1", "1 - w"}, "not C1", {{"w", "[0, 1]"}}, 3}, "interpolatory", {3}), "proof");
}

TEST(Soundness, DenominatorsThatVanish) {
  const auto mask = [](const std::string& w) {
    return std::vector<std::string>{"-" + w, "0", "1/2 + " + w, "1", "1/2 + " + w, "0", "-" + w};
  };
  const auto reject = [&](const std::string& w, const std::string& region, const std::string& steps) {
    expect_invalid(smooth({{"t"}, mask("(" + w + ")"), "C1", {{"t", region}}}, 2), steps);
    expect_invalid(rough({{"t"}, mask("(" + w + ")"), "not C2", {{"t", region}}}, "interpolatory"), steps);
  };
  reject("1/(16*t)", "[0, 1]", "denominator");
  reject("1/(16*t)", "0", "denominator");
  reject("1/(16 + t)", "[-17, 1]", "denominator");
  reject("t/(16*t)", "[-1, 1]", "denominator");
  reject("t/(16*t)", "[0, 1]", "denominator");
  reject("t/(16*t)", "0", "denominator");
  reject("1/16 + 0/t", "[-1, 1]", "denominator");
  reject("1/16*(1/t)^0", "0", "denominator");
  reject("1/(1/(1/16/t))", "0", "denominator");
  reject("1/(16 + 1/(1/t))*0 + 1/16", "[-1, 0]", "denominator");
  reject("1/0", "1", "scheme");
  reject("1/(t - t)", "1", "scheme");
  reject("1/(2*t - t - t)", "1", "scheme");
  // An excluded end may be a pole of the expression.
  expect_valid(smooth({{"t"}, mask("(t/(16*t))"), "C1", {{"t", "(0, 1]"}}}, 2));
  expect_valid(smooth({{"t"}, mask("(1/16*(1/t)^0)"), "C1", {{"t", "(0, 1]"}}}, 2));
  expect_valid(smooth({{"t"}, mask("(-t/(-16*t))"), "C1", {{"t", "[-1, 0)"}}}, 2));
}

TEST(Soundness, LeavesMustCoverExactly) {
  const auto covers = [](const Json& region, const std::vector<Json>& regions, bool expected) {
    Json leaves = Json::array();
    for (const auto& leaf : regions) leaves.push_back({{"region", leaf}, {"level", 2}});
    std::vector<std::string> parameters;
    for (const auto& [name, interval] : region.items()) parameters.push_back(name);
    std::vector<std::string> mask{"1/4", "3/4", "3/4", "1/4"};
    const auto json = certificate({parameters, mask, "C1", region}, "certified", "U1", {{"leaves", leaves}});
    if (expected)
      expect_valid(json);
    else
      expect_invalid(json, "covering");
  };
  const auto line = [&](const std::string& region, const std::vector<std::string>& regions, bool expected) {
    std::vector<Json> leaves;
    for (const auto& leaf : regions) leaves.push_back({{"w", leaf}});
    covers({{"w", region}}, leaves, expected);
  };
  line("[0, 1]", {"[0, 1/2]", "(1/2, 1]"}, true);
  line("[0, 1]", {"(1/2, 1]", "[0, 1/2)", "1/2"}, true);
  line("[0, 1]", {"[0, 1/2)", "(1/2, 1]"}, false);  // one point is missing
  line("[0, 1]", {"(0, 1/2]", "(1/2, 1]"}, false);
  line("[0, 1]", {"[0, 1/2]", "(1/2, 1)"}, false);
  line("(0, 1)", {"(0, 1/2]", "[1/2, 1)"}, true);
  line("(0, 1)", {"[0, 1/2]", "[1/2, 1)"}, false);  // a leaf outside of the region
  line("(0, 1)", {"(0, 1)", "1"}, false);
  line("(0, 1)", {"1/2"}, false);
  line("(0, 1)", {"(0, 1)", "(1/4, 1/3)", "1/2", "1/2"}, true);
  line("1/2", {"2/4"}, true);
  line("1/2", {"[1/2, 1]"}, false);
  line("[0, 1]", {"[0, 1/3]", "[1/3, 1/2]", "[2/3, 1]"}, false);
  line("[-1, 1]", {"[-1, 0)", "(0, 1]", "-0/7"}, true);
  const auto box = [](const char* u, const char* v) { return Json{{"u", u}, {"v", v}}; };
  const Json square = box("[0, 1]", "[0, 1]");
  covers(square, {box("[0, 1/2]", "[0, 1]"), box("(1/2, 1]", "[0, 1/3]"), box("(1/2, 1]", "(1/3, 1]")}, true);
  covers(square, {box("[0, 1/2]", "[0, 1]"), box("(1/2, 1]", "[0, 1/3)"), box("(1/2, 1]", "(1/3, 1]")}, false);
  // A pinwheel: no cut goes through; the middle is missing, or a single point of it.
  std::vector<Json> pinwheel{box("[0, 2/3]", "[0, 1/3]"), box("(2/3, 1]", "[0, 2/3]"), box("(1/3, 1]", "(2/3, 1]"),
                             box("[0, 1/3]", "(1/3, 1]")};
  covers(square, pinwheel, false);
  pinwheel.push_back(box("(1/3, 2/3]", "(1/3, 2/3]"));
  covers(square, pinwheel, true);
  pinwheel.back() = box("(1/3, 1/2]", "(1/3, 2/3]");
  pinwheel.push_back(box("(1/2, 2/3]", "(1/3, 1/2)"));
  pinwheel.push_back(box("(1/2, 2/3]", "(1/2, 2/3]"));
  covers(square, pinwheel, false);
  pinwheel.push_back(box("(1/2, 2/3]", "1/2"));
  covers(square, pinwheel, true);
  // A fine grid in two and three parameters with one cell left out.
  for (const bool complete : {true, false}) {
    std::vector<Json> grid;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        for (int k = 0; k < 6; ++k) {
          const auto side = [](int n, int of) {
            return "[" + std::to_string(n) + "/" + std::to_string(of) + ", " + std::to_string(n + 1) + "/" +
                   std::to_string(of) + (n + 1 == of ? "]" : ")");
          };
          if (complete || i != 7 || j != 3 || k != 5)
            grid.push_back({{"u", side(i, 12)}, {"v", side(j, 12)}, {"w", side(k, 6)}});
        }
    covers({{"u", "[0, 1]"}, {"v", "[0, 1]"}, {"w", "[0, 1]"}}, grid, complete);
  }
}

TEST(Soundness, ARefutationNeedsAWitnessInsideTheRegion) {
  auto json = valid_certificates().at("four-point-c2-refuted");
  json["claim"]["region"]["w"] = "[0, 1/17]";
  expect_invalid(json, "covering");
  json["proof"]["leaves"] = Json::array();
  expect_invalid(json, "proof");
}

TEST(Soundness, OneFailingLeafIsEnough) {
  auto json = valid_certificates().at("four-point-c1");
  json["claim"]["region"]["w"] = "[0, 18/100]";
  expect_invalid(json, "covering");
  json["proof"]["leaves"].push_back({{"region", {{"w", "0"}}}, {"level", 3}});
  expect_invalid(json, "contractivity");
}

TEST(Soundness, VerdictAndTheoremBelongTogether) {
  for (const auto& [name, json] : valid_certificates()) {
    for (const char* verdict : {"certified", "refuted"}) {
      for (const char* theorem : {"U1", "U2"}) {
        auto other = json;
        other["verdict"] = verdict;
        other["theorem"] = theorem;
        if (other == json) continue;
        expect_invalid(other, "claim proof");
      }
    }
  }
}

TEST(Soundness, AZeroAtAClosedEndIsNoStrictSign) {
  // The remainder vanishes at w = 1/16: a closed end there proves nothing, an open one is fine.
  expect_invalid(rough({{"w"}, four_point, "not C2", {{"w", "[1/16, 1/4]"}}}, "interpolatory"), "missing_factor");
  expect_invalid(rough({{"w"}, four_point, "not C2", {{"w", "[1/20, 1/16]"}}}, "interpolatory"), "missing_factor");
  expect_invalid(rough({{"w"}, four_point, "not C2", {{"w", "(1/20, 1/4)"}}}, "interpolatory"), "missing_factor");
  expect_valid(rough({{"w"}, four_point, "not C2", {{"w", "[1/20, 1/16)"}}}, "interpolatory"));
}
