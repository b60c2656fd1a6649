#include "tests/checker/polytope_leaf.hpp"

// U1 leaves with a polytope whose vectors move with the parameter.

namespace limes::test {
namespace {

/// One vector, 1 at one end and 2 at the other one. On [1/8, 1/4] the sections are 5/8 .. 3/4 and 3/8 .. 1/4: multiples of the vector.
Json one_vector(const std::string& bound) {
  const auto term = [](Json numbers) { return Json::array({Json::array({0, std::move(numbers)})}); };
  const Json first = Json::array({term({"5/8", "11/16", "3/4"}), Json::array()});
  const Json second = Json::array({term({"3/8", "5/16", "1/4"}), Json::array()});
  const Json block{{"vectors", {{{"1"}, {"2"}}}}, {"unit", "1/4"}, {"images", {first, second}}};
  return {{"bound", bound}, {"moving", {{"form", nullptr}, {"blocks", Json::array({block})}}}};
}

TEST(MovingPolytope, QuadraticCoefficientsFollowTheSections) {
  // B(s) v(s) = c(s) v(s) with c = B, and B unit e_1 is a remainder.
  expect_valid(by_polytope(tilted("[1/8, 1/4]"), one_vector("3/4")));
  expect_invalid(by_polytope(tilted("[1/8, 1/4]"), one_vector("74/100")), "polytope");
  expect_invalid(by_polytope(tilted("[1/8, 1/4]"), one_vector("1")), "polytope");
}

TEST(MovingPolytope, EveryNumberCounts) {
  const Json good = one_vector("3/4");
  for (std::size_t matrix : {0, 1}) {
    for (std::size_t k : {0, 1, 2}) {
      Json bad = good;
      bad["moving"]["blocks"][0]["images"][matrix][0][0][1][k] = "1/8";
      expect_invalid(by_polytope(tilted("[1/8, 1/4]"), bad), "polytope");
    }
  }
  // Neither end nor the middle may be left out, whatever the unit.
  for (const char* unit : {"0", "-1", "1/1000000000000"}) {
    Json bad = good;
    bad["moving"]["blocks"][0]["images"][0][0][0][1][1] = "11/17";
    bad["moving"]["blocks"][0]["unit"] = unit;
    expect_invalid(by_polytope(tilted("[1/8, 1/4]"), bad), "polytope");
  }
}

TEST(MovingPolytope, OnlyForOneParameterInDegreeOne) {
  expect_invalid(by_polytope(tilted("1/8"), one_vector("3/4")), "polytope");
  const Claim squared{{"w"}, {"1/4+w^2/2", "3/4+w^2/2", "3/4-w^2/2", "1/4-w^2/2"}, "C1", {{"w", "[1/8, 1/4]"}}};
  expect_invalid(by_polytope(squared, one_vector("3/4")), "polytope");
}

TEST(MovingPolytope, ItsForm) {
  const Json good = one_vector("3/4");
  const auto rejected = [&](const Json& bad) { EXPECT_FALSE(check(by_polytope(tilted("[1/8, 1/4]"), bad)).valid) << bad.dump(); };
  for (const char* key : {"bound", "moving"}) {
    Json bad = good;
    bad.erase(key);
    rejected(bad);
  }
  Json both = good;
  both["norm"] = both["moving"];
  rejected(both);
  for (const char* key : {"vectors", "unit", "images"}) {
    Json bad = good;
    bad["moving"]["blocks"][0].erase(key);
    rejected(bad);
    for (const Json& value : {Json(nullptr), Json("x"), Json(7), Json(Json::array()), Json({{{"1"}}}), Json({{{"1", "1", "1"}, {"1", "1", "1"}}})}) {
      bad = good;
      bad["moving"]["blocks"][0][key] = value;
      rejected(bad);
    }
  }
  const auto with_term = [&](const Json& term) {
    Json bad = good;
    bad["moving"]["blocks"][0]["images"][0][0][0] = term;
    rejected(bad);
  };
  with_term(Json::array({0, "5/8"}));
  with_term(Json::array({0, {"5/8", "3/4"}}));
  with_term(Json::array({2, {"5/8", "11/16", "3/4"}}));
  with_term(Json::array({-1, {"5/8", "11/16", "3/4"}}));
  with_term(Json::array({0, {"5/8", "11/16", "3/4"}, {"1", "1", "1"}}));
  with_term(Json::array({0, {"5/8", "11/16", "3/4"}, {"0", "0"}}));
}

}  // namespace
}  // namespace limes::test
