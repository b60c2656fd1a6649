#include "algebra/error.hpp"
#include "algebra/stop.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

TEST(InputError, PrintsThePartsThatAreKnown) {
  EXPECT_STREQ(InputError("bad").what(), "bad");
  EXPECT_STREQ(InputError("bad", {"a.toml", 3, 5}).what(), "a.toml:3:5: bad");
  EXPECT_STREQ(InputError("bad", {"a.toml", 3, 0}).what(), "a.toml:3: bad");
  EXPECT_STREQ(InputError("bad", {"a.toml", 0, 0}).what(), "a.toml: bad");
  EXPECT_STREQ(InputError("bad", {"", 0, 5}).what(), "column 5: bad");
  EXPECT_STREQ(InputError("bad", {"", 3, 5}).what(), "line 3, column 5: bad");
}

TEST(InputError, LocatedKeepsTheInnerColumnInTheReason) {
  const InputError moved = InputError("expected a digit", {"", 0, 5}).located("a.toml", 12);
  EXPECT_STREQ(moved.what(), "a.toml:12: column 5: expected a digit");
  EXPECT_EQ(moved.position().line, 12);
  EXPECT_STREQ(InputError("bad").located("a.toml", 0).what(), "a.toml: bad");
}

TEST(Stop, StopsByFlagOrByDeadlineOnly) {
  EXPECT_FALSE(Stop().requested());
  EXPECT_NO_THROW(Stop().check());
  std::atomic<bool> flag = false;
  const Stop by_flag(&flag);
  EXPECT_FALSE(by_flag.requested());
  flag = true;
  EXPECT_TRUE(by_flag.requested());
  EXPECT_THROW(by_flag.check(), Interrupted);
  EXPECT_THROW(Stop(nullptr, 0.0).check(), Interrupted);
  EXPECT_TRUE(Stop(nullptr, -1.0).requested());
  EXPECT_FALSE(Stop(nullptr, 3600.0).requested());
  EXPECT_FALSE(Stop(nullptr, 1e300).requested());
}

}  // namespace
}  // namespace limes
