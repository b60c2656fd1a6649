#include "reports/tables/compare_table.hpp"

#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

ComputedValue exact(const Rational& x) { return ComputedValue::exact(x); }
ComputedValue enclosed(const Rational& lower, const Rational& upper) { return {Interval{lower, upper}, {}}; }

TEST(CompareWithPrinted, DecimalsAgreeWhenRoundedOrTruncated) {
  const ComputedValue two_thirds = exact(Rational(2) / 3);
  EXPECT_TRUE(compare_with_printed("0.6667", two_thirds).agrees);
  EXPECT_TRUE(compare_with_printed("0.6666", two_thirds).agrees);
  EXPECT_TRUE(compare_with_printed(".66667", two_thirds).agrees);
  EXPECT_TRUE(compare_with_printed("6.667e-001", two_thirds).agrees);
  EXPECT_FALSE(compare_with_printed("0.6665", two_thirds).agrees);
  EXPECT_FALSE(compare_with_printed("-0.6667", two_thirds).agrees);
  EXPECT_FALSE(compare_with_printed("6.667e-2", two_thirds).agrees);
}

TEST(CompareWithPrinted, CountsDigitsThatAgree) {
  const ComputedValue x = exact(Rational(123456) / 1000);
  EXPECT_EQ(compare_with_printed("123.456", x).digits, 6);
  EXPECT_EQ(compare_with_printed("123.457", x).digits, 5);
  EXPECT_EQ(compare_with_printed("123.999", x).digits, 3);
  EXPECT_EQ(compare_with_printed("123.999", x).printed_digits, 6);
  EXPECT_EQ(compare_with_printed("999.999", x).digits, 0);
  EXPECT_EQ(compare_with_printed("0.0012", exact(Rational(12) / 10000)).printed_digits, 2);
}

TEST(CompareWithPrinted, TheWholeEnclosureMustAgree) {
  EXPECT_TRUE(compare_with_printed("0.33", enclosed(Rational(331) / 1000, Rational(335) / 1000)).agrees);
  EXPECT_FALSE(compare_with_printed("0.33", enclosed(Rational(331) / 1000, Rational(341) / 1000)).agrees);
  EXPECT_TRUE(compare_with_printed("1", enclosed(Rational(9999999) / 10000000, Rational(1))).agrees);
  EXPECT_FALSE(compare_with_printed("1", enclosed(Rational(999) / 1000, Rational(1))).agrees);
  EXPECT_FALSE(compare_with_printed("1/3", enclosed(Rational(333) / 1000, Rational(334) / 1000)).agrees) << "not known to be 1/3";
}

TEST(CompareWithPrinted, ExactNumbersFormulasVerdictsAndInequalities) {
  EXPECT_TRUE(compare_with_printed("-1/16", exact(Rational(-1) / 16)).agrees);
  EXPECT_FALSE(compare_with_printed("1", exact(Rational(999999999) / 1000000000)).agrees) << "an integer is exact";
  const ComputedValue formula = ComputedValue::formula(read_rational_function("-3*w-1/16", {"w"}), {"w"});
  EXPECT_TRUE(compare_with_printed("-3w - 1/16", formula).agrees);
  EXPECT_FALSE(compare_with_printed("-3w - 1/15", formula).agrees);
  EXPECT_TRUE(compare_with_printed("C2 for w in (0..0.042]", {Outcome::certified, {}}).agrees);
  EXPECT_FALSE(compare_with_printed("C2 for w in (0..0.042]", {Outcome::undecided, {}}).agrees);
  EXPECT_TRUE(compare_with_printed("refuted", {Outcome::refuted, {}}).agrees);
  EXPECT_FALSE(compare_with_printed("certified", {Outcome::refuted, {}}).agrees);
  EXPECT_TRUE(compare_with_printed("< 1", exact(Rational(99) / 100)).agrees);
  EXPECT_FALSE(compare_with_printed("< 1", exact(1)).agrees);
  EXPECT_TRUE(compare_with_printed("<= 1", exact(1)).agrees);
  EXPECT_FALSE(compare_with_printed("> 1/2", enclosed(Rational(49) / 100, Rational(51) / 100)).agrees);
  EXPECT_THROW(compare_with_printed("about a third", exact(Rational(1) / 3)), InputError);
}

