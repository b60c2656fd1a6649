#include "tests/checker/nonuniform.hpp"

using namespace limes::test;

TEST(N3, Refutations) {
  for (const char* gamma : {"1/50", "50", "1/1000"}) {
    expect_valid(n3(a131_rule, "C1", "[1/100, 18/100]", "refuted", "13/100", gamma));
    expect_valid(n3(a131_rule, "not C1", "13/100", "certified", "13/100", gamma));
    expect_valid(n3(a131_rule, "C2", "13/100", "refuted", "13/100", gamma));
    expect_invalid(n3(a131_rule, "C0", "13/100", "refuted", "13/100", gamma), "eigenvalue");
  }
  EXPECT_EQ(
      check(n3(a131_rule, "C1", "[1/100, 18/100]", "refuted", "13/100", "1/50")).statement,
      "refuted: test is C1 over every knot sequence for w in [1/100, 18/100]; it is not C1 over some knot sequence for "
      "w = 13/100 (theorem N3, 1 leaf)");
  // The eigenvalue 2w, or the double eigenvalue -+ sqrt of 2 lambda^2 - lambda + 2w, or a second 1/2.
  expect_valid(n3("at(c,1/2)", "C1", "1/4", "refuted", "1/4", "1"));
  expect_valid(n3("at(c,1/2)", "C1", "3/10", "refuted", "3/10", "1/3"));
  // No refutation where the scheme is C^1, for small gamma or equal intervals only.
  for (const char* gamma : {"1/5", "1", "5"}) {
    expect_invalid(n3(a131_rule, "C1", "13/100", "refuted", "13/100", gamma), "eigenvalue");
    expect_invalid(n3("at(c,1/2)", "C1", "13/100", "refuted", "13/100", gamma), "eigenvalue");
  }
  expect_invalid(n3(a131_rule, "C1", "[1/100, 12/100]", "refuted", "13/100", "1/50"), "covering");
  expect_invalid(n3(a131_rule, "not C1", "[12/100, 13/100]", "certified", "13/100", "1/50"), "covering");
  expect_invalid(n3(a131_rule, "C1", "13/100", "certified", "13/100", "1/50"), "claim");
  expect_invalid(n3(a131_rule, "not C1", "13/100", "refuted", "13/100", "1/50"), "claim");
  expect_invalid(n3(a131_rule, "C1", "13/100", "refuted", "[1/10, 13/100]", "1/50"), "covering");
  for (const char* gamma : {"0", "-1/50", "(0, 1/50]", "1/0", "gamma", ""})
    expect_invalid(n3(a131_rule, "C1", "13/100", "refuted", "13/100", gamma), "proof");
  expect_invalid(n3("1/(w-13/100)*0*at(f(1,0),1/2) + at(c,1/2)", "C1", "13/100", "refuted", "13/100", "1/50"),
                 "denominator");
  expect_invalid(n3("0*at(c,1/2) + at(f(1,0),1/2) + 0*(1/(w-1)*at(c,1/2))", "C1", "1", "refuted", "1", "1/50"),
                 "denominator");
}

TEST(N3, RefutationsForEqualIntervals) {
  const Json leaf{{"region", {{"w", "1/5"}}}, {"word", {0, 1}}};
  const Json proof{{"stability", "interpolatory"}, {"leaves", Json::array({leaf})}};
  const Json missing{{"stability", "interpolatory"},
                     {"leaves", {{{"region", {{"w", "1/8"}}}, {"missing_factor", true}}}}};
  expect_valid(nonuniform(4, Let{}, a131_rule, "C1", {{"w", "[1/100, 1/5]"}}, "refuted", "U2", proof));
  expect_valid(nonuniform(4, Let{}, a131_rule, "C2", {{"w", "1/8"}}, "refuted", "U2", missing));
  expect_valid(nonuniform(4, Let{}, a131_rule, "not C2", {{"w", "1/8"}}, "certified", "U2", missing));
  expect_invalid(nonuniform(4, Let{}, a131_rule, "C1", {{"w", "1/8"}}, "refuted", "U2", missing), "missing_factor");
  expect_invalid(nonuniform(4, Let{}, a131_rule, "C1", {{"w", "[1/100, 1/5]"}}, "refuted", "U1", proof), "claim");
}

