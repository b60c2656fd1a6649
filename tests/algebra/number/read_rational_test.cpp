#include "algebra/number/read_rational.hpp"

#include "algebra/error.hpp"
#include "tests/algebra/generators.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

TEST(ReadRational, ReadsWhatIsSpelled) {
  const std::pair<const char*, const char*> cases[] = {
      {"0", "0"}, {"-12", "-12"}, {"+7", "7"}, {"3/4", "3/4"}, {"-3/6", "-1/2"}, {"0.0141", "141/10000"},
      {".5", "1/2"}, {"5.", "5"}, {"1e-3", "1/1000"}, {"2.5e+2", "250"}, {"1E3", "1000"}, {" 1/3\t", "1/3"},
      {"-0", "0"}, {"007/0014", "1/2"}, {"0.1", "1/10"}, {"0/5", "0"}, {"-0.0", "0"}, {"1e0", "1"},
      {"12345678901234567890123", "12345678901234567890123"}};
  for (const auto& [text, value] : cases) EXPECT_EQ(to_string(read_rational(text)), value) << text;
}

TEST(ReadRational, IsCanonical) {
  const Rational x = read_rational("10/15");
  EXPECT_EQ(numerator(x), 2);
  EXPECT_EQ(denominator(x), 3);
  EXPECT_EQ(read_rational("0.25"), Rational(1) / 4);
}

TEST(ReadRational, RejectsWithTheColumnOfTheFirstWrongCharacter) {
  const std::pair<std::string, int> cases[] = {
      {"", 1}, {"  ", 3}, {"-", 2}, {"--1", 2}, {"+-1", 2}, {"abc", 1}, {"1/0", 3}, {"1/00", 3}, {"1/-2", 3},
      {"1/+2", 3}, {"1/", 3}, {"1 /2", 3}, {"1/ 2", 3}, {"1 2", 3}, {"1.5/2", 4}, {"1/2.5", 4}, {"1/2e3", 4},
      {"1e", 3}, {"1e+", 4}, {"1e2.5", 4}, {".", 2}, {"-.", 3}, {"1..2", 3}, {"0x10", 2}, {"1,5", 2},
      {"1_000", 2}, {"inf", 1}, {"nan", 1}, {"1/2/3", 4}, {"/2", 1}, {"e5", 1}, {"1e2/3", 4}, {"(1)", 1},
      {"- 1", 2}, {"\xc2\xbd", 1}, {std::string("1\0", 2), 2}, {std::string("\0", 1), 1},
      {std::string("1/\0", 3), 3}};
  for (const auto& [text, column] : cases) {
    try {
      const Rational x = read_rational(text);
      ADD_FAILURE() << "'" << text << "' was read as " << to_string(x);
    } catch (const InputError& error) {
      EXPECT_EQ(error.position().column, column) << "'" << text << "': " << error.what();
    }
  }
}

TEST(ReadRational, NamesDivisionByZero) {
  try {
    read_rational("3/0");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.reason(), "division by zero");
  }
}

TEST(ReadRational, LimitsDigitsAndExponents) {
  EXPECT_EQ(read_rational(std::string(10000, '0')), 0);
  EXPECT_THROW(read_rational(std::string(10001, '1')), LimitError);
  EXPECT_THROW(read_rational("1/" + std::string(10000, '1')), LimitError);
  EXPECT_THROW(read_rational("0." + std::string(10000, '1')), LimitError);
  EXPECT_EQ(read_rational("1e10000"), power(Rational(10), 10000));
  EXPECT_EQ(read_rational("1e-10000"), power(Rational(10), -10000));
  EXPECT_THROW(read_rational("1e10001"), LimitError);
  EXPECT_THROW(read_rational("1e-99999999999999999999999999"), LimitError);
}

TEST(ReadRational, ReadsBackWhatIsPrinted) {
  test::Generator generator(4);
  for (int round = 0; round < 200; ++round) {
    const Rational x = generator.rational(1000) * power(Rational(7), generator.integer(-30, 30));
    EXPECT_EQ(read_rational(to_string(x)), x);
  }
}

}  // namespace
}  // namespace limes
