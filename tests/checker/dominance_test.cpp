#include "tests/checker/nonuniform.hpp"

using namespace limes::test;

TEST(Dominance, CutsOfTheCircleTest) {
  auto json = a253("3/256", {{0, "rouche"}, {1, "rouche"}, {2, "circle"}});
  for (const Json& cuts : std::vector<Json>{Json::array(), {"0"}, {"-1/2", "0", "1/3"}}) {
    json["proof"]["dominance"][2]["c"] = cuts;
    expect_valid(json);
  }
  for (const Json& cuts : std::vector<Json>{{"1"}, {"-1"}, {"0", "0"}, {"1/2", "0"}, {"2"}, {"-2"}, {"-1/2", "3/2"}}) {
    json["proof"]["dominance"][2]["c"] = cuts;
    expect_invalid(json, "dominance");
  }
  json["proof"]["dominance"][2]["c"] = {"x"};
  expect_invalid(json, "proof");
  json["proof"]["dominance"][2]["c"] = {"0"};
  json["proof"]["dominance"][2]["test"] = "rouche";
  expect_invalid(json, "proof");
}

TEST(Dominance, DominanceMustCover) {
  const auto with = [](const std::vector<Piece>& tests) { return cr1("[1/16, 1/8]", 4, tests); };
  expect_invalid(with({{0, "rouche"}, {1, "rouche"}}), "covering");
  expect_invalid(with({{0, "rouche"}, {2, "boundary"}, {2, "boundary"}}), "covering");
  expect_invalid(with({}), "covering");
  for (const char* gamma : {"(0, 1)", "[0, 1]", "(0, 2]", "[1/1000, 1]", "1", "(-1, 1]", "0", "2", "(0, 1/2]"}) {
    expect_invalid(with({{0, "rouche"}, {1, "rouche"}, {2, "boundary", gamma}}), "covering");
    expect_invalid(with({{0, "rouche", gamma}, {1, "rouche"}, {2, "boundary"}}), "covering");
  }
  expect_invalid(with({{0, "rouche"}, {1, "rouche"}, {2, "boundary", "(0, 1/2)"}, {2, "boundary", "(1/2, 1]"}}),
                 "covering");
  expect_valid(with({{0, "rouche"},
                     {1, "rouche"},
                     {2, "boundary", "(0, 1/2)"},
                     {2, "boundary", "1/2"},
                     {2, "boundary", "(1/2, 1]"}}));
  expect_invalid(with({{0, "rouche"}, {1, "rouche"}, {2, "rouche"}}), "dominance");  // equality on the circle
  for (const char* w : {"[1/16, 1/9]", "[1/16, 1/7]", "(1/16, 1/8]", "1/8"}) {
    auto json = cr1();
    json["proof"]["dominance"][2]["region"]["w"] = w;
    expect_invalid(json, "covering");
    json = cr1();
    json["proof"]["uniform"]["leaves"][0]["region"]["w"] = w;
    expect_invalid(json, "covering");
  }
}

TEST(Dominance, FactorsThatVanishSomewhere) {
  // f and the leading coefficient have the common factor w - 1/12 or 1 - gamma: there nothing is shown about the roots.
  for (const std::string content : {"(12*w-1)*", "(1-gamma)*", "(2*gamma-1)*", "(w-1/16)*"}) {
    for (const std::string test : {"rouche", "boundary", "circle"}) {
      auto json = cr1();
      for (auto& d : json["proof"]["factors"][1]) d = content + "(" + d.get<std::string>() + ")";
      json["proof"]["dominance"][1]["test"] = test;
      expect_invalid(json, "dominance");
    }
  }
  // At excluded faces it is divided out.
  for (const std::string test : {"rouche", "boundary", "circle"}) {
    auto json = cr1("(1/16, 1/8)");
    for (auto& d : json["proof"]["factors"][1]) d = "gamma^2*(1/16-w)*(1/8-w)^3*(" + d.get<std::string>() + ")";
    json["proof"]["dominance"][1]["test"] = test;
    expect_valid(json);
    json["proof"]["dominance"].push_back(json["proof"]["dominance"][1]);
    json["proof"]["dominance"][1]["region"]["gamma"] = "(0, 1/2]";
    json["proof"]["dominance"][3]["region"]["gamma"] = "[1/2, 1]";
    expect_valid(json);
    for (auto& d : json["proof"]["factors"][1]) d = "(2*gamma-1)*(" + d.get<std::string>() + ")";
    expect_invalid(json, "dominance");
  }
}

// ---- separation (Karciauskas & Peters 2013, Props. 2 and 5) ------------------------------------------------------------

