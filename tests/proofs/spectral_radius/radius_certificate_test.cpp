#include "proofs/spectral_radius/radius_certificate.hpp"

#include "algebra/number/read_rational.hpp"
#include "proofs/checker/checker.hpp"
#include "schemes/catalogue.hpp"
#include "tests/analysis/spectral_radius/families.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace limes;
using test::golden;
using test::matrix;

namespace {

using Json = nlohmann::ordered_json;

void keep(const std::string& name, const std::string& text) {
  const std::filesystem::path directory = std::filesystem::path(LIMES_BINARY_DIR) / "certificates" / "radius";
  std::filesystem::create_directories(directory);
  std::ofstream(directory / (name + ".json")) << text;
}

std::string jsr_certificate(const MatrixFamily& family, int digits) {
  return prove_spectral_radius(family, bound_spectral_radius(family, {digits, {}}, {}));
}

std::string holder_certificate(const std::string& name, const std::vector<Rational>& point) {
  const Scheme scheme = Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name);
  return prove_hoelder_exponent(scheme, point, bound_hoelder_exponent(at(scheme.mask, point), 6, {}, {}));
}

MatrixFamily blocks() {
  return {matrix({{1, 5, 7}, {0, 1, 1}, {0, 0, Rational(1, 2)}}), matrix({{1, 0, 3}, {1, 1, 0}, {0, 0, Rational(1, 3)}})};
}
MatrixFamily rotation() {
  return {matrix({{Rational(3, 5), Rational(-4, 5)}, {Rational(4, 5), Rational(3, 5)}}), matrix({{0, Rational(1, 2)}, {0, 0}})};
}

bool valid(const Json& json) { return checker::check(json.dump()).valid; }

/// Every number, integer and list of the certificate, changed one at a time.
void for_each_change(Json& root, Json& node, const std::string& path, const std::function<void(const std::string&)>& check) {
  const Json saved = node;
  if (node.is_object() || node.is_array()) {
    for (auto& [key, value] : node.items()) for_each_change(root, value, path + "/" + key, check);
    if (node.is_array() && !node.empty()) {
      node.erase(node.size() - 1);
      check(path + " shortened");
      node = saved;
    }
    if (node.is_object()) {
      for (const auto& [key, value] : saved.items()) {
        node.erase(key);
        check(path + " without " + key);
        node = saved;
      }
      node["unknown"] = 1;
      check(path + " with an unknown key");
      node = saved;
    }
    return;
  }
  if (node.is_string()) {
    for (const std::string& other : {std::string("1000"), std::string("-1000"), std::string("x"), std::string("1/0")}) {
      if (saved == other) continue;
      node = other;
      check(path + " = " + other);
    }
  } else if (node.is_number()) {
    for (const int other : {-7, 77}) {
      node = other;
      check(path + " = " + std::to_string(other));
    }
  }
  node = saved;
}

/// Changes after which a complete proof of the same statement may be left: the remainder of a shorter combination may still be short
/// enough, and the unit may be another one. A name and the first index prove nothing.
bool may_prove_the_same(const std::string& change) {
  if (change.starts_with("/scheme/name") || change.starts_with("/scheme/first_index")) return true;
  const bool in_proof = change.starts_with("/proof/");
  return in_proof && ((change.find("/images/") != std::string::npos && change.ends_with("shortened")) || change.find("/unit = 1000") != std::string::npos);
}

/// Whether the statement is true, by a computation of its own: of matrices outside of the diagonal blocks nothing depends.
bool is_true(const Json& certificate) {
  if (certificate["theorem"] != "JSR") {
    const Json& claim = certificate["claim"];
    const auto bound = [&](const char* key) { return read_rational(claim.value(key, "2")); };
    return bound("lower") <= 2 && bound("upper") >= 2;   // the four-point scheme at 1/16
  }
  MatrixFamily family;
  for (const Json& rows : certificate["matrices"]) {
    RationalMatrix b(int(rows.size()), int(rows.size()));
    for (int i = 0; i < b.rows(); ++i) {
      for (int j = 0; j < b.rows(); ++j) b(i, j) = read_rational(rows[std::size_t(i)][std::size_t(j)].get<std::string>());
    }
    family.push_back(std::move(b));
  }
  const SpectralRadiusBounds bounds = bound_spectral_radius(family, {6, {}}, {});
  const Json& claim = certificate["claim"];
  const Rational lower = read_rational(claim["lower"].get<std::string>()), upper = read_rational(claim["upper"].get<std::string>());
  return lower <= bounds.upper && upper >= bounds.lower && (!claim.contains("polynomial") || bounds.exact);
}

