#include "tests/checker/vertex.hpp"

using namespace limes::test;

// Theorem E1: the spectral condition at extraordinary vertices and faces.

namespace {

Json proof(int rings, int level, const Json& valences) { return {{"rings", rings}, {"level", level}, {"valences", valences}}; }

/// lambda = (5 + c + sqrt((9+c)(1+c)))/16, c = cos(2 pi/n): 0.410, 1/2, 0.550, 0.580
Json cc(const Json& scheme = catmull_clark()) {
  return spectral_certificate(scheme, "[3, 6]", proof(2, 1, single_valences(3, {"3/10", "2/5", "9/20", "1/2"})));
}
/// lambda = 1/2 for all n
Json ds(const Json& scheme = doo_sabin()) {
  return spectral_certificate(scheme, "[3, 6]", proof(2, 1, single_valences(3, {"3/8", "3/8", "3/8", "3/8"})));
}
/// lambda = 1/2 for n = 4, where it is a tensor product
Json four(const Json& scheme = unified()) {
  return spectral_certificate(scheme, "[3, 6]", proof(3, 4, single_valences(3, {"1/3", "2/5", "9/20", "1/2"})));
}

Json cc_for_all() {
  Json json = spectral_certificate(catmull_clark(), "[3, inf)", proof(2, 1, single_valences(3, {"3/10", "2/5"})));
  json["proof"]["all"] = {{"from", 5}, {"start", "129/500"}, {"bound", "272937/500000"}, {"touch", "3/20"}};
  json["proof"]["all"]["cells"] = {
      cell("77/250", "332959/1000000", "540919/1000000", "550829/1000000"),
      cell("789/2000", "168457/500000", "137207/250000", "282187/500000"),
      cell("481/1000", "171843/500000", "562373/1000000", "288881/500000"),
      cell("227/400", "17519/50000", "575761/1000000", "591007/1000000"),
      cell("327/500", "357003/1000000", "294503/500000", "604123/1000000"),
      cell("1481/2000", "363561/1000000", "301061/500000", "308561/500000"),
      cell("827/1000", "18503/50000", "615121/1000000", "630013/1000000"),
      cell("1827/2000", "188253/500000", "157003/250000", "642807/1000000"),
      cell("1", "382903/1000000", "320403/500000", "655509/1000000")
  };
  return json;
}

Json ds_for_all() {
  Json json = spectral_certificate(doo_sabin(), "[3, inf)", proof(2, 1, Json::array()));
  json["proof"]["all"] = {{"from", 3}, {"start", "-3/5"}, {"bound", "3/8"}};
  json["proof"]["all"]["cells"] = {cell("1", "3/8", "49/100", "51/100")};
  return json;
}

/// The four-point scheme at all angles up to pi/3 and their levels.
Json nonstationary(const std::string& type = "trigonometric", const std::string& angles = "[0, 1]") {
  Json scheme = unified("-1/(8*mu*(mu+1))", "(2*mu+1)^2/(8*mu*(mu+1))", "1/(2*mu+1)^2");
  scheme["parameters"] = {"theta"};
  scheme["level_parameter"] = "mu";
  scheme["type"] = type;
  Json json = four(scheme);
  json["claim"]["region"] = {{"theta", angles}};
  json["proof"]["from_level"] = 1;
  return json;
}

Json changed(Json json, const std::string& pointer, const Json& value) {
  json[Json::json_pointer(pointer)] = value;
  return json;
}

Json without(Json json, const std::string& parent, const std::string& key) {
  json[Json::json_pointer(parent)].erase(key);
  return json;
}

const char* const all_steps = "format scheme claim proof rings sum symmetry effective spectrum denominator contractivity factor limits json";

TEST(VertexCertificate, KnownSchemesAreValid) {
  expect_valid(cc());
  expect_valid(ds());
  expect_valid(four());
  expect_valid(cc_for_all());
  expect_valid(ds_for_all());
  expect_valid(nonstationary());
  expect_valid(nonstationary("trigonometric", "(0, 3]"));
  expect_valid(nonstationary("hyperbolic", "[0, 2]"));
  EXPECT_EQ(check(cc()).statement,
            "certified: test satisfies the spectral condition at extraordinary vertices of the valences 3 to 6 (theorem E1)");
  EXPECT_EQ(check(ds_for_all()).statement,
            "certified: test satisfies the spectral condition at extraordinary faces of all valences (theorem E1)");
  EXPECT_EQ(check(nonstationary()).statement,
            "certified: the limit matrix M of test (trigonometric) satisfies the spectral condition at extraordinary vertices of the "
            "valences 3 to 6, and the sum of 2^k ||M_k - M|| is finite for theta in [0, 1] (theorem E1)");
  expect_valid(changed(changed(cc(), "/claim/valence", "3"), "/proof/valences", single_valences(3, {"3/10"})));
}

// Catmull & Clark's eigenvalue at n = 4 is 1/2; and the regular case of the four-point scheme is the tensor product's.
TEST(VertexCertificate, SeparatorsBeyondTheEigenvaluesAreRejected) {
  for (const char* separator : {"0", "-1/3", "1/5", "1/2", "501/1000", "99/100", "1", "2"}) {
    expect_invalid(changed(cc(), "/proof/valences/1/separator", separator), "spectrum");
    expect_invalid(changed(four(), "/proof/valences/1/separator", separator), "spectrum");
  }
  expect_valid(changed(cc(), "/proof/valences/1/separator", "499999/1000000"));
  expect_invalid(changed(cc(), "/proof/valences/1/separator", "1/4"), "spectrum");  // an eigenvalue of block 2
  expect_valid(changed(cc(), "/proof/valences/1/separator", "250001/1000000"));
}

TEST(VertexCertificate, EveryFieldOfTheProofCounts) {
  expect_invalid(changed(cc(), "/proof/rings", 1), "rings");
  expect_invalid(changed(four(), "/proof/rings", 2), "rings");  // invariant, but they do not determine the limit
  expect_invalid(changed(cc(), "/proof/rings", 9), "proof");
  expect_valid(changed(cc(), "/proof/rings", 4));
  expect_invalid(changed(four(), "/proof/level", 1), "contractivity");
  expect_invalid(changed(cc(), "/proof/level", 0), "proof");
  expect_invalid(changed(cc(), "/claim/valence", "[3, 7]"), "proof");
  expect_invalid(changed(cc(), "/claim/valence", "[3, 5]"), "proof");
  expect_invalid(changed(cc(), "/claim/valence", "[4, 6]"), "proof");
  expect_invalid(changed(cc(), "/claim/valence", "[3, inf)"), "proof");
  for (const char* valence : {"[2, 6]", "[6, 3]", "[3,6]", "[3, 1001]", "3..6", "", "[3, inf]", "[03, 6]", "[3, 6", "[3, 6, 7]", "[, ]"})
    expect_invalid(changed(cc(), "/claim/valence", valence), "claim");
  expect_invalid(changed(cc(), "/claim/statement", "C1"), "claim");
  expect_invalid(changed(cc(), "/theorem", "E2"), "claim proof");
  expect_invalid(changed(cc(), "/verdict", "refuted"), "format");
  Json swapped = cc();
  std::swap(swapped["proof"]["valences"][0], swapped["proof"]["valences"][1]);
  expect_invalid(swapped, "proof");
  expect_invalid(changed(cc(), "/proof/valences", Json::array()), "proof");
  expect_invalid(changed(cc(), "/proof/all", cc_for_all()["proof"]["all"]), "proof");
  expect_invalid(changed(cc(), "/proof/map", Json::object()), "proof");
}

TEST(VertexCertificate, EveryFieldOfTheProofForAllCounts) {
  const std::string all = "/proof/all";
  for (const char* start : {"31/100", "1/2", "-2"}) expect_invalid(changed(cc_for_all(), all + "/start", start), "spectrum");
  for (const char* bound : {"0", "-1", "1/2", "6/10", "1"}) expect_invalid(changed(cc_for_all(), all + "/bound", bound), "spectrum");
  for (const char* touch : {"0", "-1/10", "1/10", "1/8", "1/3", "13/25", "7/10"})
    expect_invalid(changed(cc_for_all(), all + "/touch", touch), "spectrum");
  expect_invalid(without(cc_for_all(), all, "touch"), "spectrum");  // block 0 has eigenvalues up to lambda(1)
  for (const int from : {3, 4, 6}) expect_invalid(changed(cc_for_all(), all + "/from", from), "proof spectrum");
  const std::size_t cells = cc_for_all()["proof"]["all"]["cells"].size();
  for (std::size_t k = 0; k < cells; ++k) {
    Json shorter = cc_for_all();
    shorter["proof"]["all"]["cells"].erase(k);
    expect_invalid(shorter, "spectrum");
    const std::string own = all + "/cells/" + std::to_string(k);
    for (const char* separator : {"0", "-1/2", "1/10", "7/10"}) expect_invalid(changed(cc_for_all(), own + "/separator", separator), "spectrum");
    for (const char* end : {"1/10", "7/10", "1"}) {
      expect_invalid(changed(cc_for_all(), own + "/root/0", end), "spectrum");
      if (std::string(end) != "7/10") expect_invalid(changed(cc_for_all(), own + "/root/1", end), "spectrum");
    }
    for (const char* to : {"0", "2", "11/10"}) expect_invalid(changed(cc_for_all(), own + "/to", to), "spectrum");
  }
  expect_invalid(changed(ds_for_all(), all + "/bound", "1/4"), "spectrum");
  expect_invalid(changed(ds_for_all(), all + "/bound", "1/2"), "spectrum");
  expect_invalid(changed(ds_for_all(), all + "/cells/0/root/0", "1/2"), "spectrum");
  expect_invalid(changed(ds_for_all(), all + "/cells/0/separator", "1/4"), "spectrum");
  expect_invalid(changed(ds_for_all(), all + "/touch", "3/8"), "spectrum");
  expect_invalid(without(ds_for_all(), "/proof", "all"), "proof");
}

Json ds_with(const Json& terms) { return ds(surface_scheme(true, chaikin_mask, Json::array({rule(0, 0, terms)}))); }

// The eigenvalues of the first ring of these dual schemes are those of a circulant matrix.
TEST(VertexCertificate, FalseSpectraAreRejected) {
  // 1/4 + (1/2) cos(2 pi j k/n): for n = 5, k = 2 the greatest belongs to block 2
  Json wrong_block = ds_with({at(0, 0, 0, "1/4"), at(0, 0, 2, "1/4"), at(0, 0, -2, "1/4"), harmonic(0, 0, 0, "1/4")});
  wrong_block["claim"]["valence"] = "5";
  for (const char* separator : {"1/5", "3/10", "3/8", "2/5", "1/2"}) {
    wrong_block["proof"]["valences"] = single_valences(5, {separator});
    expect_invalid(wrong_block, "spectrum");
  }
  expect_invalid(ds_with({at(0, 0, 0, "1")}), "spectrum");                                                     // 1 in every block
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "3/2")}), "spectrum");    // lambda = 1
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "2")}), "spectrum");      // 5/4
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "-3/2")}), "spectrum");   // -1/2
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4")}), "spectrum");                           // 1/4 in all
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "1/4")}), "spectrum");    // 3/8 = separator
  // The vertex hardly moves: a second eigenvalue of block 0 near 1. Or it does not move: fine, but 1 is no longer the only one ..
  const auto cc_with = [](const Json& terms) { return cc(surface_scheme(false, cubic_mask, Json::array({rule(0, 0, terms)}))); };
  expect_invalid(cc_with({at(0, 0, 0, "1 - 1/(100*n)"), harmonic(0, 1, 0, "1/(100*n)")}), "spectrum");
  expect_invalid(cc_with({at(0, 0, 0, "1")}), "spectrum");
  expect_invalid(cc_with({at(0, 0, 0, "3"), harmonic(0, 1, 0, "-2")}), "spectrum");
  expect_invalid(cc_with({at(0, 0, 0, "1 + (n-3)"), harmonic(0, 1, 0, "-(n-3)")}), "spectrum");  // good for some valence only
}