TEST(N3, Regions) {
  const auto on = [](const std::string& statement, const std::string& region,
                     const std::vector<std::array<std::string, 2>>& leaves, const std::string& rule = a131_rule) {
    Json list = Json::array();
    for (const auto& [w, gamma] : leaves) list.push_back({{"region", {{"w", w}}}, {"gamma", gamma}});
    return nonuniform(4, catmull_rom_1, rule, statement, {{"w", region}}, "certified", "N3", {{"leaves", list}});
  };
  expect_valid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/4]", "1/64"}}));
  expect_valid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/5)", "1/64"}, {"[1/5, 1/4]", "64"}}));
  expect_valid(on("not C1", "(13/100, 1/4)", {{"(13/100, 1/5)", "1/64"}, {"1/5", "1/50"}, {"(1/5, 1/4)", "64"}}));
  expect_valid(on("not C7", "[13/100, 1/4]", {{"[13/100, 1/4]", "1/64"}}));
  expect_valid(n3(a131_rule, "not C1", "[13/100, 1/4]", "certified", "[13/100, 1/4]", "1/64"));
  const auto result = check(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/5)", "1/64"}, {"[1/5, 1/4]", "64"}}));
  EXPECT_EQ(result.statement,
            "certified: test is not C1 over some knot sequence for w in [13/100, 1/4] (theorem N3, 2 leaves)");
  // True claims elsewhere, wrong ratios, leaves that do not cover or reach too far.
  for (const char* region : {"[12/100, 1/4]", "(1/8, 1/4]", "[1/8, 1/4]", "[1/100, 1/4]"})
    for (const char* gamma : {"1/64", "1/1000", "1", "50"})
      expect_invalid(on("not C1", region, {{region, gamma}}), "eigenvalue");
  expect_invalid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/4]", "1"}}), "eigenvalue");
  expect_invalid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/5)", "1/64"}, {"(1/5, 1/4]", "64"}}), "covering");
  expect_invalid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/5]", "1/64"}}), "covering");
  expect_invalid(on("not C1", "[13/100, 1/5]", {{"[13/100, 1/4]", "1/64"}}), "covering");
  expect_invalid(on("not C0", "[13/100, 1/4]", {{"[13/100, 1/4]", "1/64"}}), "eigenvalue");
  expect_invalid(on("not C1", "[13/100, 1/4]", {}), "proof");
  expect_invalid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/4]", "0"}}), "proof");
  // Denominators on the leaf.
  const std::string pole = "0/(w-1/5)*at(c,1/2) + " + std::string(a131_rule);
  expect_invalid(on("not C1", "[13/100, 1/4]", {{"[13/100, 1/4]", "1/64"}}, pole), "denominator");
  expect_valid(on("not C1", "(1/5, 1/4]", {{"(1/5, 1/4]", "1/64"}}, pole));
  const std::string cancelled = std::string("(w-1/5)/(w-1/5)*(") + a131_rule + ")";
  expect_valid(on("not C1", "(1/5, 1/4]", {{"(1/5, 1/4]", "1/64"}}, cancelled));
  expect_invalid(on("not C1", "[1/5, 1/4]", {{"[1/5, 1/4]", "1/64"}}, cancelled), "denominator");
}

// An eigenvalue 2^-k, k <= m, at one parameter value only is that of a smooth limit: it refutes nothing, and the leaf is
// rejected where it is neither nowhere nor everywhere an eigenvalue.
TEST(N3, EigenvaluesThatComeAndGo) {
  // Two points with weights u, 1-u: linear functions are reproduced for u = 1/2 only.
  const auto two_points = [](const std::string& region, const std::string& statement) {
    auto json = nonuniform(2, Let{}, "(1-u)*at(f(1,0),0) + u*at(f(1,0),1)", statement, {{"u", region}}, "certified",
                           "N3", {{"region", {{"u", region}}}, {"gamma", "1"}});
    return json;
  };
  // Its eigenvalues are 1, u and 1-u, at every ratio.
  expect_valid(two_points("3/4", "not C1"));
  expect_valid(two_points("[3/5, 3/4]", "not C1"));
  expect_valid(two_points("[1/4, 2/5]", "not C1"));
  expect_valid(two_points("1/2", "not C1"));  // 1/2 twice
  expect_invalid(two_points("[2/5, 3/5]", "not C1"), "eigenvalue");
  expect_invalid(two_points("[1/2, 3/5]", "not C1"), "eigenvalue");
  expect_valid(two_points("(1/2, 3/5]", "not C1"));
  expect_invalid(two_points("[3/5, 3/4]", "not C0"), "eigenvalue");
  expect_invalid(two_points("1/2", "not C0"), "eigenvalue");
  expect_valid(two_points("3/2", "not C0"));
  expect_valid(two_points("[3/2, 2]", "not C0"));
  expect_valid(two_points("[-2, -3/2]", "not C0"));
}

// Everywhere a second eigenvalue 1/2.
TEST(N3, DoubleEigenvaluesOnRegions) {
  expect_valid(nonuniform(2, Let{}, "at(f(1,0),1/2)", "not C1", {{"u", "[0, 1]"}}, "certified", "N3",
                          {{"region", {{"u", "[0, 1]"}}}, {"gamma", "2/3"}}));
  expect_invalid(nonuniform(2, Let{}, "at(f(1,0),1/2)", "not C0", {{"u", "[0, 1]"}}, "certified", "N3",
                            {{"region", {{"u", "[0, 1]"}}}, {"gamma", "2/3"}}),
                 "eigenvalue");
}