void expect_changes_rejected(const std::string& text) {
  Json json = Json::parse(text);
  ASSERT_TRUE(valid(json));
  int rejected = 0;
  for_each_change(json, json, "", [&](const std::string& change) {
    if (!valid(json)) {
      ++rejected;
    } else {
      EXPECT_TRUE(may_prove_the_same(change) || (!change.starts_with("/proof") && is_true(json))) << change;
    }
  });
  EXPECT_GT(rejected, 50);
  ASSERT_TRUE(valid(json));
}

}  // namespace

TEST(RadiusCertificate, ValidOnes) {
  keep("golden", jsr_certificate(golden(), 6));
  keep("blocks", jsr_certificate(blocks(), 6));
  keep("rotation", jsr_certificate(rotation(), 6));
  keep("four-point", holder_certificate("four-point", {Rational(1, 16)}));
  keep("four-point-between", holder_certificate("four-point", {Rational(1, 20)}));
  keep("six-point-complex", holder_certificate("six-point", {Rational(1, 50)}));
  keep("deslauriers-dubuc-8", holder_certificate("deslauriers-dubuc-8", {}));
  keep("ternary", holder_certificate("ternary-four-point", {Rational(1, 11)}));
  keep("b-spline-3", holder_certificate("b-spline-3", {}));
}

TEST(RadiusCertificate, ChangesOfAnExactPolytopeAreRejected) { expect_changes_rejected(jsr_certificate(golden(), 6)); }
TEST(RadiusCertificate, ChangesOfBlocksAreRejected) { expect_changes_rejected(jsr_certificate(blocks(), 6)); }
TEST(RadiusCertificate, ChangesOfAComplexPolytopeAreRejected) { expect_changes_rejected(jsr_certificate(rotation(), 6)); }
TEST(RadiusCertificate, ChangesOfAnExponentAreRejected) { expect_changes_rejected(holder_certificate("four-point", {Rational(1, 16)})); }

/// Symmetric with one sum rule, the next being missed by 1/1000: all products of the sections have nearly the same radius.
std::string near_sum_rule_certificate() {
  Scheme scheme;
  scheme.name = "near-sum-rule";
  std::vector<Rational> mask;
  for (const int c : {4, 121, 484, 891, 996, 699, 296, 79, 20, 10}) mask.push_back(Rational(c) / 1800);
  scheme.mask = {2, LaurentPolynomial::from_rationals(-4, mask)};
  PolytopeLimits limits;
  limits.max_vectors = 4;
  const HoelderExponent exponent = bound_hoelder_exponent(scheme.mask, 2, limits, {});
  EXPECT_TRUE(exponent.level && exponent.bounds.lower && exponent.bounds.upper);
  return prove_hoelder_exponent(scheme, {}, exponent);
}

TEST(RadiusCertificate, ExponentsByNorms) {
  const std::string text = near_sum_rule_certificate();
  keep("near-sum-rule", text);
  Json json = Json::parse(text);
  EXPECT_TRUE(json["proof"]["radius"].contains("level"));
  int rejected = 0;
  for_each_change(json, json, "", [&](const std::string& change) {
    if (!valid(json))
      ++rejected;
    else  // weaker claims and levels that prove them
      EXPECT_TRUE(change.starts_with("/scheme/name") || change.starts_with("/scheme/first_index") || change.starts_with("/claim/lower") ||
                  change.starts_with("/claim/upper") || change.starts_with("/proof/radius")) << change;
  });
  EXPECT_GT(rejected, 50);
  const Json original = json;
  json["proof"]["radius_upper"] = json["proof"]["radius_lower"];
  EXPECT_FALSE(valid(json)) << "no norm proves a bound as small as that";
  json = original;
  json["proof"]["radius"]["level"] = 1;
  EXPECT_FALSE(valid(json)) << "the first norm is not enough";
  json = original;
  json["claim"]["polynomial"] = {"1", "-1"};
  EXPECT_FALSE(valid(json)) << "norms give no exact exponent";
}

TEST(RadiusCertificate, SlightlyStrongerClaimsAreRejected) {
  Json json = Json::parse(holder_certificate("deslauriers-dubuc-6", {}));
  json["claim"]["lower"] = "28300750/10000000";   // log_2(9) = 3.169925001..
  EXPECT_FALSE(valid(json));
  json = Json::parse(holder_certificate("deslauriers-dubuc-6", {}));
  json["claim"]["upper"] = "28300749/10000000";
  EXPECT_FALSE(valid(json));
  // The next lower order proves less: its exponent saturates.
  json["proof"]["order"] = 5;
  EXPECT_FALSE(valid(json));

  json = Json::parse(jsr_certificate(golden(), 6));
  json["claim"].erase("polynomial");
  EXPECT_TRUE(valid(json));
  json["claim"]["lower"] = "16181/10000";
  EXPECT_FALSE(valid(json));
  json["claim"]["lower"] = "1618/1000";
  json["claim"]["upper"] = "16180/10000";
  EXPECT_FALSE(valid(json));
}
