#include "tests/checker/polytope_leaf.hpp"

// U1 leaves with a polytope norm. With no vectors at all the ball is that of the 1-norm, and the bound is the greatest absolute
// column sum of the sections.

namespace limes::test {
namespace {

const Json no_terms = Json::array();

/// The 1-norm in `dimension` dimensions for so many matrices.
Json one_norm(const std::string& bound, std::size_t dimension, std::size_t matrices) {
  const Json images(matrices, Json(dimension, no_terms));
  const Json block{{"vectors", Json::array()}, {"unit", "1"}, {"images", images}};
  return {{"bound", bound}, {"norm", {{"form", nullptr}, {"blocks", Json::array({block})}}}};
}

const Claim chaikin{{}, {"1/4", "3/4", "3/4", "1/4"}, "C1"};

TEST(PolytopeLeaf, NormsOfSectionsWithAndWithoutParameters) {
  expect_valid(by_polytope(chaikin, one_norm("1/2", 1, 2)));
  expect_valid(by_polytope(tilted("1/8"), one_norm("5/8", 1, 2)));
  // Two Bernstein coefficients times two sections.
  expect_valid(by_polytope(tilted("[1/8, 1/4]"), one_norm("3/4", 1, 4)));
}

TEST(PolytopeLeaf, WithADenominator) {
  // The same scheme with w = 1/v, and with v < 0.
  const Claim claim{{"v"}, {"1/4+1/v/2", "3/4+1/v/2", "3/4-1/v/2", "1/4-1/v/2"}, "C1", {{"v", "[4, 8]"}}};
  expect_valid(by_polytope(claim, one_norm("3/4", 1, 4)));
  Claim negative = claim;
  negative.region = {{"v", "[-8, -4]"}};
  expect_valid(by_polytope(negative, one_norm("3/4", 1, 4)));
  // D = v vanishes at an end that does not belong to the leaf: no convex combination there.
  Claim open = claim;
  open.region = {{"v", "(0, 8]"}};
  expect_invalid(by_polytope(open, one_norm("3/4", 1, 4)), "denominator");
}

TEST(PolytopeLeaf, TheBoundIsBelowOneAndHolds) {
  expect_invalid(by_polytope(chaikin, one_norm("1", 1, 2)), "polytope");
  expect_invalid(by_polytope(chaikin, one_norm("3/2", 1, 2)), "polytope");
  expect_invalid(by_polytope(chaikin, one_norm("49/100", 1, 2)), "polytope");
  expect_invalid(by_polytope(chaikin, one_norm("-1", 1, 2)), "polytope");
  expect_invalid(by_polytope(tilted("[1/8, 1/4]"), one_norm("74/100", 1, 4)), "polytope");
  // The first or the last Bernstein coefficient alone would do.
  expect_invalid(by_polytope(tilted("[1/8, 3/4]"), one_norm("3/4", 1, 4)), "polytope");
  expect_invalid(by_polytope(tilted("[-3/4, 1/8]"), one_norm("3/4", 1, 4)), "polytope");
  // An open end is no way out: there the norm is 1.
  expect_invalid(by_polytope(tilted("[1/4, 1/2)"), one_norm("999999/1000000", 1, 4)), "polytope");
}

TEST(PolytopeLeaf, EveryMatrixTakesPart) {
  for (const std::size_t matrices : {0u, 1u, 2u, 3u, 5u}) {
    EXPECT_FALSE(check(by_polytope(tilted("[1/8, 1/4]"), one_norm("3/4", 1, matrices))).valid) << matrices;
  }
  for (const std::size_t dimension : {0u, 2u, 3u}) {
    EXPECT_FALSE(check(by_polytope(tilted("[1/8, 1/4]"), one_norm("3/4", dimension, 4))).valid) << dimension;
  }
}

TEST(PolytopeLeaf, TheSymbolIsCheckedAsForALevel) {
  // a(1) = 9/5 * 2, and b = 9/10 (1 + z) for m = 0 has sections 9/10; without the sum it would pass.
  const Claim sum{{}, {"9/10", "9/5", "9/10"}, "C0"};
  expect_invalid(by_polytope(sum, one_norm("9/10", 1, 2)), "sum");
  Claim factor = chaikin;
  factor.statement = "C3";
  expect_invalid(by_polytope(factor, one_norm("1/2", 1, 2)), "factor");
}

TEST(PolytopeLeaf, ItsForm) {
  const Json good = one_norm("1/2", 1, 2);
  for (const char* key : {"bound", "norm"}) {
    Json bad = good;
    bad.erase(key);
    expect_invalid(by_polytope(chaikin, bad), "proof");
  }
  Json more = good;
  more["level"] = 1;
  expect_invalid(by_polytope(chaikin, more), "proof");
  for (const Json& value : {Json(nullptr), Json(0.5), Json("x"), Json("1/0"), Json(Json::array()), Json(Json::object())}) {
    Json bad = good;
    bad["bound"] = value;
    expect_invalid(by_polytope(chaikin, bad), "proof");
    bad = good;
    bad["norm"] = value;
    EXPECT_FALSE(check(by_polytope(chaikin, bad)).valid);
    EXPECT_FALSE(check(by_polytope(chaikin, value)).valid);
  }
  // A leaf has one witness, and words of U2 have no polytope.
  Json both = by_polytope(chaikin, good);
  both["proof"]["leaves"][0]["level"] = 1;
  expect_invalid(both, "proof");
  Json rough_by_polytope = rough({{}, {"1/4", "3/4", "3/4", "1/4"}, "not C2"}, "linear-independence", {0});
  rough_by_polytope["proof"]["leaves"][0].erase("word");
  rough_by_polytope["proof"]["leaves"][0]["polytope"] = good;
  expect_invalid(rough_by_polytope, "proof");
}

}  // namespace
}  // namespace limes::test
