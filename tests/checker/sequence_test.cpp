#include "tests/checker/certificates.hpp"

#include <functional>

using namespace limes::test;

namespace {

const std::string outer = "-1/(8*mu*(mu+1))", inner = "(2*mu+1)^2/(8*mu*(mu+1))";
const std::vector<std::string> unified{outer, "0", inner, "1", inner, "0", outer};
const std::vector<std::string> cubic_spline{"1/(4*(1+mu))", "1/2", "(1+2*mu)/(2*(1+mu))", "1/2", "1/(4*(1+mu))"};

Json scheme(const std::vector<std::string>& mask, const std::string& type) {
  return {{"kind", "nonstationary"},
          {"name", "test"},
          {"parameters", {"theta"}},
          {"level_parameter", "mu"},
          {"type", type},
          {"arity", 2},
          {"first_index", -static_cast<int>(mask.size() / 2)},
          {"mask", mask},
          {"first_levels", Json::array()}};
}

Json certificate(const std::vector<std::string>& mask, const std::string& statement, const std::string& angles,
                 const std::string& theorem, const Json& proof, const std::string& type = "trigonometric") {
  return {{"format", "limes-certificate"},
          {"version", 1},
          {"scheme", scheme(mask, type)},
          {"claim", {{"statement", statement}, {"region", {{"theta", angles}}}}},
          {"verdict", "certified"},
          {"theorem", theorem},
          {"proof", proof}};
}

/// The limit of a scheme by U1.
Json limit(const std::vector<std::string>& mask, const std::string& statement, int level) {
  return smooth({.parameters = {}, .mask = mask, .statement = statement}, level);
}

const std::vector<std::string> four_point_limit{"-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"};

/// The unified four-point scheme [Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021] is C^1 for these angles.
Json unified_c1(const std::string& angles = "[0, 3]", const std::string& type = "trigonometric",
                const std::string& constant = "1") {
  return certificate(unified, "C1", angles, "S1",
                     {{"from_level", 1},
                      {"factors", 0},
                      {"order", 2},
                      {"constant", constant},
                      {"limit", limit(four_point_limit, "C1", 2)}},
                     type);
}

/// The exponential B-spline of order 4 is C^2; the masks tend to their limit too slowly but for two factors (1 + z)/2.
Json spline_c2(int factors = 1) {
  return certificate(cubic_spline, "C2", "[0, 3]", "S1",
                     {{"from_level", 1},
                      {"factors", factors},
                      {"order", 2},
                      {"constant", "1"},
                      {"limit", limit({"1/8", "1/2", "3/4", "1/2", "1/8"}, "C2", 1)}});
}

Json reproduction(const std::vector<std::string>& mask, const std::string& statement,
                  const std::string& angles = "[0, 3]", const std::string& type = "trigonometric") {
  return certificate(mask, statement, angles, "S2", {{"from_level", 1}}, type);
}

Json defect(int residue, int moment, const std::string& part) {
  return {{"residue", residue}, {"moment", moment}, {"part", part}};
}

Json defects(const std::vector<std::string>& mask, const std::string& statement, const Json& list,
             const std::string& angles = "(0, 3]") {
  return certificate(mask, statement, angles, "S2", {{"from_level", 1}, {"defects", list}});
}

Json changed(Json json, const std::string& pointer, const Json& value) {
  json[Json::json_pointer(pointer)] = value;
  return json;
}

TEST(AsymptoticEquivalence, ValidCertificates) {
  expect_valid(unified_c1());
  expect_valid(unified_c1("[0, 31415926535/10000000000]"));
  expect_valid(unified_c1("(1/3, 2)"));
  expect_valid(unified_c1("0"));
  expect_valid(unified_c1("[0, 20]", "hyperbolic", "10000000"));
  expect_valid(spline_c2());
  expect_valid(spline_c2(2));
  EXPECT_NE(check(unified_c1()).statement.find("test (trigonometric) is C1 for theta in [0, 3]"), std::string::npos);
}

TEST(AsymptoticEquivalence, EveryHypothesisIsChecked) {
  const Json valid = unified_c1();
  // The masks: another limit, a pole at mu = 1/2 (theta = 2 pi / 3), no limit at all.
  expect_valid(changed(valid, "/scheme/mask/3", "2-mu"));  // sum rules in the limit only
  expect_invalid(changed(valid, "/scheme/mask/3", "9-8*mu"), "bound");
  expect_invalid(changed(valid, "/scheme/mask/3", "9/10"), "limit");
  expect_invalid(changed(valid, "/scheme/mask/3", "(mu-1/2)/(mu-1/2)"), "denominator");
  expect_invalid(changed(valid, "/scheme/mask/3", "(mu-1)/(mu-1)"), "denominator");
  expect_invalid(changed(valid, "/scheme/mask/3", "w"), "scheme");
  expect_invalid(changed(valid, "/scheme/mask/3", "1/0"), "scheme");
  expect_invalid(changed(valid, "/scheme/mask/3", "mu^1001"), "scheme limits");
  // A pole that a first level only avoids: mu_0 = cos(theta/2) is 9/10 at theta = 0.9, the other levels are closer to 1.
  const std::string pole = "(mu-9/10)/(mu-9/10)";
  expect_invalid(changed(changed(unified_c1("[0, 1]"), "/scheme/mask/3", pole), "/proof/from_level", 1), "denominator");
  expect_valid(changed(changed(changed(unified_c1("[95/100, 1]"), "/scheme/mask/3", pole), "/proof/from_level", 1),
                       "/proof/constant", "10"));
  // Angles: mu = 0 at pi; beyond the range of the type; negative.
  expect_invalid(unified_c1("[0, 3141593/1000000]"), "denominator");
  expect_invalid(unified_c1("[0, 7]"), "claim");
  expect_invalid(unified_c1("[-1, 1]"), "claim");
  expect_invalid(unified_c1("[0, 201]", "hyperbolic"), "claim");
  // C^2: the limit is not C^2; 2 > 2 is false without factors; more factors than the masks have, or than m.
  expect_invalid(changed(valid, "/claim/statement", "C2"), "limit order");
  expect_invalid(changed(valid, "/claim/statement", "C0"), "limit");
  expect_invalid(changed(valid, "/claim/statement", "not C1"), "claim");
  expect_invalid(changed(valid, "/claim/statement", "reproduces {1}"), "claim");
  expect_invalid(changed(valid, "/verdict", "refuted"), "claim");
  expect_invalid(spline_c2(0), "order");
  expect_invalid(spline_c2(3), "proof");
  expect_invalid(changed(changed(spline_c2(), "/scheme/mask/2", "(2+mu)/(2*(1+mu))"), "/proof/constant", "10"),
                 "factor");
  // The bound.
  expect_invalid(changed(valid, "/proof/constant", "1/10"), "bound");
  expect_invalid(changed(valid, "/proof/constant", "-1"), "bound");
  expect_invalid(changed(valid, "/proof/constant", "1/0"), "proof");
  expect_invalid(changed(valid, "/proof/order", 4), "order");
  expect_invalid(changed(valid, "/proof/order", 3), "proof");
  expect_invalid(changed(valid, "/proof/order", 0), "proof");
  expect_invalid(changed(valid, "/proof/from_level", 0),
                 "bound");  // the bound is larger where the denominator is small
  expect_valid(changed(valid, "/proof/from_level", 2));
  expect_invalid(changed(valid, "/proof/from_level", -1), "proof");
  expect_invalid(changed(valid, "/proof/from_level", 129), "proof");
  // The hyperbolic bound needs cosh of the greatest x.
  expect_invalid(unified_c1("[0, 20]", "hyperbolic", "1"), "bound");
}

TEST(AsymptoticEquivalence, TheLimitNeedsAProofOfItsOwn) {
  const Json valid = unified_c1();
  expect_invalid(changed(valid, "/proof/limit/proof/leaves/0/level", 1), "contractivity");
  expect_invalid(changed(valid, "/proof/limit/scheme/mask/0", "-1/15"), "limit");
  expect_invalid(changed(valid, "/proof/limit/claim/statement", "C0"), "limit");
  expect_invalid(changed(valid, "/proof/limit/verdict", "refuted"), "claim limit");
  expect_invalid(changed(valid, "/proof/limit/theorem", "U2"), "limit");
  expect_invalid(changed(valid, "/proof/limit", Json::object()), "limit");
  expect_invalid(changed(valid, "/proof/limit", valid), "limit");
  expect_invalid(changed(valid, "/proof/limit/scheme/arity", 3), "limit");
  // A polygon's certificate of C^0 is none of the four-point scheme.
  expect_invalid(changed(valid, "/proof/limit", limit({"1/2", "1", "1/2"}, "C0", 1)), "limit");
  // With a parameter the embedded scheme would be many.
  Json parametric = valid;
  parametric["proof"]["limit"] =
      smooth({.parameters = {"w"}, .mask = four_point_limit, .statement = "C1", .region = {{"w", "[0, 1]"}}}, 2);
  expect_invalid(parametric, "limit");
}

TEST(AsymptoticEquivalence, FirstLevelsAreFreeButDefined) {
  Json json = unified_c1();
  json["scheme"]["first_levels"] = {{{"first_index", 0}, {"mask", {"5", "-mu^2"}}}};
  expect_valid(json);
  json["proof"]["from_level"] = 0;
  expect_invalid(json, "proof");
  json = unified_c1();
  json["scheme"]["first_levels"] = {{{"first_index", 0}, {"mask", {"1/(mu-1/2)"}}}};
  expect_invalid(json, "denominator");  // mu_0 = 1/2 at theta = 2 pi/3
}

TEST(Reproduction, ValidCertificates) {
  expect_valid(reproduction(unified, "reproduces {1, y, cos, sin}"));
  expect_valid(reproduction(unified, "reproduces {1, y, cosh, sinh}", "[0, 20]", "hyperbolic"));
  expect_valid(reproduction(unified, "reproduces {1, y, y^2, y^3}", "0"));
  expect_valid(reproduction(unified, "reproduces {1, cos(3y)}", "0"));  // cos 0 = 1
  expect_valid(reproduction(unified, "generates {1, y, cos, sin}"));
  expect_valid(reproduction(cubic_spline, "generates {1, y, cos, sin}"));
  expect_valid(reproduction(cubic_spline, "reproduces {1, y}"));
  expect_valid(defects(unified, "does not reproduce {y^2, cos(2y), y cos}",
                       {defect(1, 2, "even"), defect(1, 0, "even"), defect(1, 1, "odd")}));
  expect_valid(defects(cubic_spline, "does not reproduce {cos}", Json::array({defect(1, 0, "even")})));
}

TEST(Reproduction, IdentitiesThatDoNotHoldAreRejected) {
  for (const char* functions : {"{y^2}", "{y^3}", "{cos(2y)}", "{y cos}", "{1, y, sin(3y)}"})
    expect_invalid(reproduction(unified, "reproduces " + std::string(functions)), "identity");
  expect_invalid(reproduction(unified, "reproduces {y^4}", "0"), "identity");
  expect_invalid(reproduction(unified, "reproduces {y^2}", "[0, 1/1000]"), "identity");
  expect_invalid(reproduction(cubic_spline, "reproduces {cos}"), "identity");
  expect_invalid(reproduction(cubic_spline, "generates {y^2}"), "identity");
  expect_invalid(reproduction(unified, "reproduces {cosh}"), "claim");
  expect_invalid(reproduction(unified, "reproduces {cos}", "[0, 1]", "hyperbolic"), "claim");
  const Json valid = reproduction(unified, "reproduces {1, y, cos, sin}");
  expect_invalid(changed(valid, "/scheme/mask/0", "-1/(8*mu*(mu+1)) + 1/1000000"), "identity limits");
  expect_valid(changed(valid, "/scheme/first_index", -2));  // the same with parameters i + 1
  EXPECT_NE(check(changed(valid, "/scheme/first_index", -2)).statement.find("with parameters i + 1"),
            std::string::npos);
  expect_invalid(changed(valid, "/claim/region/theta", "[0, 3142/1000]"), "denominator");
  Json first = changed(valid, "/scheme/first_levels", {{{"first_index", -1}, {"mask", {"1/2", "1", "1/2"}}}});
  expect_invalid(first, "identity");
  first["claim"]["statement"] = "reproduces {1, y}";
  expect_valid(first);
}

TEST(Reproduction, StatementsOfAnotherForm) {
  for (const char* statement : {"reproduces {}", "reproduces {1, }", "reproduces {1,y}", "reproduces { 1}",
                                "reproduces {y^0}", "reproduces {y^17}", "reproduces {tan}", "reproduces {cos(0y)}",
                                "reproduces {cos(2)}", "reproduces {1", "reproduce {1}", "does not reproduces {1}",
                                "reproduces {y cos sin}", "reproduces {cos(99999999999999999999y)}", "C1", ""})
    expect_invalid(reproduction(unified, statement), "claim");
  std::string many = "reproduces {1";
  for (int k = 0; k < 16; ++k) many += ", 1";
  expect_invalid(reproduction(unified, many + "}"), "claim");
}

TEST(Reproduction, DefectsAreProvedAtEveryAngle) {
  const Json valid = defects(unified, "does not reproduce {y^2}", Json::array({defect(1, 2, "even")}));
  expect_valid(valid);
  expect_invalid(changed(valid, "/claim/region/theta", "[0, 3]"), "defect");  // the cubics at theta = 0
  expect_invalid(changed(valid, "/proof/defects/0/residue", 0), "defect");
  expect_invalid(changed(valid, "/proof/defects/0/moment", 1), "defect");
  expect_invalid(changed(valid, "/proof/defects/0/moment", 0), "defect");
  expect_invalid(changed(valid, "/proof/defects/0/moment", 3), "proof");
  expect_invalid(changed(valid, "/proof/defects/0/part", "odd"), "proof");
  expect_invalid(changed(valid, "/proof/defects/0/residue", 2), "proof");
  expect_invalid(changed(valid, "/proof/defects", Json::array()), "proof");
  expect_invalid(changed(valid, "/claim/statement", "does not reproduce {y}"), "proof");
  expect_invalid(changed(valid, "/claim/statement", "does not reproduce {cos}"), "proof");
  expect_valid(changed(valid, "/claim/statement", "does not generate {y^3}"));  // M_2 depends on the residue
  const Json odd = defects(unified, "does not reproduce {y cos}", Json::array({defect(1, 1, "odd")}));
  expect_valid(odd);
  expect_invalid(changed(odd, "/claim/region/theta", "[0, 3]"), "proof");  // sin x = 0 at theta = 0
  expect_invalid(changed(odd, "/proof/defects/0/part", "even"), "defect");
  expect_invalid(changed(odd, "/proof/defects/0/moment", 0), "defect");
}

TEST(Reproduction, ARefutationIsOneFunctionOnAPartOfTheRegion) {
  Json json = defects(unified, "reproduces {1, y^2}", Json::array({defect(1, 2, "even")}), "[0, 3]");
  json["verdict"] = "refuted";
  json["proof"]["function"] = 1;
  json["proof"]["region"] = {{"theta", "1"}};
  expect_valid(json);
  expect_invalid(changed(json, "/proof/function", 0), "proof");
  expect_invalid(changed(json, "/proof/function", 2), "proof");
  expect_invalid(changed(json, "/proof/region/theta", "0"), "defect");
  expect_invalid(changed(json, "/proof/region/theta", "4"), "covering");
  expect_invalid(changed(json, "/verdict", "certified"), "proof");
  Json opposite = reproduction(unified, "does not reproduce {y^2, y}");
  opposite["verdict"] = "refuted";
  opposite["proof"]["function"] = 1;
  opposite["proof"]["region"] = {{"theta", "[1, 2]"}};
  expect_valid(opposite);
  expect_invalid(changed(opposite, "/proof/function", 0), "identity");
}

/// Every key is taken away and every value replaced by others: what stays valid states something true.
TEST(SequenceCertificates, MutantsAreRejectedOrTrue) {
  const std::vector<Json> values{nullptr,
                                 true,
                                 -1,
                                 0,
                                 1,
                                 2,
                                 3,
                                 1000000,
                                 1.0,
                                 "",
                                 "0",
                                 "1",
                                 "-1",
                                 "1/2",
                                 "mu",
                                 "theta",
                                 "[0, 1]",
                                 "(0, 3]",
                                 "C0",
                                 "C1",
                                 "C2",
                                 "hyperbolic",
                                 "S1",
                                 "S2",
                                 "U1",
                                 "refuted",
                                 "reproduces {1, y}",
                                 "reproduces {y^2}",
                                 Json::array(),
                                 Json::object()};
  const auto is_true = [](const Json& json) {
    // Only the mask, the angles, the type, free first levels and labels tell schemes apart; these are the true statements about them.
    const std::string statement = json["claim"]["statement"];
    const bool same_mask = json["scheme"]["mask"] == Json(unified);
    const std::string angles = json["claim"]["region"].begin().value();
    if (json["verdict"] == "refuted") return statement == "reproduces {y^2}" && angles != "0";
    Json centre = unified;
    centre[3] = "mu";  // tends to 1 like x^2
    if (statement == "C1") return same_mask || json["scheme"]["mask"] == centre;
    if (statement == "reproduces {1, y}") return same_mask;
    if (statement == "reproduces {1, y, cos, sin}") return same_mask && json["scheme"]["type"] == "trigonometric";
    return false;
  };
  int mutants = 0;
  for (const Json& valid : {unified_c1(), reproduction(unified, "reproduces {1, y, cos, sin}")}) {
    const Json leaves = valid.flatten();
    for (const auto& [pointer, value] : leaves.items()) {
      Json without = valid;
      const Json::json_pointer place(pointer);
      const auto parent = place.parent_pointer();
      if (without[parent].is_object()) {
        without[parent].erase(place.back());
        EXPECT_FALSE(check(without).valid) << pointer;
      }
      for (const Json& other : values) {
        if (other == value) continue;
        const Json mutant = changed(valid, pointer, other);
        const auto result = check(mutant);
        ++mutants;
        EXPECT_TRUE(!result.valid || is_true(mutant)) << pointer << " = " << other << ": " << result.statement;
        EXPECT_NE(result.step, "internal") << pointer << " = " << other;
      }
    }
  }
  EXPECT_GT(mutants, 1000);
}

TEST(SequenceCertificates, AHugeParametrisationCostsItsWork) {
  // tau = a'(1)/2 has 9990 digits; the moments of degree 16 took minutes although every single entry but one is 1.
  std::vector<std::string> mask(1023, "1");
  mask.push_back("1" + std::string(9990, '0'));
  Json json = defects(mask, "does not generate {y^16, y^16, y^16}", Json::array({}), "(0, 1]");
  for (int k = 0; k < 3; ++k) json["proof"]["defects"].push_back(defect(1, 16, "even"));
  expect_invalid(json, "limits");
}

TEST(SequenceCertificates, WorkIsBounded) {
  Json json = reproduction(unified, "reproduces {y^16 cos(16y)}");
  json["scheme"]["first_index"] = 1000000;
  expect_invalid(json, "limits identity");
  json = reproduction(std::vector<std::string>(300, "1/(mu+2)^100"), "reproduces {y^16 cos(16y)}");
  expect_invalid(json, "limits identity");
  json = unified_c1();
  json["claim"]["region"]["theta"] = "[0, 3/1" + std::string(9000, '0') + "]";
  expect_valid(json);
  json["scheme"]["mask"][3] = "mu^1000/(mu^1000)";
  const auto result = check(json);
  EXPECT_TRUE(result.valid || result.step == "limits" || result.step == "bound" || result.step == "denominator")
      << result.step;
}

}  // namespace