TEST(VertexCertificate, FalseRulesAreRejected) {
  expect_invalid(four(unified("-1/16", "9/16", "1/5")), "symmetry");  // seen in codes; not symmetric where spokes cross
  expect_invalid(four(unified("-1/16", "9/16", "0")), "symmetry");
  expect_invalid(four(unified("-1/16", "1/2")), "sum symmetry factor spectrum");
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "1/2"), harmonic(1, 0, 0, "1/2")}), "sum");
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), at(0, 0, 1, "1/4"), harmonic(0, 0, 0, "1/2"), harmonic(1, 0, 0, "1/2")}), "symmetry");
  expect_invalid(ds_with({at(0, 0, 0, "1/4"), at(1, 0, 0, "1/4"), harmonic(0, 0, 0, "1/2"), harmonic(1, 0, 0, "1/2")}), "symmetry");
  expect_invalid(ds_with({at(0, 0, 0, "1/n"), at(0, 0, 0, "1/(n-4)"), harmonic(0, 0, 0, "1 - 1/n - 1/(n-4)")}), "denominator spectrum");
  const auto cc_with = [](const Json& rules) { return cc(surface_scheme(false, cubic_mask, rules)); };
  const Json vertex = catmull_clark()["rules"][0];
  expect_invalid(cc_with(Json::array()), "scheme");  // the tensor product reaches beyond the vertex
  expect_invalid(cc_with(Json::array({rule(0, 0, {at(0, 0, 0, "1/2"), at(1, 0, 0, "1/2")})})), "symmetry");
  expect_invalid(cc_with(Json::array({rule(0, 0, {at(0, 0, 0, "1/2"), harmonic(1, 1, 0, "1"), harmonic(0, 1, 0, "1/2")})})), "symmetry");
  expect_invalid(cc_with(Json::array({vertex, vertex})), "scheme");
  expect_invalid(cc_with(Json::array({rule(0, 0, {at(0, 0, 0, "1/2"), harmonic(0, 4, 0, "1/2")})})), "rings");
  expect_invalid(cc_with(Json::array({vertex, rule(3, 3, {at(1, 1, 0, "1")})})), "rings effective");
  expect_invalid(cc_with(Json::array({rule(0, 1, {at(0, 0, 0, "1")}), vertex})), "scheme");
  expect_invalid(cc_with(Json::array({rule(0, 0, {at(0, 0, 1, "1")})})), "scheme");
  expect_invalid(cc_with(Json::array({rule(0, 0, {harmonic(0, 0, 0, "1")})})), "scheme");
  expect_invalid(cc_with(Json::array({rule(0, 0, {harmonic(2, 1, 0, "1")})})), "scheme");
  expect_invalid(cc_with(Json::array({rule(1, 0, {at(1, 0, 0, "1")}), vertex})), "spectrum");  // 1 in every block
  // A rule of one's own far from the vertex: points in between might have no influence.
  Json far = cc_with(Json::array({vertex, rule(3, 0, catmull_clark()["rules"][0]["terms"])}));
  far["proof"]["rings"] = 3;
  expect_invalid(far, "effective");
  // The curve scheme is not C^1, not symmetric, no scheme.
  expect_invalid(changed(cc(), "/scheme/mask", {"0", "1/2", "1", "1/2", "0"}), "factor contractivity scheme");
  expect_invalid(changed(cc(), "/scheme/mask", {"1/8", "1/2", "3/4", "1/2", "1/4"}), "symmetry");
  expect_invalid(changed(cc(), "/scheme/mask", {"1/4", "1/2", "3/4", "1/2", "1/4"}), "sum factor");
  expect_invalid(changed(cc(), "/scheme/mask", {"1/8", "1/2", "3/4 + 0*n", "1/2", "1/8*n/n"}), "scheme");
  expect_invalid(changed(cc(), "/scheme/first_index", -1), "scheme");
  expect_invalid(changed(cc(), "/scheme/dual", true), "scheme");
  expect_invalid(changed(ds(), "/scheme/dual", false), "scheme");
}

