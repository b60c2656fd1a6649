#include "tests/checker/nonuniform.hpp"

using namespace limes::test;

TEST(NonuniformForm, RulesThatAreAltered) {
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

TEST(NonuniformForm, DivisorsThatVanish) {
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

TEST(NonuniformForm, RulesOfTheWrongForm) {
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
  for (int k = 0; k < 301; ++k) deep += "(";
  reject(deep + "at(c,1/2)" + std::string(301, ')'));
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

TEST(NonuniformForm, ObjectsOfTheWrongForm) {
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
  in_leaf("test", "separation");  // without curves
  in_leaf("test", "sturm");
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

TEST(NonuniformForm, HostileCertificatesEnd) {
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
  for (int k = 1; k <= 999; ++k)
    json["proof"]["dominance"][1]["c"].push_back(std::to_string(k) + "/" + std::string(200, '9'));
  expect_valid(json);  // it is right, if tedious
  expect_valid(n3(a131_rule, "C1", "13/100", "refuted", "13/100", "1/" + std::string(9999, '7')));
}
