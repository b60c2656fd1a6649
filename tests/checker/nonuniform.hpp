// Certificates about non-uniform schemes (Karciauskas & Peters 2013), made from templates; the factors are the paper's, or
// were computed with PARI.
#pragma once

#include "tests/checker/certificates.hpp"

#include <array>

namespace limes::test {

using Let = std::vector<std::array<std::string, 2>>;
using Factors = std::vector<std::vector<std::string>>;

inline const Let catmull_rom_1{{"cr1", "hermite(1, f(2,0), f(2,1))"}, {"c", "tension(16*w, cr1)"}};
inline const Let catmull_rom_2{{"cr1", "hermite(1, f(2,0), f(2,1))"}, {"cr2", "join(2, degree(4, cr1))"}};
inline const char* const cr2_rule = "(576*w-2)*at(cr2,1/2) + (3-576*w)*dot([1/12,1/6,1/2,1/6,1/12], cr2)";
inline const char* const a131_rule = "16*w*at(f(3,0),1/2) + (1-16*w)*at(f(1,0),1/2)";
inline const char* const a253_rule = "256/3*w*at(f(5,0),1/2) + (1-256/3*w)*at(f(3,0),1/2)";

inline const std::vector<std::string> a131_factor{
    "-(8*gamma^2+20*gamma+8)*w^2", "-32*(gamma-1)^2*w^2 + (10*gamma^2+16*gamma+10)*w",
    "-(8*gamma^2+20*gamma+8)*w - (2*gamma^2+5*gamma+2)", "4*gamma^2+10*gamma+4"};
inline const std::vector<std::string> a253_factor{
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

inline Json nonuniform(int points, const Let& let, const std::string& rule, const std::string& statement,
                       const Json& region, const std::string& verdict, const std::string& theorem, const Json& proof) {
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
inline Json n1(int points, const Let& let, const std::string& rule, const std::string& statement, const Json& region,
               int level, const Factors& factors, const std::vector<int>& multiplicities,
               const std::vector<Piece>& tests) {
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

inline Json cr1(const std::string& region = "[1/16, 1/8]", int level = 4,
                const std::vector<Piece>& tests = {{0, "rouche"}, {1, "rouche"}, {2, "boundary"}}) {
  return n1(4, catmull_rom_1, "at(c,1/2)", "C1", {{"w", region}}, level,
            {{"w", "1"}, {"-2*w", "1"}, {"2*w", "-1", "2"}}, {2, 1, 1}, tests);
}

inline Json a253(const std::string& region, const std::vector<Piece>& tests) {
  return n1(6, Let{}, a253_rule, "C2", {{"w", region}}, 6, {{"-w", "1"}, {"-1/8", "1"}, a253_factor}, {2, 1, 1}, tests);
}

inline Json n3(const std::string& rule, const std::string& statement, const std::string& region,
               const std::string& verdict, const std::string& w, const std::string& gamma) {
  return nonuniform(4, catmull_rom_1, rule, statement, {{"w", region}}, verdict, "N3",
                    {{"region", {{"w", w}}}, {"gamma", gamma}});
}

/// 9/16 of the quadratic interpolant on the left and 7/16 of that on the right; `left` of it, to be exact.
inline Json one_sided(const std::string& left = "9/16") {
  const Factors factors{{"-1", "4"}, {"9", "128"}, {"7", "128"}, {"63*gamma+63", "-736*gamma-800", "2048*gamma+2048"}};
  auto json = n1(4, Let{}, left + "*at(f(2,0),1/2) + (1-" + left + ")*at(f(2,1),1/2)", "C1", Json::object(), 4, factors,
                 {1, 1, 1, 1}, {{0, "rouche"}, {1, "rouche"}, {2, "rouche"}, {3, "rouche"}});
  json["proof"]["mirrored"] = json["proof"]["dominance"];
  return json;
}

/// C^1 of the four-point scheme from cubic interpolants at one w, the cubic factor by separation.
inline Json separated(const std::string& w, const Json& curves, const Json& distances,
                      const std::string& gamma = "(0, 1]") {
  auto json = n1(4, Let{}, a131_rule, "C1", {{"w", w}}, 4, {{"w", "1"}, a131_factor}, {2, 1},
                 {{0, "rouche"}, {1, "separation", gamma}});
  json["proof"]["dominance"][1]["curves"] = curves;
  if (!distances.is_null()) json["proof"]["dominance"][1]["distances"] = distances;
  return json;
}

}  // namespace limes::test