TEST(ComputedValue, PrintsGuaranteedDigitsOnly) {
  EXPECT_EQ(to_string(exact(Rational(3) / 4)), "3/4");
  EXPECT_EQ(to_string(enclosed(Rational(12341) / 100000, Rational(12342) / 100000)), "0.1234");
  EXPECT_EQ(to_string(enclosed(Rational(1) / 10, Rational(9) / 10)), "[0.1, 0.9]");
}

constexpr const char* table = R"(name = "t"
source = "Chaikin1974"
[[entries]]
entry = "Chaikin"
published = ["1/4", "0.70", "3/4", "1/4"]
computed = ["", "3/4", "", ""]
command = "show chaikin"
pick = "mask"
erratum = "misprint"
[[entries]]
entry = "norm"
published = "1/2"
command = "norm chaikin --order 0 --level 1"
)";

TEST(CompareTable, StatusesOfRows) {
  const ComparedTable compared = compare_table(read_published_table(table, "t.toml"), {});
  ASSERT_EQ(compared.rows.size(), 5u);
  EXPECT_EQ(compared.rows[0].status, RowStatus::match);
  EXPECT_EQ(compared.rows[1].status, RowStatus::erratum);
  EXPECT_EQ(compared.rows[1].reason, "misprint");
  EXPECT_EQ(compared.rows[1].entry, "Chaikin [1]");
  EXPECT_EQ(compared.rows[4].status, RowStatus::match);
}

std::string altered(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

RowStatus status_of_row(const std::string& text, std::size_t row) {
  return compare_table(read_published_table(text, "t.toml"), {}).rows.at(row).status;
}

TEST(CompareTable, RegressionsAreFound) {
  EXPECT_EQ(status_of_row(altered(table, "\"3/4\", \"\"", "\"5/7\", \"\""), 1), RowStatus::regression) << "another stored value";
  EXPECT_EQ(status_of_row(altered(table, "computed = [\"\", \"3/4\", \"\", \"\"]\n", ""), 1), RowStatus::regression) << "nothing is stored";
  EXPECT_EQ(status_of_row(altered(table, "erratum = \"misprint\"\n", ""), 1), RowStatus::regression) << "no erratum";
  EXPECT_EQ(status_of_row(altered(table, "published = \"1/2\"", "published = \"1/3\""), 4), RowStatus::regression);
}

std::string error_of(const std::string& text) {
  try {
    compare_table(read_published_table(text, "t.toml"), {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CompareTable, ErrorsNameFileAndLine) {
  EXPECT_EQ(error_of(altered(table, "order 0", "order x")).substr(0, 9), "t.toml:10");
  EXPECT_NE(error_of(altered(table, "show chaikin", "shew chaikin")).find("t.toml:3: no table can use the verb 'shew'"), std::string::npos);
  EXPECT_NE(error_of(altered(table, "pick = \"mask\"", "pick = \"mask[9]\"")).find("does not exist"), std::string::npos);
  EXPECT_NE(error_of(altered(table, "pick = \"mask\"", "pick = \"mass\"")).find("computes no 'mass'"), std::string::npos);
  EXPECT_NE(error_of(altered(table, "pick", "pluck")).find("unknown key 'pluck'"), std::string::npos);
  EXPECT_NE(error_of(altered(table, ", \"\"]", "]")).find("'computed' has 3 elements, 'published' has 4"), std::string::npos);
  EXPECT_NE(error_of(altered(table, "show chaikin", "show 'chaikin")).find("not closed"), std::string::npos);
  EXPECT_NE(error_of(altered(table, "--level 1", "--level")).find("--level needs a value"), std::string::npos);
}

TEST(CompareTable, StopKeepsWhatIsFinished) {
  const std::atomic<bool> flag{true};
  const Stop stop(&flag);
  const std::string slow = altered(table, "norm chaikin --order 0 --level 1", "norm twelve-point --order 5 --level 12");
  const ComparedTable compared = compare_table(read_published_table(slow, "t.toml"), stop);
  EXPECT_TRUE(compared.interrupted);
  EXPECT_EQ(compared.rows.size(), 4u);
}

}  // namespace
}  // namespace limes