TEST(Separation, AllRootsReal) {
  const Json none;
  expect_valid(separated("1/20", {"0", "3/25", "13/50", "1/2"}, none));
  expect_valid(separated("1/20", {"0", "3/25 - gamma/100", "13/50", "1/2"}, none));
  expect_valid(separated("1/20", {"-1/2", "0", "w+7/100", "13/50", "2/5+w"}, none));  // one curve more than needed
  expect_valid(separated("1/20", {"0", "3/25", "13/50"}, none));  // the third root is real, and not >= 1/2
  expect_valid(separated("1/20", {"-gamma/2", "3/25", "13/50", "1/2-gamma^2/10"}, none));
  // Not in order, at one place or everywhere; outside; through a root; too few.
  expect_invalid(separated("1/20", {"3/25", "0", "13/50", "1/2"}, none), "dominance");
  expect_invalid(separated("1/20", {"0", "3/25", "3/25", "13/50", "1/2"}, none), "dominance");
  expect_invalid(separated("1/20", {"0", "3/25", "13/50", "13/50+gamma*(gamma-1/2)", "1/2"}, none), "dominance");
  expect_invalid(separated("1/20", {"0", "3/25", "13/50", "3/5"}, none), "dominance");
  expect_invalid(separated("1/20", {"-3/5", "3/25", "13/50", "1/2"}, none), "dominance");
  expect_invalid(separated("1/20", {"0", "1/10", "13/50", "1/2"}, none), "dominance");
  expect_invalid(separated("1/20", {"0", "3/25"}, none), "dominance");
  expect_invalid(separated("1/20", Json::array(), none), "dominance");
  expect_invalid(separated("1/20", {"0", "3/25", "13/50", "1/2"}, {"1/10"}), "dominance");
  expect_invalid(separated("1/20", {"0", "3/25", "13/50", "1/2"}, {"1/10", "1/10", "1/10"}), "dominance");
}

TEST(Separation, AConjugatePair) {
  // A real root between 1/5 and 2/5, and |d_0| = d_3 / 50, rho = 1/2: the distance must exceed 2/25.
  for (const char* distance : {"1/10", "1/12", "3/36"}) expect_valid(separated("1/10", {"1/10", "1/2"}, {distance}));
  expect_valid(separated("1/10", {"1/4-gamma/8", "1/2"}, {"1/8"}));
  expect_invalid(separated("1/10", {"1/10", "1/2"}, {"2/25"}), "dominance");
  expect_invalid(separated("1/10", {"1/10", "1/2"}, {"1/5"}), "dominance");
  expect_invalid(separated("1/10", {"1/4-gamma/8", "1/2"}, {"1/5"}), "dominance");
  expect_invalid(separated("1/10", {"0", "1/2"}, {"1/10"}), "dominance");
  expect_invalid(separated("1/10", {"-1/2", "1/2"}, {"1/10"}), "dominance");
  expect_invalid(separated("1/10", {"1/10", "1/2"}, Json()), "dominance");
  expect_invalid(separated("1/10", {"1/10", "1/2"}, {"1/10", "1/10"}), "dominance");
  expect_invalid(separated("1/10", {"1/10", "1/2"}, {"-1/10"}), "dominance");
  expect_invalid(separated("1/10", {"1/10", "1/2"}, {"0"}), "dominance");
  expect_invalid(separated("1/10", {"-1/2", "-1/10"}, {"1/10"}), "dominance");
}

TEST(Separation, WhatIsFalseIsNotProved) {
  // At w = 13/100 a real root exceeds 1/2 for small ratios; at w = 1/4 and any ratio a pair is outside.
  for (const Json& curves : std::vector<Json>{{"1/10", "1/2"}, {"1/10", "2/5"}, {"1/10", "2/5", "1/2"}, Json::array()})
    for (const Json& distances : std::vector<Json>{Json(), {"1/10"}, {"1/1000"}})
      for (const char* gamma : {"(0, 1]", "(0, 1/1000]"})
        expect_invalid(separated("13/100", curves, distances, gamma), "dominance covering");
  // The leading coefficient vanishes at gamma = 1/2 (so would the factor, or a root be infinite).
  auto json = separated("1/10", {"1/10", "1/2"}, {"1/10"});
  for (auto& d : json["proof"]["factors"][1]) d = "(2*gamma-1)*(" + d.get<std::string>() + ")";
  expect_invalid(json, "dominance");
}

TEST(Separation, TheForm) {
  const auto base = separated("1/10", {"1/10", "1/2"}, {"1/10"});
  const auto change = [&](const char* key, const Json& value, const std::string& steps) {
    auto json = base;
    json["proof"]["dominance"][1][key] = value;
    expect_invalid(json, steps);
  };
  change("curves", "1/10", "proof");
  change("curves", {"1/10", 1}, "proof");
  change("curves", {"1/(1+gamma)", "1/2"}, "proof");
  change("curves", {"1/10", "v"}, "proof");
  change("distances", "1/10", "proof");
  change("distances", {"w"}, "proof");
  change("c", {"0"}, "proof");
  for (const char* test : {"rouche", "boundary", "circle"}) change("test", test, "proof");
  change("curves", Json(201, "1/10"), "proof");
  change("curves", {"1/10 + gamma^1000*w^1000", "1/2"}, "limits dominance");
  change("curves", {"1/10 + " + std::string(9000, '7') + "^600", "1/2"}, "limits dominance");
}

// The factor times a function of gamma that is positive, by its Bernstein coefficients on the halves of (0, 1] only.
TEST(Dominance, ABoxOneBisectionTooWide) {
  for (const std::string test : {"rouche", "boundary", "circle"}) {
    const auto make = [&](const std::vector<Piece>& pieces) {
      auto json = cr1("[1/16, 1/8]", 4, pieces);
      for (auto& d : json["proof"]["factors"][1]) d = "(gamma^2-gamma+3/10)*(" + d.get<std::string>() + ")";
      return json;
    };
    expect_valid(make({{0, "rouche"}, {1, test, "(0, 1/2]"}, {1, test, "[1/2, 1]"}, {2, "boundary"}}));
    expect_invalid(make({{0, "rouche"}, {1, test, "(0, 1/2]"}, {2, "boundary"}}), "covering");
    // F is of even degree in the factor, and no statement about the factor's sign.
    if (test != "circle") expect_invalid(make({{0, "rouche"}, {1, test, "(0, 1]"}, {2, "boundary"}}), "dominance");
  }
}
