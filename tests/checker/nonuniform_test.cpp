#include "tests/checker/certificates.hpp"

#include <array>

using namespace limes::test;

// Certificates about non-uniform schemes (Karciauskas & Peters 2013), made here from templates; the factors are the
// paper's, or were computed with PARI.
namespace {

using Let = std::vector<std::array<std::string, 2>>;
using Factors = std::vector<std::vector<std::string>>;

const Let catmull_rom_1{{"cr1", "hermite(1, f(2,0), f(2,1))"}, {"c", "tension(16*w, cr1)"}};
const Let catmull_rom_2{{"cr1", "hermite(1, f(2,0), f(2,1))"}, {"cr2", "join(2, degree(4, cr1))"}};
const char* const cr2_rule = "(576*w-2)*at(cr2,1/2) + (3-576*w)*dot([1/12,1/6,1/2,1/6,1/12], cr2)";
const char* const a131_rule = "16*w*at(f(3,0),1/2) + (1-16*w)*at(f(1,0),1/2)";
const char* const a253_rule = "256/3*w*at(f(5,0),1/2) + (1-256/3*w)*at(f(3,0),1/2)";

const std::vector<std::string> a131_factor{"-(8*gamma^2+20*gamma+8)*w^2",
                                           "-32*(gamma-1)^2*w^2 + (10*gamma^2+16*gamma+10)*w",
                                           "-(8*gamma^2+20*gamma+8)*w - (2*gamma^2+5*gamma+2)", "4*gamma^2+10*gamma+4"};
const std::vector<std::string> a253_factor{
    "(50331648*gamma^6+448790528*gamma^5+1421869056*gamma^4+2056257536*gamma^3+1421869056*gamma^2"
    "+448790528*gamma+50331648)*w^4",
    "(805306368*gamma^6+2785017856*gamma^5-352321536*gamma^4-6476005376*gamma^3-352321536*gamma^2"
    "+2785017856*gamma+805306368)*w^4+(51904512*gamma^6+245366784*gamma^5+497811456*gamma^4"
    "+621674496*gamma^3+497811456*gamma^2+245366784*gamma+51904512)*w^3+(-921600*gamma^6"
    "-4927488*gamma^5-10626048*gamma^4-13129728*gamma^3-10626048*gamma^2-4927488*gamma-921600)*w^2",
    "(830472192*gamma^6+2699034624*gamma^5+839909376*gamma^4-2840592384*gamma^3+839909376*gamma^2"
    "+2699034624*gamma+830472192)*w^3+(-7372800*gamma^6-34873344*gamma^5-104730624*gamma^4"
    "-166846464*gamma^3-104730624*gamma^2-34873344*gamma-7372800)*w^2+(-117504*gamma^6"
    "-866880*gamma^5-2091744*gamma^4-2487744*gamma^3-2091744*gamma^2-866880*gamma-117504)*w"
    "+(648*gamma^6+6318*gamma^5+21771*gamma^4+32526*gamma^3+21771*gamma^2+6318*gamma+648)",
    "(117964800*gamma^6+627965952*gamma^5+520814592*gamma^4-321650688*gamma^3+520814592*gamma^2"
    "+627965952*gamma+117964800)*w^2+(-2101248*gamma^6-15289344*gamma^5-36168192*gamma^4"
    "-42642432*gamma^3-36168192*gamma^2-15289344*gamma-2101248)*w+(18144*gamma^6+176904*gamma^5"
    "+609588*gamma^4+910728*gamma^3+609588*gamma^2+176904*gamma+18144)",
    "(-3538944*gamma^6-22708224*gamma^5-43204608*gamma^4-45416448*gamma^3-43204608*gamma^2"
    "-22708224*gamma-3538944)*w+(82944*gamma^6+808704*gamma^5+2786688*gamma^4+4163328*gamma^3"
    "+2786688*gamma^2+808704*gamma+82944)",
    "(-663552*gamma^6-6469632*gamma^5-22293504*gamma^4-33306624*gamma^3-22293504*gamma^2"
    "-6469632*gamma-663552)"};

Json nonuniform(int points, const Let& let, const std::string& rule, const std::string& statement, const Json& region,
                const std::string& verdict, const std::string& theorem, const Json& proof) {
  std::vector<std::string> parameters;
  for (const auto& [name, interval] : region.items()) parameters.push_back(name);
  return {{"format", "limes-certificate"},
          {"version", 1},
          {"scheme",
           {{"kind", "nonuniform"},
            {"name", "test"},
            {"parameters", parameters},
            {"points", points},
            {"let", let},
            {"rule", rule}}},
          {"claim", {{"statement", statement}, {"region", region}}},
          {"verdict", verdict},
          {"theorem", theorem},
          {"proof", proof}};
}

struct Piece {
  int factor;
  std::string test, gamma = "(0, 1]";
};

/// C^m certified by N1, with one uniform leaf and the tests on pieces of gamma.
Json n1(int points, const Let& let, const std::string& rule, const std::string& statement, const Json& region,
        int level, const Factors& factors, const std::vector<int>& multiplicities, const std::vector<Piece>& tests) {
  Json dominance = Json::array();
  for (const auto& [factor, test, gamma] : tests) {
    Json leaf = region;
    leaf["gamma"] = gamma;
    dominance.push_back({{"factor", factor}, {"region", leaf}, {"test", test}});
  }
  return nonuniform(points, let, rule, statement, region, "certified", "N1",
                    {{"uniform", {{"leaves", {{{"region", region}, {"level", level}}}}}},
                     {"factors", factors},
                     {"multiplicities", multiplicities},
                     {"dominance", dominance}});
}

Json cr1(const std::string& region = "[1/16, 1/8]", int level = 4,
         const std::vector<Piece>& tests = {{0, "rouche"}, {1, "rouche"}, {2, "boundary"}}) {
  return n1(4, catmull_rom_1, "at(c,1/2)", "C1", {{"w", region}}, level,
            {{"w", "1"}, {"-2*w", "1"}, {"2*w", "-1", "2"}}, {2, 1, 1}, tests);
}

Json a253(const std::string& region, const std::vector<Piece>& tests) {
  return n1(6, Let{}, a253_rule, "C2", {{"w", region}}, 6, {{"-w", "1"}, {"-1/8", "1"}, a253_factor}, {2, 1, 1}, tests);
}

Json n3(const std::string& rule, const std::string& statement, const std::string& region, const std::string& verdict,
        const std::string& w, const std::string& gamma) {
  return nonuniform(4, catmull_rom_1, rule, statement, {{"w", region}}, verdict, "N3",
                    {{"region", {{"w", w}}}, {"gamma", gamma}});
}

}  // namespace

