#include "proofs/checker/characteristic_map.hpp"

#include "tests/checker/certificates.hpp"

#include <cmath>
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

/// Limits of polynomial data are known: of j^2 by the cubic spline x^2 + 1/3, of j^3 by the four-point scheme x^3, of j^2 by
/// the quadratic spline (x - 1/2)^2 + 1/4, in its indices from the left end of a cell on.
TEST(CurveLimits, EveryCellContainsTheLimit) {
  using limes::checker::CurveLimits, limes::checker::Enclosure, limes::checker::Grid;
  using Function = std::function<double(double)>;
  struct Case {
    std::vector<mpq_class> mask;
    bool dual;
    int power;
    Function value, slope;
  };
  const auto q = [](int x, int y) { return mpq_class(x, y); };
  const Case cases[] = {
      {{q(1, 8), q(1, 2), q(3, 4), q(1, 2), q(1, 8)}, false, 2, [](double x) { return x * x + 1. / 3; }, [](double x) { return 2 * x; }},
      {{q(-1, 16), 0, q(9, 16), 1, q(9, 16), 0, q(-1, 16)}, false, 3, [](double x) { return x * x * x; },
       [](double x) { return 3 * x * x; }},
      {{q(1, 4), q(3, 4), q(3, 4), q(1, 4)}, true, 2, [](double x) { return (x - 0.5) * (x - 0.5) + 0.25; },
       [](double x) { return 2 * x - 1; }}};
  for (const Case& c : cases) {
    Budget budget;
    const CurveLimits limits(c.mask, c.dual, budget);
    const auto power = [&](int j) {
      mpq_class result = 1;
      for (int k = 0; k < c.power; ++k) result *= j;
      return result;
    };
    // f(x, y) = g(x) g(y)
    const auto check = [&](CurveLimits::Part part, int da, int db, const Function& along_a, const Function& along_b) {
      const auto data = [&](int a, int b) {
        return Enclosure(mpq_class((da ? power(a + 1) - power(a) : power(a)) * (db ? power(b + 1) - power(b) : power(b))));
      };
      double widest = 1e300;
      for (int level = 0; level <= 3; ++level) {
        const Grid grid = limits.on_annulus(data, part, level);
        EXPECT_EQ(grid.first_a, limits.reach() << level);
        EXPECT_EQ(grid.last_a(), ((2 * limits.reach()) << level) - 1);
        double width = 0;
        for (int a = grid.first_a; a <= grid.last_a(); ++a) {
          for (int b = 0; b <= a; ++b) {
            const double low = std::ldexp(double(grid.at(a, b).lower), -40), high = std::ldexp(double(grid.at(a, b).upper), -40);
            width = std::max(width, high - low);
            for (const double s : {0., 0.25, 1.}) {
              for (const double t : {0., 0.5, 1.}) {
                const double limit = along_a(std::ldexp(a + s, -level)) * along_b(std::ldexp(b + t, -level));
                EXPECT_LE(low, limit + 1e-9) << a << " " << b;
                EXPECT_GE(high, limit - 1e-9) << a << " " << b;
              }
            }
          }
        }
        EXPECT_LT(width, 0.7 * widest);
        widest = width;
      }
    };
    check(CurveLimits::Part::value, 0, 0, c.value, c.value);
    check(CurveLimits::Part::by_a, 1, 0, c.slope, c.value);
    check(CurveLimits::Part::by_b, 0, 1, c.value, c.slope);
  }
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
  for (const int level : {0, 2, 5}) expect_invalid(smooth_at(folded("1"), 5, "9/20", 3, level), "map");
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
