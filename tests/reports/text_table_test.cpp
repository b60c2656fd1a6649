#include "reports/text_table.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

TEST(TextTable, AlignsAndTrims) {
  TextTable table({{"scheme"}, {"n", 3, TextTable::Align::right}, {"note"}});
  table.fit(0, "four-point");
  EXPECT_EQ(table.header(), "scheme        n  note\n---------------------\n");
  EXPECT_EQ(table.row({"chaikin", "7", ""}), "chaikin       7\n");
  EXPECT_EQ(table.row({"a-name-that-is-too-long", "12", "x"}), "a-name-that-is-too-long   12  x\n");
}

}  // namespace
}  // namespace limes