// ---- what is true ---------------------------------------------------------------------------------------------------

TEST(Nonuniform, CatmullRom1) {
  expect_valid(cr1());
  expect_valid(cr1("[1/1000, 37/200]", 13));
  expect_valid(cr1("1/16", 4));
  expect_valid(cr1("[1/16, 1/8]", 4,
                   {{0, "circle"}, {1, "boundary"}, {2, "boundary", "(0, 1/3]"}, {2, "boundary", "(1/3, 1]"}}));
  expect_valid(n1(4, catmull_rom_1, "at(c,1/2)", "C0", {{"w", "1/16"}}, 2,
                  {{"w", "1"}, {"-2*w", "1"}, {"2*w", "-1", "2"}, {"-1", "2"}}, {2, 1, 1, 1},
                  {{0, "rouche"}, {1, "rouche"}, {2, "rouche"}, {3, "rouche"}}));
  const auto result = check(cr1());
  EXPECT_EQ(result.statement,
            "certified: test is C1 over every knot sequence for w in [1/16, 1/8] (theorem N1, 1 uniform leaf, 3 "
            "dominance leaves)");
}

TEST(Nonuniform, DefinitionsInAnyOrder) {
  auto json = cr1();
  json["scheme"]["let"] = Let{
      {"c", "(0*d) + tension(omega, cr1)"}, {"cr1", "hermite(1, f(2,0), f(2,1))"}, {"d", "cr1-cr1"}, {"omega", "16*w"}};
  expect_valid(json);
}

