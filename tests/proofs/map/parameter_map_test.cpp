#include "proofs/map/parameter_map.hpp"

#include "algebra/error.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/map/map_journal.hpp"
#include "proofs/map/map_unions.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

namespace limes {
namespace {

Scheme load(const std::string& name) { return Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name); }

MapOptions within(const std::string& tolerance) { return {.tolerance = Rational(read_interval(tolerance).lower)}; }

/// "refuted 0; certified (0, 1/8]; ..", each union proved by one certificate that the checker accepts.
std::string text(const Scheme& scheme, const ParameterMap& map) {
  std::string result;
  for (const MapUnion& one : map_unions(map.cells, scheme.parameter_names())) {
    result += (result.empty() ? "" : "; ") + to_string(one.verdict);
    for (const Interval& interval : one.region) result += " " + to_string(interval);
    if (one.verdict == Outcome::undecided) continue;
    EXPECT_EQ(one.parts.size(), 1u);
    for (const MapCell& part : one.parts) EXPECT_TRUE(checker::check(part.certificate).valid);
  }
  return result;
}

/// The cells make up the region: their measures add up and they lie inside.
void expect_partition(const ParameterMap& map, const Box& region) {
  Rational sum = 0;
  Rational unknown = 0;
  for (const MapCell& cell : map.cells) {
    EXPECT_TRUE(contains(region, cell.region));
    sum += measure(cell.region);
    if (cell.verdict == Outcome::undecided) unknown += measure(cell.region);
    EXPECT_EQ(cell.certificate.empty(), cell.verdict == Outcome::undecided);
  }
  EXPECT_EQ(sum, measure(region));
  EXPECT_EQ(unknown, map.unknown_measure);
}

TEST(ParameterMap, RationalBoundariesAreFoundExactly) {
  // Hassan, Ivrissimtzis, Dodgson & Sabin 2002: C^2 exactly for 1/15 < mu < 1/9.
  const Scheme scheme = load("ternary-four-point");
  const ParameterMap map = map_parameters(scheme, 2, scheme.parameter_box(), within("1/1000"));
  EXPECT_TRUE(map.complete);
  EXPECT_EQ(map.unknown_measure, 0);
  expect_partition(map, scheme.parameter_box());
  EXPECT_EQ(text(scheme, map), "refuted [-1/3, 1/15]; certified (1/15, 1/9); refuted [1/9, 1/3]");
}

TEST(ParameterMap, AClosedEndInTheLimitOfSmallRatios) {
  // A^{1,3:1}: at w = 1/8 an eigenvalue at an isolated knot ratio tends to 1/2 with the ratio to 0, and is never there.
  const Scheme scheme = load("a1-3-1");
  const ParameterMap map = map_parameters(scheme, 1, scheme.parameter_box(), within("1/1000"));
  EXPECT_TRUE(map.complete);
  expect_partition(map, scheme.parameter_box());
  std::string certified;
  for (const MapUnion& one : map_unions(map.cells, scheme.parameter_names())) {
    if (one.verdict == Outcome::certified) certified += to_string(one.region[0]);
    for (const MapCell& part : one.parts) EXPECT_TRUE(checker::check(part.certificate).valid);
  }
  EXPECT_EQ(certified, "(0, 1/8]");
}

TEST(ParameterMap, AlgebraicBoundariesAreEnclosed) {
  // Hechler, Moessner & Reif 2009: C^1 exactly for 0 < w < w*, 32 w*^3 + 4 w* = 1.
  const Scheme scheme = load("four-point");
  const ParameterMap map = map_parameters(scheme, 1, scheme.parameter_box(), within("1/500"));
  EXPECT_TRUE(map.complete);
  expect_partition(map, scheme.parameter_box());
  const auto defect = [](const Rational& w) { return 32 * w * w * w + 4 * w - 1; };
  for (const MapUnion& one : map_unions(map.cells, scheme.parameter_names())) {
    const Interval& w = one.region[0];
    if (one.verdict == Outcome::certified) {
      EXPECT_EQ(w.lower, 0);
      EXPECT_TRUE(w.lower_open);
      EXPECT_LT(defect(w.upper), 0);
    } else if (one.verdict == Outcome::refuted && w.upper > 0) {
      EXPECT_GE(defect(w.lower), 0);
      EXPECT_EQ(w.upper, Rational(1) / 4);
    }
  }
}

TEST(ParameterMap, AMissingFactorRefutesAllButIsolatedValues) {
  // Only w = 1/16 has four factors 1 + z, and is not C^3 either.
  const Scheme scheme = load("four-point");
  const ParameterMap map = map_parameters(scheme, 3, scheme.parameter_box(), within("1/500"));
  EXPECT_EQ(text(scheme, map), "refuted [0, 1/4]");
}

TEST(ParameterMap, TwoParameters) {
  // All symmetric interpolatory 6-point schemes; v = 0 is four-point, and of it the part up to w* is C^1.
  const Scheme scheme = read_scheme(R"(name = "two"
kind = "uniform"
[parameters]
v = ["0", "1/16"]
w = ["1/20", "1/8"]
[uniform]
mask = ["v", "0", "-w", "0", "1/2+w-v", "1", "1/2+w-v", "0", "-w", "0", "v"]
)", "two.toml");
  const ParameterMap map = map_parameters(scheme, 1, scheme.parameter_box(), within("1/1000"));
  EXPECT_TRUE(map.complete);
  expect_partition(map, scheme.parameter_box());
  for (const MapUnion& one : map_unions(map.cells, scheme.parameter_names())) {
    for (const MapCell& part : one.parts) EXPECT_TRUE(checker::check(part.certificate).valid);
  }
}

TEST(ParameterMap, AskedForTheImpossible) {
  const Scheme scheme = load("four-point");
  EXPECT_THROW(map_parameters(scheme, 1, {Interval::point(1)}, within("1")), InputError);
  EXPECT_THROW(map_parameters(scheme, 1, scheme.parameter_box(), {.tolerance = 0}), InputError);
}

class Journal : public testing::Test {
 protected:
  Journal() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    file = std::filesystem::path(testing::TempDir()) / fmt::format("limes-{}.journal", test->name());
    std::filesystem::remove(file);
  }
  ~Journal() override { std::filesystem::remove(file); }

