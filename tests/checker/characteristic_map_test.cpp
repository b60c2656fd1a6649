#include "proofs/checker/characteristic_map.hpp"

#include "tests/checker/certificates.hpp"

#include <functional>

using namespace limes::test;
using limes::checker::Budget;
using limes::checker::IntegerMask;

namespace {

Json term(int a, int b, int sector, const std::string& weight) { return {{"point", {a, b}}, {"sector", sector}, {"weight", weight}}; }
Json mean(int harmonic, int a, int b, const std::string& weight) {
  return {{"point", {a, b}}, {"harmonic", harmonic}, {"weight", weight}};
}

Json scheme(const std::string& name, bool dual, int first_index, const std::vector<std::string>& mask) {
  return {{"kind", "surface"}, {"name", name}, {"dual", dual}, {"first_index", first_index}, {"mask", mask}, {"rules", Json::array()}};
}

Json catmull_clark() {
  Json result = scheme("catmull-clark", false, -2, {"1/8", "1/2", "3/4", "1/2", "1/8"});
  result["rules"] = {{{"point", {0, 0}},
                      {"terms", {term(0, 0, 0, "1 - 7/(4*n)"), mean(0, 1, 0, "3/(2*n)"), mean(0, 1, 1, "1/(4*n)")}}}};
  return result;
}

Json doo_sabin() {
  Json result = scheme("doo-sabin", true, -1, {"1/4", "3/4", "3/4", "1/4"});
  result["rules"] = {{{"point", {0, 0}}, {"terms", {term(0, 0, 0, "1/4"), mean(0, 0, 0, "3/4"), mean(1, 0, 0, "1/2")}}}};
  return result;
}

/// The spectral condition holds with lambda = 1/2; the diagonal points of the eigenvector are -(L_0 + L_1) times `fold`.
Json folded(const std::string& fold) {
  Json result = scheme("folded", false, -3, {"-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"});
  const std::string side = "-1/10*" + fold;
  result["rules"] = {{{"point", {0, 0}}, {"terms", {term(0, 0, 0, "1")}}},
                     {{"point", {1, 0}}, {"terms", {term(0, 0, 0, "3/4"), term(1, 0, 0, "1/4"), mean(1, 1, 0, "1/2")}}},
                     {{"point", {1, 1}},
                      {"terms", {term(0, 0, 0, "3/5 - 2*(" + side + ")"), term(1, 1, 0, "2/5"), term(1, 0, 0, side), term(1, 0, 1, side)}}}};
  return result;
}

/// C^1 at one valence.
Json smooth_at(const Json& surface, int n, const std::string& separator, int rings, int level) {
  return {{"format", "limes-certificate"},
          {"version", 1},
          {"scheme", surface},
          {"claim", {{"statement", "C1"}, {"valence", std::to_string(n)}}},
          {"verdict", "certified"},
          {"theorem", "E2"},
          {"proof",
           {{"rings", rings}, {"level", 2}, {"valences", {{{"valence", n}, {"separator", separator}}}}, {"map", {{"levels", {level}}}}}}};
}

IntegerMask mask(int first, std::vector<int> numerators, int denominator) {
  return {first, {numerators.begin(), numerators.end()}, denominator};
}

TEST(LebesgueBound, OfPositiveMasksIsAlmostOne) {
  Budget budget;
  for (const IntegerMask& a : {mask(-1, {1, 3, 3, 1}, 4), mask(-2, {1, 4, 6, 4, 1}, 8), mask(0, {1, 2, 1}, 2)}) {
    const mpq_class bound = limes::checker::lebesgue_bound(a, budget);
    EXPECT_GE(bound, 1);
    EXPECT_LE(bound, mpq_class(101, 100));
  }
}

TEST(LebesgueBound, ExceedsEveryNormOfTheFourPointScheme) {
  Budget budget;
  const mpq_class bound = limes::checker::lebesgue_bound(mask(-3, {-1, 0, 9, 16, 9, 0, -1}, 16), budget);
  EXPECT_GE(bound, mpq_class(5, 4)) << "at 1/2: 9/16 + 9/16 + 1/16 + 1/16";
  EXPECT_LE(bound, mpq_class(3, 2));
}

TEST(LebesgueBound, RefusesSchemesThatDoNotConverge) {
  Budget budget;
  for (const IntegerMask& a : {mask(0, {1, 1}, 1), mask(0, {2, 1, 2}, 2), mask(-3, {-2, 0, 3, 2, 3, 0, -2}, 2)})
    EXPECT_THROW(limes::checker::lebesgue_bound(a, budget), limes::checker::Rejected);
}

TEST(CharacteristicMapCertificate, KnownSchemesAreSmooth) {
  expect_valid(smooth_at(catmull_clark(), 3, "3/8", 2, 2));
  expect_valid(smooth_at(catmull_clark(), 5, "1/2", 2, 2));
  expect_valid(smooth_at(catmull_clark(), 6, "11/20", 2, 2));
  for (const int n : {3, 5, 6, 12}) expect_valid(smooth_at(doo_sabin(), n, "2/5", 2, 2));
}

TEST(CharacteristicMapCertificate, TooFewLevelsAreNotEnough) {
  expect_invalid(smooth_at(catmull_clark(), 3, "3/8", 2, 0), "map");
  expect_invalid(smooth_at(catmull_clark(), 3, "3/8", 2, 7), "proof");
}

TEST(CharacteristicMapCertificate, AFoldedMapIsNotSmooth) {
  expect_valid(smooth_at(folded("(-1)"), 5, "9/20", 3, 3));  // K = L_0 + L_1
  Json spectral = smooth_at(folded("1"), 5, "9/20", 3, 3);
  expect_invalid(spectral, "map");
  for (int level = 0; level <= 6; ++level) expect_invalid(smooth_at(folded("1"), 5, "9/20", 3, level), "map");
  spectral["theorem"] = "E1", spectral["claim"]["statement"] = "spectral-condition";
  spectral["proof"].erase("map");
  expect_valid(spectral);
}

TEST(CharacteristicMapCertificate, EveryPartIsChecked) {
  const Json valid = smooth_at(catmull_clark(), 5, "1/2", 2, 2);
  const auto altered = [&](const std::function<void(Json&)>& change) {
    Json result = valid;
    change(result);
    return result;
  };
  expect_invalid(altered([](Json& c) { c["theorem"] = "E1"; }), "claim");
  expect_invalid(altered([](Json& c) { c["claim"]["statement"] = "C2"; }), "claim");
  expect_invalid(altered([](Json& c) { c["claim"]["valence"] = "6"; }), "proof");
  expect_invalid(altered([](Json& c) { c["proof"].erase("map"); }), "proof");
  expect_invalid(altered([](Json& c) { c["proof"]["map"]["levels"] = Json::array(); }), "proof");
  expect_invalid(altered([](Json& c) { c["proof"]["map"]["levels"].push_back(3); }), "proof");
  expect_invalid(altered([](Json& c) { c["proof"]["map"]["levels"][0] = "2"; }), "proof");
  expect_invalid(altered([](Json& c) { c["proof"]["map"]["lambda"] = "11/20"; }), "proof");
  expect_invalid(altered([](Json& c) { c["proof"]["map"]["start"] = "1/2"; }), "proof");
  // lambda = 0.54999
  expect_invalid(altered([](Json& c) { c["proof"]["valences"][0]["separator"] = "11/20"; }), "spectrum");
  expect_invalid(altered([](Json& c) { c["scheme"]["mask"] = {"1/8", "1/2", "3/4", "1/2", "1/4"}; }), "symmetry");
}

}  // namespace