TEST(Nonuniform, PiecewiseLinear) {
  // The eigenvalues of L are 1, 1/2, 1/2.
  const auto linear = [](const std::string& statement, const Factors& factors, const std::vector<int>& multiplicities,
                         const std::vector<Piece>& pieces) {
    return n1(2, Let{}, "at(f(1,0),1/2)", statement, Json::object(), 1, factors, multiplicities, pieces);
  };
  expect_valid(linear("C0", {{"-1", "2"}}, {2}, {{0, "rouche"}}));
  expect_invalid(linear("C1", {{"-1", "2"}}, {1}, {{0, "rouche"}}), "contractivity");
  expect_invalid(linear("C2", {}, {}, {}), "contractivity factor");
  const auto rough = [](const std::string& statement) {
    return nonuniform(2, Let{}, "at(f(1,0),1/2)", statement, Json::object(), "certified", "N3",
                      {{"region", Json::object()}, {"gamma", "2/3"}});
  };
  expect_valid(rough("not C1"));
  expect_valid(rough("not C7"));
  expect_invalid(rough("not C0"), "eigenvalue");
}

TEST(Nonuniform, CatmullRom1ByCoefficients) {
  auto json = cr1();
  json["scheme"].erase("let");
  json["scheme"].erase("rule");
  json["scheme"]["coefficients"] = {"-2*b1^2/(1+b1)*w", "(1+b2+4*(b1+b1*b2-1)*w)/(2*(1+b2))",
                                    "(1+1/b1+4*(1/b2+1/(b1*b2)-1)*w)/(2*(1+1/b1))", "-2*(1/b2)^2/(1+1/b2)*w"};
  expect_valid(json);
  const auto replace = [&](std::size_t j, const std::string& text, const std::string& steps) {
    auto changed = json;
    changed["scheme"]["coefficients"][j] = text;
    expect_invalid(changed, steps);
  };
  replace(0, "-2*b1^2/(1+b1)*w + 0/(b1-b2)", "scheme");
  replace(0, "-2*b1^2/(1+b1)*w*(b1-2)/(b1-2)", "scheme");
  replace(0, "-2*b1^2/(1+b1)*w + 0/(w+b1)", "scheme");
  replace(0, "-2*b1^2/(1+b1)*w + 0/(w-1/10)", "denominator");
  replace(0, "-2*b1^2/(1+b1)*w*gamma", "scheme");
  replace(0, "-2*b1^2/(1+b1)*w*b3", "scheme");
  replace(0, "-2*b1^2/(1+b2)*w", "eigenvectors symmetry");
  replace(0, "-b1*w", "eigenvectors symmetry");
  json["scheme"]["coefficients"].push_back("0");
  expect_invalid(json, "scheme");
}

TEST(Nonuniform, CatmullRom2) {
  const Factors factors{
      {"-1/8", "1"}, {"-w", "1"}, {"-256*w^2", "1-32*w", "16"}, {"256*w^2", "64*w-1", "256*w-12", "64"}};
  const auto make = [&](const std::string& region, const std::string& statement) {
    return n1(6, catmull_rom_2, cr2_rule, statement, {{"w", region}}, 9, factors, {1, 2, 1, 1},
              {{0, "rouche"}, {1, "rouche"}, {2, "boundary"}, {3, "boundary"}});
  };
  expect_valid(make("[1/250, 3/100]", "C2"));
  expect_valid(make("1/192", "C2"));
  expect_invalid(make("[1/250, 3/100]", "C1"), "characteristic");
  expect_invalid(make("[1/250, 3/100]", "C3"), "factor contractivity");
}

TEST(Nonuniform, Averages) {
  for (const std::string test : {"rouche", "boundary", "circle"}) {
    for (const std::string region : {"1/100", "3/256", "[1/100, 11/1000]"})
      expect_valid(a253(region, {{0, "rouche"}, {1, "rouche"}, {2, test, "(0, 1/4]"}, {2, test, "[1/4, 1]"}}));
  }
  // The factors may be given at the point instead.
  auto json = a253("3/256", {{0, "rouche"}, {1, "rouche"}, {2, "rouche"}});
  json["proof"]["factors"][0][0] = "-3/256";
  expect_valid(json);
  // A common factor in gamma and w that has no zero on the region proves nothing wrong.
  for (auto& d : json["proof"]["factors"][2]) d = "(1+gamma*w)*(" + d.get<std::string>() + ")";
  expect_valid(json);
  expect_valid(n1(4, Let{}, a131_rule, "C1", {{"w", "[1/20, 1/10]"}}, 4, {{"w", "1"}, a131_factor}, {2, 1},
                  {{0, "rouche"}, {1, "boundary", "(0, 1/2]"}, {1, "boundary", "(1/2, 1]"}}));
}

