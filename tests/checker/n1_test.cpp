#include "tests/checker/nonuniform.hpp"

using namespace limes::test;

TEST(N1, CatmullRom1) {
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

TEST(N1, DefinitionsInAnyOrder) {
  auto json = cr1();
  json["scheme"]["let"] = Let{
      {"c", "(0*d) + tension(omega, cr1)"}, {"cr1", "hermite(1, f(2,0), f(2,1))"}, {"d", "cr1-cr1"}, {"omega", "16*w"}};
  expect_valid(json);
}

TEST(N1, PiecewiseLinear) {
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

TEST(N1, CatmullRom1ByCoefficients) {
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

TEST(N1, CatmullRom2) {
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

TEST(N1, Averages) {
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

TEST(N1, OneOrderTooHigh) {
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

TEST(N1, RegionsThatReachTooFar) {
  for (const char* region : {"[1/16, 1/5]", "[0, 1/8]", "0", "1/4", "[1/16, 1/4]"})
    expect_invalid(cr1(region, 8), "contractivity");
  // C^1 for equal intervals, but not for small gamma.
  for (const std::string test : {"rouche", "boundary", "circle"})
    for (const char* region : {"[1/10, 13/100]", "13/100"})
      expect_invalid(n1(4, Let{}, a131_rule, "C1", {{"w", region}}, 6, {{"w", "1"}, a131_factor}, {2, 1},
                        {{0, "rouche"}, {1, test, "(0, 1/32]"}, {1, test, "(1/32, 1/2]"}, {1, test, "(1/2, 1]"}}),
                     "dominance");
}

TEST(N1, FactorsThatAreForgedOrDropped) {
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

TEST(N1, ASecondEigenvalueOneHalf) {
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

// sum_{s<p} |d_s| rho^s < d_p rho^p: without the last rho^p, a root between 1/2 and 1 would pass.
TEST(N1, TheRadiusBelongsToTheLeadingTermToo) {
  for (const char* gamma : {"(0, 1/64]", "1/64", "(0, 1/1000]"})
    expect_invalid(n1(4, Let{}, a131_rule, "C1", {{"w", "13/100"}}, 6, {{"w", "1"}, a131_factor}, {2, 1},
                      {{0, "rouche"}, {1, "rouche", gamma}, {1, "boundary", "[1/64, 1]"}}),
                   "dominance covering");
}

TEST(N1, RulesWithoutSymmetry) {
  const auto base = one_sided();
  expect_valid(base);
  auto json = base;
  json["proof"].erase("mirrored");
  expect_invalid(json, "symmetry");
  json["proof"]["mirrored"] = Json::array();
  expect_invalid(json, "covering");
  json["proof"]["mirrored"] = true;
  expect_invalid(json, "proof");
  for (std::size_t k = 0; k < 4; ++k) {
    for (const char* list : {"dominance", "mirrored"}) {
      json = base;
      json["proof"][list].erase(k);
      expect_invalid(json, "covering");
      for (const char* gamma : {"[1/1000, 1]", "(0, 1)", "(0, 2]", "[0, 1]"}) {
        json = base;
        json["proof"][list][k]["region"]["gamma"] = gamma;
        expect_invalid(json, "covering");
      }
      json = base;
      json["proof"][list][k]["test"] = "boundary";
      expect_valid(json);
    }
  }
  // A symmetric rule may have both, and its own leaves serve.
  json = cr1();
  json["proof"]["mirrored"] = json["proof"]["dominance"];
  expect_valid(json);
  expect_invalid(one_sided("1/2"), "characteristic");
}

// Smooth at equal intervals and for small ratios, but for large ones an eigenvalue exceeds 1/2; and its mirror image.
TEST(N1, BothSidesCount) {
  for (const bool small : {true, false}) {
    // chi of 21/20 f(2,0) - 1/20 f(2,1), and of its mirror image, computed with PARI.
    const std::vector<std::string> factor =
        small ? std::vector<std::string>{"-21*gamma-21", "-760*gamma-1640", "3200*gamma+3200"}
              : std::vector<std::string>{"-21*gamma-21", "-1640*gamma-760", "3200*gamma+3200"};
    for (const std::string test : {"rouche", "boundary", "circle"}) {
      auto json = n1(
          4, Let{}, small ? "21/20*at(f(2,0),1/2) - 1/20*at(f(2,1),1/2)" : "21/20*at(f(2,1),1/2) - 1/20*at(f(2,0),1/2)",
          "C1", Json::object(), 6, {{"-1", "4"}, {"21", "160"}, {"-1", "160"}, factor}, {1, 1, 1, 1},
          {{0, "rouche"}, {1, "rouche"}, {2, "rouche"}, {3, test}});
      expect_invalid(json, "symmetry");
      json["proof"]["mirrored"] = json["proof"]["dominance"];
      expect_invalid(json, "dominance");
    }
  }
}