TEST(VertexCertificate, WeightsThatDependOnTheValenceInOtherBlocksAreNotForAll) {
  Json json = ds_for_all();
  json["scheme"]["rules"] = Json::array({rule(0, 0, {at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "1/2 + 1/n - 1/n")})});
  expect_valid(json);  // (n^2 + ..)/n^2 is 1/2
  json["scheme"]["rules"] = Json::array({rule(0, 0, {at(0, 0, 0, "1/n"), harmonic(0, 0, 0, "1-1/n"), harmonic(1, 0, 0, "1/2")})});
  expect_invalid(json, "scheme");
  json["scheme"]["rules"] = Json::array({rule(0, 0, {at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "1/n")})});
  expect_invalid(json, "scheme");
}

TEST(VertexCertificate, NonstationarySchemes) {
  expect_invalid(nonstationary("trigonometric", "[0, 7]"), "claim");
  expect_invalid(nonstationary("trigonometric", "[0, 13/2]"), "claim");
  expect_invalid(nonstationary("trigonometric", "[0, 4]"), "denominator");  // mu_0 = cos 2 < 0 < cos 0
  expect_invalid(changed(nonstationary(), "/scheme/type", "polynomial"), "scheme");
  expect_invalid(changed(nonstationary(), "/scheme/level_parameter", "n"), "scheme");
  expect_invalid(without(nonstationary(), "/scheme", "type"), "scheme");
  expect_invalid(without(nonstationary(), "/proof", "from_level"), "proof");
  expect_invalid(without(nonstationary(), "/claim", "region"), "claim");
  expect_invalid(changed(cc(), "/claim/region", Json::object()), "claim");
  expect_invalid(changed(cc(), "/proof/from_level", 1), "proof");
  Json both = nonstationary();
  both["scheme"]["rules"][0]["terms"][0]["weight"] = "1/(mu*n)";
  expect_invalid(both, "denominator");
  Json pole = nonstationary();
  pole["scheme"]["rules"][0]["terms"].push_back(at(2, 0, 0, "(mu-1)/(mu-1)"));
  expect_invalid(pole, "denominator");
}

