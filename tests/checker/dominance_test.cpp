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

namespace {

Json repeated(const std::string& base, const Factors& factors, const std::vector<int>& multiplicities) {
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) pieces.push_back({static_cast<int>(k), "rouche"});
  pieces.push_back({static_cast<int>(factors.size()) - 1, "separation"});
  return n1(6, Let{}, base, "C2", Json::object(), 6, factors, multiplicities, pieces);
}

/// C^1 of the four-point scheme from cubic interpolants at one w, the cubic factor by separation.
Json separated(const std::string& w, const Json& curves, const Json& distances, const std::string& gamma = "(0, 1]") {
  auto json = n1(4, Let{}, a131_rule, "C1", {{"w", w}}, 4, {{"w", "1"}, a131_factor}, {2, 1},
                 {{0, "rouche"}, {1, "separation", gamma}});
  json["proof"]["dominance"][1]["curves"] = curves;
  if (!distances.is_null()) json["proof"]["dominance"][1]["distances"] = distances;
  return json;
}

}  // namespace
