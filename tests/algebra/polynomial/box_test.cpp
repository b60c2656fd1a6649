#include "algebra/polynomial/box.hpp"

#include "algebra/error.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

TEST(Interval, PrintsAndReadsBack) {
  for (const char* text : {"[0, 1/4]", "(0, 21/500]", "(1/15, 1/9)", "[-3, -1/2)", "1/16", "-5"}) {
    EXPECT_EQ(to_string(read_interval(text)), text);
  }
  EXPECT_EQ(to_string(read_interval(" [ 0.1 ,\t1e1 ) ")), "[1/10, 10)");
  EXPECT_EQ(to_string(read_interval("{ 1/16 }")), "1/16");
  EXPECT_EQ(to_string(read_interval("[2, 2]")), "2");
  test::Generator generator(51);
  for (const Interval& interval : generator.box(100, true)) EXPECT_EQ(read_interval(to_string(interval)), interval);
}

TEST(Interval, RejectsWithColumn) {
  const std::pair<const char*, int> cases[] = {
      {"", 1}, {"   ", 1}, {"[", 2}, {"[0, 1", 5}, {"[0 1]", 5}, {"[0, 1}", 6}, {"{1]", 3}, {"[1, 0]", 4},
      {"(1, 1]", 1}, {"[1, 1)", 1}, {"(1, 1)", 1}, {"[a, 1]", 2}, {"[0, b]", 5}, {"[0, 1/0]", 7},
      {"[0, 1, 2]", 6}, {"[, 1]", 2}, {"[0, ]", 5}, {"0, 1", 2}, {"0, 1]", 2}, {"]0, 1[", 1}, {"{}", 2},
      {"{0, 1}", 3}, {"[0; 1]", 6}, {"[[0, 1]]", 2}, {"(0, 1))", 6}, {"[0, inf)", 5}};
  for (const auto& [text, column] : cases) {
    try {
      const Interval interval = read_interval(text);
      ADD_FAILURE() << "'" << text << "' was read as " << to_string(interval);
    } catch (const InputError& error) {
      EXPECT_EQ(error.position().column, column) << "'" << text << "': " << error.what();
    }
  }
  EXPECT_THROW(read_interval("[0, 1e99999]"), LimitError);
}

TEST(Interval, InclusionAgreesWithMembership) {
  // All intervals with ends in 0..3; members are tested at all multiples of 1/2.
  std::vector<Interval> all;
  for (int l = 0; l <= 3; ++l) {
    all.push_back(Interval::point(l));
    for (int u = l + 1; u <= 3; ++u) {
      for (int open = 0; open < 4; ++open) all.push_back({l, u, open % 2 == 1, open >= 2});
    }
  }
  for (const Interval& outer : all) {
    for (const Interval& inner : all) {
      bool included = true;
      for (int k = -1; k <= 7; ++k) {
        const Rational x = Rational(k) / 2;
        included = included && (!inner.contains(x) || outer.contains(x));
      }
      EXPECT_EQ(outer.contains(inner), included) << to_string(outer) << " " << to_string(inner);
    }
  }
}

TEST(Box, BisectTilesTheBox) {
  test::Generator generator(52);
  for (int round = 0; round < 50; ++round) {
    const Box box = generator.box(3);
    const int axis = generator.integer(0, 2);
    const auto [left, right] = bisect(box, axis);
    EXPECT_TRUE(contains(box, left));
    EXPECT_TRUE(contains(box, right));
    EXPECT_TRUE(contains(left, midpoint(box)));
    EXPECT_TRUE(contains(right, midpoint(box)));
    for (int k = 0; k < 20; ++k) {
      const auto x = generator.point_in(box);
      EXPECT_EQ(contains(box, x), contains(left, x) || contains(right, x));
    }
  }
  EXPECT_THROW(bisect({Interval::point(1)}, 0), DomainError);
  EXPECT_THROW(bisect({}, 0), DomainError);
}

TEST(Box, WidestAxisIsRelative) {
  const Box reference = {{0, 100}, {0, 1}, Interval::point(3)};
  EXPECT_EQ(widest_axis({{0, 50}, {0, 1}, Interval::point(3)}, reference), 1);
  EXPECT_EQ(widest_axis({{0, 50}, {0, Rational(1) / 4}, Interval::point(3)}, reference), 0);
  EXPECT_EQ(widest_axis(reference, reference), 0);
  EXPECT_EQ(widest_axis({Interval::point(3)}, {Interval::point(3)}), -1);
  EXPECT_EQ(widest_axis({}, {}), -1);
  EXPECT_THROW(widest_axis({{0, 1}}, {Interval::point(0)}), DomainError);
  EXPECT_THROW(widest_axis({{0, 1}}, {}), DomainError);
}

TEST(Box, NoParameterIsOnePoint) {
  EXPECT_TRUE(is_point(Box{}));
  EXPECT_TRUE(contains(Box{}, Box{}));
  EXPECT_TRUE(contains(Box{}, std::vector<Rational>{}));
  EXPECT_THROW(contains(Box{}, std::vector<Rational>{1}), DomainError);
}

}  // namespace
}  // namespace limes
