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
      "w = 13/100 (theorem N3)");
  // The eigenvalue 2w, or the double eigenvalue -+ sqrt of 2 lambda^2 - lambda + 2w, or a second 1/2.
  expect_valid(n3("at(c,1/2)", "C1", "1/4", "refuted", "1/4", "1"));
  expect_valid(n3("at(c,1/2)", "C1", "3/10", "refuted", "3/10", "1/3"));
  // No refutation where the scheme is C^1, for small gamma or equal intervals only.
  for (const char* gamma : {"1/5", "1", "5"}) {
    expect_invalid(n3(a131_rule, "C1", "13/100", "refuted", "13/100", gamma), "eigenvalue");
    expect_invalid(n3("at(c,1/2)", "C1", "13/100", "refuted", "13/100", gamma), "eigenvalue");
  }
  expect_invalid(n3(a131_rule, "C1", "[1/100, 12/100]", "refuted", "13/100", "1/50"), "covering");
  expect_invalid(n3(a131_rule, "not C1", "[12/100, 13/100]", "certified", "13/100", "1/50"), "claim");
  expect_invalid(n3(a131_rule, "C1", "13/100", "certified", "13/100", "1/50"), "claim");
  expect_invalid(n3(a131_rule, "not C1", "13/100", "refuted", "13/100", "1/50"), "claim");
  expect_invalid(n3(a131_rule, "C1", "13/100", "refuted", "[1/10, 13/100]", "1/50"), "covering proof");
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