/// All nodes of a JSON value, as pointers.
void collect(const Json& json, const std::string& pointer, std::vector<std::string>& result) {
  result.push_back(pointer);
  if (json.is_object())
    for (const auto& [key, value] : json.items()) collect(value, pointer + "/" + key, result);
  if (json.is_array())
    for (std::size_t k = 0; k < json.size(); ++k) collect(json[k], pointer + "/" + std::to_string(k), result);
}

// No text, number or list may be anything else; what is left valid by such changes are other separators, names and shifts of ends.
TEST(VertexCertificate, OtherTypesAreRejected) {
  for (const Json& valid : {cc(), ds_for_all(), cc_for_all()}) {
    std::vector<std::string> pointers;
    collect(valid, "", pointers);
    for (const std::string& pointer : pointers) {
      if (pointer.empty()) continue;
      for (const Json& value : {Json(nullptr), Json(-1), Json(1.5), Json(""), Json("x"), Json("1/0"), Json::array(), Json::object(), Json(true)}) {
        const bool is_name = pointer == "/scheme/name", is_dual = pointer == "/scheme/dual";
        if ((is_name && value == "x") || (is_dual && value.is_boolean()) || valid[Json::json_pointer(pointer)] == value) continue;
        const bool sector = pointer.ends_with("/sector");  // an integer may be -1
        if (sector || (pointer == "/proof/valences" && valid["proof"].contains("all") && value == Json::array())) continue;
        expect_invalid(changed(valid, pointer, value), all_steps);
      }
      const auto slash = pointer.rfind('/');
      if (valid[Json::json_pointer(pointer.substr(0, slash))].is_object())
        expect_invalid(without(valid, pointer.substr(0, slash), pointer.substr(slash + 1)), all_steps);
    }
  }
}

TEST(VertexCertificate, LongWeightsAreRead) {
  Json json = cc();
  json["scheme"]["rules"][0]["terms"][0]["weight"] = "1 - 7/(4*n) + " + std::string(2000, '9') + "*(n-n)";
  expect_valid(json);
}

}  // namespace
