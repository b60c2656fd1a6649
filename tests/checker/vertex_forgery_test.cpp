// Certificates about extraordinary vertices that were made to deceive: false statements, and true ones whose proof has a gap.
#include "tests/checker/vertex.hpp"

using namespace limes::test;

namespace {

/// Catmull and Clark's rules, but for the vertex: its weights of the neighbours are multiplied by `strength`.
Json catmull_clark(const std::string& strength = "1") {
  const std::string s = "(" + strength + ")";
  return {{"kind", "surface"},
          {"name", "test"},
          {"dual", false},
          {"first_index", -2},
          {"mask", {"1/8", "1/2", "3/4", "1/2", "1/8"}},
          {"rules",
           {{{"point", {0, 0}},
             {"terms", {at(0, 0, 0, "1 - 7*" + s + "/(4*n)"), harmonic(0, 1, 0, "3*" + s + "/(2*n)"), harmonic(0, 1, 1, s + "/(4*n)")}}}}}};
}

Json cell(const std::string& to, const std::string& low, const std::string& high) {
  return {{"to", to}, {"separator", "1/2"}, {"root", {low, high}}};
}

/// All valences from 30 on, whose second eigenvalue of block 0 tends to lambda with n.
Json touching(const Json& scheme) {
  return spectral_certificate(scheme, "[30, inf)",
                  {{"rings", 2},
                   {"level", 1},
                   {"valences", Json::array()},
                   {"all",
                    {{"from", 30},
                     {"start", "9/10"},
                     {"bound", "641/1000"},
                     {"touch", "1/2"},
                     {"cells",
                      {cell("93/100", "639/1000", "645/1000"), cell("95/100", "643/1000", "648/1000"),
                       cell("965/1000", "646/1000", "650/1000"), cell("975/1000", "648/1000", "652/1000"),
                       cell("985/1000", "650/1000", "653/1000"), cell("1", "651/1000", "656/1000")}}}}});
}

TEST(ForgedVertices, TouchingBlocksNeedASlope) {
  expect_valid(touching(catmull_clark()));
  expect_valid(touching(catmull_clark("1/2")));
  // A vertex that hardly moves: block 0 falls more slowly with 1/n than lambda, and is above it at n = 30.
  for (const char* strength : {"1/100", "1/1000000000", "0", "-1"}) expect_invalid(touching(catmull_clark(strength)), "spectrum");
}

TEST(ForgedVertices, TouchingBlocksWithHarmonicsNeedADifferentiableEigenvalue) {
  // The spokes take a mean of the spokes, with the first harmonic: block 0 at 1/n = 0 and block 1 at c = 1 agree. On the first cell the
  // enclosure of the polynomial's derivative by lambda begins with exactly 0, by which the slope of lambda was divided.
  Json scheme = catmull_clark();
  scheme["rules"].push_back({{"point", {1, 0}},
                             {"terms",
                              {at(1, 0, 0, "3/8"), at(1, 0, 1, "1/16"), at(1, 0, -1, "1/16"), at(1, 1, 0, "1/16"),
                               at(1, 1, -1, "1/16"), harmonic(0, 1, 0, "3/8"), harmonic(1, 1, 0, "3/4")}}});
  Json json = touching(scheme);
  Json& all = json["proof"]["all"];
  all["start"] = "-1";
  all["bound"] = "66/100";
  all["cells"] = {cell("7/8", "71/128", "127/128"), cell("15/16", "9/10", "98/100"), cell("31/32", "9/10", "98/100"),
                  cell("1", "92/100", "98/100")};
  const auto result = check(json);
  EXPECT_EQ(result.step, "spectrum");
  EXPECT_NE(result.reason.find("differentiable"), std::string::npos) << result.reason;
}

TEST(ForgedVertices, ASeparatorSeparates) {
  const auto at = [](int n, const std::string& separator) {
    return spectral_certificate(catmull_clark(), std::to_string(n),
                    {{"rings", 2}, {"level", 1}, {"valences", {{{"valence", n}, {"separator", separator}}}}});
  };
  expect_valid(at(5, "1/2"));
  for (const char* separator : {"0", "1", "-1/2", "3/10", "34/100", "551/1000", "3/5", "2"}) expect_invalid(at(5, separator), "spectrum");
  expect_invalid(at(5, "1/2" + std::string(400, '0')), "proof");  // long numbers are refused
  // Too few rings for the limit near the vertex, however good the spectrum is.
  Json json = at(5, "1/2");
  json["proof"]["rings"] = 1;
  expect_invalid(json, "rings");
}

TEST(ForgedVertices, WeightsThatAreNoneOfASurface) {
  const Json valid = spectral_certificate(catmull_clark(), "5", {{"rings", 2}, {"level", 1}, {"valences", {{{"valence", 5}, {"separator", "1/2"}}}}});
  expect_valid(valid);
  const auto weight = [&](int k, const std::string& text) {
    Json json = valid;
    json["scheme"]["rules"][0]["terms"][k]["weight"] = text;
    return json;
  };
  expect_invalid(weight(0, "1 - 7/(4*n) + 1/1000000"), "sum");
  expect_invalid(weight(0, "1 - 7/(4*n) + 0/(n - 5)"), "denominator");
  expect_valid(weight(0, "1 - 7/(4*n) + 0/(n - 6)"));
  expect_invalid(weight(0, "1 - 7/(4*m)"), "scheme");
  Json json = valid;
  json["scheme"]["mask"][0] = "1/(8*n)";
  expect_invalid(json, "scheme");
  json = valid;
  json["scheme"]["level_parameter"] = "mu";  // without an angle
  expect_invalid(json, "scheme");
}

}  // namespace