TEST(Nonuniform, CutsOfTheCircleTest) {
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

TEST(Nonuniform, Refutations) {
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

TEST(Nonuniform, RefutationsForEqualIntervals) {
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

// ---- what is false, or without a proof ------------------------------------------------------------------------------

TEST(Nonuniform, OneOrderTooHigh) {
  auto json = cr1();
  json["claim"]["statement"] = "C2";
  expect_invalid(json, "factor contractivity");
  // C^3 for equal intervals at this w (Weissman), but an eigenvalue exceeds 1/8 for small gamma.
  for (const std::string test : {"rouche", "boundary", "circle"}) {
    json = n1(6, Let{}, a253_rule, "C3", {{"w", "141/10000"}}, 9, {{"-w", "1"}, a253_factor}, {2, 1},
              {{0, "rouche"}, {1, test, "(0, 1/10]"}, {1, test, "[1/10, 1]"}});
    expect_invalid(json, "dominance");
  }
}

TEST(Nonuniform, RegionsThatReachTooFar) {
  for (const char* region : {"[1/16, 1/5]", "[0, 1/8]", "0", "1/4", "[1/16, 1/4]"})
    expect_invalid(cr1(region, 8), "contractivity");
  // C^1 for equal intervals, but not for small gamma.
  for (const std::string test : {"rouche", "boundary", "circle"})
    for (const char* region : {"[1/10, 13/100]", "13/100"})
      expect_invalid(n1(4, Let{}, a131_rule, "C1", {{"w", region}}, 6, {{"w", "1"}, a131_factor}, {2, 1},
                        {{0, "rouche"}, {1, test, "(0, 1/32]"}, {1, test, "(1/32, 1/2]"}, {1, test, "(1/2, 1]"}}),
                     "dominance");
}

TEST(Nonuniform, FactorsThatAreForgedOrDropped) {
  const auto base = a253("[1/100, 11/1000]", {{0, "rouche"}, {1, "rouche"}, {2, "boundary"}});
  expect_valid(base);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t s = 0; s < base["proof"]["factors"][k].size(); ++s) {
      for (const char* change : {" + 1/1000000", " + gamma*(1-gamma)*w", "*2", " + w - w + gamma^9"}) {
        auto json = base;
        auto& d = json["proof"]["factors"][k][s];
        d = d.get<std::string>() + change;
        expect_invalid(json, "characteristic");
      }
    }
    auto json = base;
    json["proof"]["factors"].erase(k);
    json["proof"]["multiplicities"].erase(k);
    json["proof"]["dominance"].erase(k);
    for (auto& leaf : json["proof"]["dominance"])
      if (leaf["factor"] > k) leaf["factor"] = leaf["factor"].get<std::size_t>() - 1;
    expect_invalid(json, "characteristic");
    json = base;
    json["proof"]["factors"][k].push_back("0");
    expect_invalid(json, "characteristic");
    json["proof"]["factors"][k] = {"0", "0", "0"};
    expect_invalid(json, "characteristic");
    json["proof"]["factors"][k] = {"1"};
    expect_invalid(json, "proof");
    json["proof"]["factors"][k] = Json::array();
    expect_invalid(json, "proof");
  }
  for (const Json& multiplicities : std::vector<Json>{{1, 2, 1}, {2, 2, 1}, {1, 1, 1}, {7, 1, 1}})
    expect_invalid(
        [&] {
          auto json = base;
          json["proof"]["multiplicities"] = multiplicities;
          return json;
        }(),
        "characteristic");
  for (const Json& multiplicities :
       std::vector<Json>{{0, 1, 1}, {-2, 1, 1}, {2, 1}, {2, 1, 1, 1}, {2.0, 1, 1}, {12, 1, 1}})
    expect_invalid(
        [&] {
          auto json = base;
          json["proof"]["multiplicities"] = multiplicities;
          return json;
        }(),
        "proof");
}

TEST(Nonuniform, ASecondEigenvalueOneHalf) {
  // A claim of C^0 has lambda - 1/2 among its factors; that must not do for C^1, nor take the place of another one.
  for (const std::string test : {"rouche", "boundary", "circle"}) {
    auto json = cr1("[1/16, 1/8]", 4);
    json["proof"]["factors"][1] = {"-1/2", "1"};
    json["proof"]["dominance"][1]["test"] = test;
    expect_invalid(json, "characteristic");
    json = n1(4, catmull_rom_1, "at(c,1/2)", "C0", {{"w", "1/16"}}, 2,
              {{"w", "1"}, {"-2*w", "1"}, {"2*w", "-1", "2"}, {"-1", "2"}}, {2, 1, 1, 1},
              {{0, "rouche"}, {1, "rouche"}, {2, "rouche"}, {3, test}});
    expect_valid(json);
    json["claim"]["statement"] = "C1";
    json["proof"]["uniform"]["leaves"][0]["level"] = 4;
    expect_invalid(json, "characteristic");
    json["proof"]["factors"].erase(1);
    json["proof"]["multiplicities"] = {2, 1, 1};
    json["proof"]["dominance"].erase(1);
    json["proof"]["dominance"][1]["factor"] = 1;
    json["proof"]["dominance"][2]["factor"] = 2;
    expect_invalid(json, "characteristic");
  }
}

TEST(Nonuniform, DominanceMustCover) {
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

TEST(Nonuniform, FactorsThatVanishSomewhere) {
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

TEST(Nonuniform, RulesThatAreAltered) {
  const auto base = cr1();
  const auto with = [&](const std::string& rule) {
    auto json = base;
    json["scheme"]["rule"] = rule;
    return json;
  };
  expect_valid(with("at(c,1/4)/2 + at(c,3/4)/2 + at(c,1/2) - at(c,1/4)/2 - at(c,3/4)/2"));
  expect_invalid(with("at(cr1,1/2)"), "characteristic");
  expect_invalid(with(a131_rule), "characteristic");
  expect_invalid(with("at(c,1/3)"), "sum factor contractivity eigenvectors symmetry");
  expect_invalid(with("2*at(c,1/2)"), "sum factor contractivity");
  expect_invalid(with("at(c,1/2)*w/w*0"), "sum factor contractivity");
  auto json = base;
  json["scheme"]["let"][1][1] = "tension(8*w, cr1)";
  expect_invalid(json, "contractivity characteristic");
  json = base;
  json["scheme"]["points"] = 6;
  expect_invalid(json, "characteristic");
  // An unsymmetric rule: the uniform scheme is C^1, and (0, 1] is not enough.
  json = n1(4, Let{}, "at(f(2,0),1/2)", "C1", Json::object(), 6, {{"0", "1"}}, {5}, {{0, "rouche"}});
  expect_invalid(json, "symmetry");
  // Polynomials of degree m only for equal intervals.
  json = n1(4, Let{}, "(at(f(0,0),1/2) + at(f(0,1),1/2))*9/16 - (at(f(0,-1),1/2) + at(f(0,2),1/2))/16", "C1",
            Json::object(), 4, {{"0", "1"}}, {5}, {{0, "rouche"}});
  expect_invalid(json, "eigenvectors");
  json["claim"]["statement"] = "C0";
  json["proof"]["multiplicities"] = {6};
  expect_invalid(json, "characteristic");
}

TEST(Nonuniform, DivisorsThatVanish) {
  const auto with = [](const std::string& region, const std::string& rule) {
    auto json = cr1(region);
    json["scheme"]["rule"] = rule;
    return json;
  };
  for (const char* rule :
       {"at(c,1/2)*(w-1/12)/(w-1/12)", "at(c,1/2) + 0/(w-1/12)*at(cr1,1/2)", "at(c,1/2)*(1/(1/(w-1/12)))^0",
        "at(c,1/2) + at(cr1,1/3)*0/(w-1/8)", "at(c,1/2) + dot([0,0/(16*w-1),0,0], cr1)"}) {
    expect_invalid(with("[1/16, 1/8]", rule), "denominator");
  }
  expect_invalid(with("1/12", "at(c,1/2)*(w-1/12)/(w-1/12)"), "denominator");
  expect_valid(with("(1/12, 1/8]", "at(c,1/2)*(w-1/12)/(w-1/12)"));
  auto json = cr1();
  json["scheme"]["let"].push_back({"unused", "1/(10*w-1)"});
  expect_invalid(json, "denominator");
}

TEST(Nonuniform, RulesOfTheWrongForm) {
  const auto reject = [](const std::string& rule, const std::string& steps = "scheme") {
    auto json = cr1();
    json["scheme"]["rule"] = rule;
    expect_invalid(json, steps);
  };
  for (const char* rule : {"",
                           "1",
                           "w",
                           "c",
                           "at(c)",
                           "at(c,1/2,1)",
                           "at(1/2,c)",
                           "at(at(c,1/2),1/2)",
                           "at(c,w)",
                           "at(c,1/2) + 1",
                           "at(c,1/2) + c",
                           "at(c,1/2)*at(c,1/2)",
                           "1/at(c,1/2)",
                           "at(c,1/2)/c",
                           "at(c,1/2)^2",
                           "at(c,1/2)/0",
                           "at(c,1/2)/(w-w)",
                           "at(d,1/2)",
                           "at(c,1/2",
                           "at(c,1/2))",
                           "at(c 1/2)",
                           "at(,1/2)",
                           "at(c;1/2)",
                           "at c",
                           "at",
                           "f(2,0)",
                           "at(f(2),1/2)",
                           "at(f(2,0,0),1/2)",
                           "at(f(1/2,0),1/2)",
                           "at(f(-1,0),1/2)",
                           "at(f(2,w),1/2)",
                           "at(f(64,0),1/2)",
                           "at(f(3,0)+f(2,0),1/2)",
                           "at(hermite(1,2,c),1/2)",
                           "at(hermite(1,c),1/2)",
                           "at(hermite(16,c,c),1/2)",
                           "at(hermite(1,c,at(c,1/2)),1/2)",
                           "at(degree(2,c),1/2)",
                           "at(degree(65,c),1/2)",
                           "at(tension(c,c),1/2)",
                           "at(tension(1,f(2,0)),1/2)",
                           "at(join(4,degree(9,c)),1/2)",
                           "at(join(0,c),1/2)",
                           "at(join(2,c),1/2)",
                           "at(split(0,c),1/2)",
                           "at(split(1,c,3),1/2)",
                           "at(split(1,c,1),1/2)",
                           "at(split(2,f(3,0)+f(3,0),0),1/2)",
                           "at(hermite(1,split(1,c),c),1/2)",
                           "dot([1,1],c)",
                           "dot(1,c)",
                           "dot([1,1,c,1],c)",
                           "dot([],c)",
                           "dot([1,1,1,1],c,c)",
                           "dot([1,1,1,1])",
                           "dot(c,[1,1,1,1])",
                           "[1,1]",
                           "again(c)",
                           "again(1)",
                           "again(at(c,1/2),1)",
                           "again(again(again(again(at(f(1,0),1/2)))))",
                           "gamma*at(c,1/2)",
                           "b1*at(c,1/2)",
                           "at(c,0.5)",
                           "at(c,1/2)\n",
                           "at(f(5,0),1/2)",
                           "at(f(2,2),1/2)",
                           "at(join(1,f(3,0)),1/2)",
                           "again(at(f(3,0),1/2))"})
    reject(rule);
  std::string deep;
  for (int k = 0; k < 101; ++k) deep += "(";
  reject(deep + "at(c,1/2)" + std::string(101, ')'));
  reject(std::string(50000, '(') + "at(c,1/2)" + std::string(50000, ')'));
  reject(std::string(99000, '-') + "at(c,1/2)");
  std::string calls = "c";
  for (int k = 0; k < 1000; ++k) calls = "degree(3," + calls + ")";
  reject("at(" + calls + ",1/2)");
  reject(std::string(100001, ' ') + "at(c,1/2)");
  const auto lets = [](const Json& let) {
    auto json = cr1();
    json["scheme"]["let"] = let;
    expect_invalid(json, "scheme");
  };
  lets(Let{{"c", "c"}});
  lets(Let{{"c", "d + e"}, {"d", "f(3,0)"}, {"e", "2*a"}, {"a", "c/2"}});
  lets(Let{{"c", "d"}});
  for (const char* name : {"c", "w", "at", "dot", "gamma", "1c", "", "c-d"}) lets(Let{{"c", "f(3,0)"}, {name, "1"}});
  lets(Factors{{"c", "f(3,0)", "1"}});
  lets(Factors{{"c"}});
  lets({"c"});
  lets(Json::object());
  lets("c");
}

TEST(Nonuniform, ObjectsOfTheWrongForm) {
  const auto change = [](const char* pointer, const Json& value, const std::string& steps) {
    for (auto json : {cr1(), n3(a131_rule, "C1", "[1/100, 18/100]", "refuted", "13/100", "1/50")}) {
      if (!json.contains(Json::json_pointer(pointer).parent_pointer())) continue;
      json[Json::json_pointer(pointer)] = value;
      expect_invalid(json, steps);
    }
  };
  change("/scheme/kind", "uniform", "scheme");
  change("/scheme/kind", "other", "scheme");
  change("/scheme/kind", 1, "scheme");
  change("/scheme", Let{}, "scheme");
  change("/scheme/points", 5, "scheme");
  change("/scheme/points", 0, "scheme");
  change("/scheme/points", 18, "scheme");
  change("/scheme/points", "4", "scheme");
  change("/scheme/mask", Let{}, "scheme");
  change("/scheme/coefficients", {"0", "1/2", "1/2", "0"}, "scheme");
  change("/scheme/parameters", {"gamma"}, "scheme");
  change("/scheme/parameters", {"w", "gamma"}, "scheme");
  change("/scheme/parameters", {"w", "w"}, "scheme");
  change("/scheme/parameters", Let{}, "scheme");
  change("/scheme/parameters", {"w", "v"}, "claim");
  change("/verdict", "undecided", "format");
  change("/theorem", "N2", "format");
  change("/theorem", "U1", "claim");
  change("/theorem", "U2", "claim proof");
  change("/proof", Json::object(), "proof");
  change("/proof/more", 1, "proof");
  for (const char* theorem : {"N1", "N3"}) {
    for (auto [name, json] : valid_certificates()) {
      json["theorem"] = theorem;
      expect_invalid(json, "claim");
    }
  }
  const auto in_leaf = [](const char* key, const Json& value) {
    auto json = cr1();
    json["proof"]["dominance"][0][key] = value;
    expect_invalid(json, "proof");
  };
  in_leaf("factor", 3);
  in_leaf("factor", -1);
  in_leaf("factor", "0");
  in_leaf("test", "separation");
  in_leaf("test", 1);
  in_leaf("region", {{"w", "[1/16, 1/8]"}});
  in_leaf("region", {{"w", "[1/16, 1/8]"}, {"gamma", "(0, 1]"}, {"v", "1"}});
  in_leaf("region", {{"w", "[1/16, 1/8]"}, {"gamma", "(1, 0]"}});
  in_leaf("more", 1);
  const auto coefficient = [](const Json& value) {
    auto json = cr1();
    json["proof"]["factors"][0][0] = value;
    expect_invalid(json, "proof");
  };
  for (const char* text : {"1/gamma", "w/gamma*gamma", "gamma/(1+w)", "lambda", "v", "1.5", "", "at(c,1/2)"})
    coefficient(text);
  coefficient(1);
  coefficient(Json::array());
}

TEST(Nonuniform, HostileCertificatesEnd) {
  const auto base = cr1();
  const auto rule = [&](const std::string& text) {
    auto json = base;
    json["scheme"]["rule"] = text;
    return json;
  };
  expect_invalid(rule("(1+w)^1000*(2+w)^1000*at(c,1/2)"), "limits");
  expect_invalid(rule("at(c," + std::string(9999, '7') + ")*(1/2)^1000*" + std::string(9999, '7') + "^500"), "limits");
  expect_invalid(rule("at(tension((1+w)^900, degree(63, c)),1/2)"), "limits");
  std::string many = "at(c,1/2)";
  for (int k = 0; k < 900; ++k) many += "+at(degree(64,f(3,0)),1/" + std::to_string(k + 2) + ")";
  expect_invalid(rule(many), "limits");
  auto json = base;
  Let let = catmull_rom_1;
  for (int k = 0; k < 200; ++k)
    let.push_back({"s" + std::to_string(k), (k == 0 ? "c" : "s" + std::to_string(k - 1)) + std::string("*(w+1)^20")});
  json["scheme"]["let"] = let;
  json["scheme"]["rule"] = "at(s199,1/2)";
  expect_invalid(json, "limits");
  json = base;
  json["proof"]["factors"][2][0] = "2*w + gamma^1000*w^1000 - gamma^1000*w^999";
  expect_invalid(json, "limits");
  json["proof"]["factors"][2][0] = "2*w + " + std::string(9000, '7') + "^600";
  expect_invalid(json, "limits");
  json = base;
  json["proof"]["dominance"][1]["test"] = "circle";
  for (int k = 1; k <= 9999; ++k)
    json["proof"]["dominance"][1]["c"].push_back(std::to_string(k) + "/" + std::string(200, '9'));
  expect_valid(json);  // it is right, if tedious
  expect_valid(n3(a131_rule, "C1", "13/100", "refuted", "13/100", "1/" + std::string(9999, '7')));
}