  /// Runs the search with the journal; how many cells were not answered by it.
  int run(ParameterMap& map) {
    MapJournal journal(file, scheme, 2, scheme.parameter_box(), options);
    std::atomic<int> fresh = 0;
    map = map_parameters(scheme, 2, scheme.parameter_box(), options,
                         {.find = [&](const Box& cell) { return journal.find(cell); },
                          .record = [&](const MapRecord& record) { ++fresh, journal.append(record); },
                          .progress = {}});
    return fresh;
  }

  std::string content() const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void rewrite(const std::string& text) const { std::ofstream(file, std::ios::binary | std::ios::trunc) << text; }

  std::filesystem::path file;
  Scheme scheme = load("ternary-four-point");
  MapOptions options = within("1/1000");
};

TEST_F(Journal, AnswersForEveryCellOfAnEarlierRun) {
  ParameterMap first, second;
  const int cells = run(first);
  EXPECT_GT(cells, 3);
  EXPECT_EQ(run(second), 0);
  EXPECT_EQ(text(scheme, first), text(scheme, second));
}

TEST_F(Journal, WhereverTheFileEndsTheRestIsFoundAgain) {
  ParameterMap whole, rest;
  const int cells = run(whole);
  const std::string text_of_whole = content();
  std::set<int> counts;
  for (std::size_t k = 1; k <= 8; ++k) {
    // A kill leaves any beginning of the file.
    rewrite(text_of_whole.substr(0, text_of_whole.size() * k / 8 - (k < 8 ? 0 : 1)));
    const int fresh = run(rest);
    EXPECT_GT(fresh, 0);
    EXPECT_LE(fresh, cells);
    counts.insert(fresh);
    EXPECT_EQ(text(scheme, rest), text(scheme, whole));
  }
  EXPECT_GT(counts.size(), 2u);
}

TEST_F(Journal, BelongsToOneMap) {
  ParameterMap map;
  run(map);
  options = within("1/2000");
  EXPECT_THROW(run(map), InputError);
  options = within("1/1000");
  scheme = load("four-point");
  EXPECT_THROW(run(map), InputError);
}

TEST_F(Journal, WhatItSaysIsCheckedAgain) {
  ParameterMap map;
  run(map);
  const std::string good = content();
  const auto expect_rejected = [&](const std::string& from, const std::string& to) {
    std::string bad = good;
    const std::size_t at = bad.find(from, bad.find('\n'));
    ASSERT_NE(at, std::string::npos) << from;
    bad.replace(at, from.size(), to);
    rewrite(bad);
    EXPECT_THROW(run(map), InputError) << from << " -> " << to;
  };
  expect_rejected("\"level\":", "\"levle\":");
  expect_rejected("\"verdict\":\"certified\",\"certificate\"", "\"verdict\":\"refuted\",\"certificate\"");
  expect_rejected("not C2", "not C3");
  expect_rejected("13/18", "14/18");
  expect_rejected("\"pieces\":[{", "\"pieces\":[],\"more\":[{");
  expect_rejected("{\"cell\"", "{\"sell\"");
}

TEST_F(Journal, IsUsedByOneRunAtATime) {
  const MapJournal first(file, scheme, 2, scheme.parameter_box(), options);
  EXPECT_THROW(MapJournal(file, scheme, 2, scheme.parameter_box(), options), InputError);
}

}  // namespace
}  // namespace limes
