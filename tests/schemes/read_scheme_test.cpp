#include "schemes/scheme.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

const std::string four_point = R"(name = "my-four-point"
kind = "uniform"
[parameters]
w = ["0", "1/4"]
[uniform]
mask = ["-w", "0", "1/2+w", "1", "1/2+w", "0", "-w"]
[[claims]]
claim = "C1"
region = { w = "(0, 37/200]" }
)";

/// The message for a text, or "accepted".
std::string failure(const std::string& text) {
  try {
    read_scheme(text, "my.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(ReadScheme, ReadsWhatTheFileSays) {
  const Scheme scheme = read_scheme(four_point, "my.toml");
  EXPECT_EQ(scheme.name, "my-four-point");
  ASSERT_EQ(scheme.parameters.size(), 1u);
  EXPECT_EQ(scheme.parameters[0].name, "w");
  EXPECT_EQ(scheme.mask.arity, 2);
  EXPECT_EQ(scheme.mask.symbol.lowest(), -3);
  ASSERT_EQ(scheme.claims.size(), 1u);
  EXPECT_EQ(statement(scheme.claims[0]), "C1");
  EXPECT_TRUE(scheme.claims[0].region[0].lower_open);
  EXPECT_EQ(scheme.claims[0].region[0].upper, Rational(37) / 200);
  EXPECT_EQ(scheme.claims[0].expected, Outcome::certified);
}

TEST(ReadScheme, DecimalsAreExact) {
  const Scheme scheme = read_scheme(replaced(four_point, "(0, 37/200]", "(0, 0.1]"), "my.toml");
  EXPECT_EQ(scheme.claims[0].region[0].upper, Rational(1) / 10);
}

TEST(ReadScheme, ParametersKeepTheOrderOfTheFile) {
  const Scheme scheme = read_scheme(replaced(four_point, "w = [\"0\", \"1/4\"]", "w = [\"0\", \"1/4\"]\na = [\"0\", \"1\"]"), "my.toml");
  ASSERT_EQ(scheme.parameters.size(), 2u);
  EXPECT_EQ(scheme.parameters[0].name, "w");
  EXPECT_EQ(scheme.parameters[1].name, "a");
  EXPECT_EQ(scheme.claims[0].region[1], (Interval{0, 1}));
}

TEST(ReadScheme, SmoothnessIsShortForTheClaim) {
  const Scheme scheme = read_scheme(replaced(four_point, "claim = \"C1\"", "smoothness = 1"), "my.toml");
  EXPECT_EQ(statement(scheme.claims[0]), "C1");
}

TEST(ReadScheme, EveryErrorNamesFileLineAndReason) {
  const struct {
    std::string from, to, message;
  } cases[] = {
      {"kind = \"uniform\"", "kind = \"unifrom\"", "my.toml:2: unknown kind 'unifrom'"},
      {"kind = \"uniform\"", "kind = \"uniform\"\ncolour = 3", "my.toml:3: unknown key 'colour' in the scheme file"},
      {"[uniform]", "[uniform]\nmusk = 1", "my.toml:6: unknown key 'musk'"},
      {"name = \"my-four-point\"", "name = \"a/b\"", "my.toml:1: 'name' consists of"},
      {"name = \"my-four-point\"", "", "has no key 'name'"},
      {"\"1/2+w\"", "\"1/2+v\"", "unknown name 'v'"},
      {"\"1/2+w\"", "\"1/2+\"", "mask[2]"},
      {"\"1/2+w\"", "\"1/(w-w)\"", "zero"},
      {"\"1/2+w\"", "0.5", "mask[2] must be a string"},
      {"w = [\"0\", \"1/4\"]", "w = [0, 0.25]", "must be two strings"},
      {"w = [\"0\", \"1/4\"]", "w = [\"1/4\", \"0\"]", "lower end exceeds the upper end"},
      {"w = [\"0\", \"1/4\"]", "w = [\"0\", \"1/0\"]", "division by zero"},
      {"(0, 37/200]", "(0, 1/2]", "my.toml:9: the region w = (0, 1/2] exceeds the parameter's range [0, 1/4]"},
      {"region = { w", "region = { v", "unknown key 'v' in region"},
      {"claim = \"C1\"", "claim = \"C-1\"", "expected \"C<m>\""},
      {"claim = \"C1\"", "claim = \"C99\"", "smoothness above 64"},
      {"claim = \"C1\"", "claim = \"C1\"\nexpect = \"refuted\"", "needs an 'erratum'"},
      {"claim = \"C1\"", "claim = \"C1\"\nexpect = \"perhaps\"", "'expect' is"},
      {"claim = \"C1\"", "claim = \"C1\"\nsmoothness = 1", "exactly one of"},
      {"[uniform]", "[uniform]\narity = 1", "'arity' must be an integer from 2 to 16"},
      {"[uniform]", "[uniform]\nrule = \"at(f(3,0),1/2)\"", "exactly one of 'mask' and 'rule'"},
      {"mask = [", "mask = [[", "my.toml:"},
      {"[parameters]", "[parameters", "my.toml:"},
  };
  for (const auto& c : cases) {
    const std::string message = failure(replaced(four_point, c.from, c.to));
    EXPECT_NE(message.find(c.message), std::string::npos) << c.to << " gave: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with("my.toml:")) << message;
  }
}

TEST(ReadScheme, HostileFilesAreRefused) {
  EXPECT_NE(failure(replaced(four_point, "\"1/2+w\"", "\"" + std::string(1000, '(') + "\"")), "accepted");
  EXPECT_NE(failure(replaced(four_point, "\"1/2+w\"", "\"((1+w)^1000)^1000\"")), "accepted");
  EXPECT_NE(failure(replaced(four_point, "\"1/2+w\"", "\"" + std::string(20000, '9') + "\"")), "accepted");
  EXPECT_NE(failure(std::string(5 << 20, '#')), "accepted");
  EXPECT_NE(failure(std::string("name = \"a\0b\"", 12)), "accepted");
  EXPECT_NE(failure(""), "accepted");
  EXPECT_NE(failure("name = \"x\"\nkind = \"uniform\"\n[uniform]\nmask = [\"0\", \"0\"]\n"), "accepted");
  EXPECT_NE(failure("x = " + std::string(100000, '[')), "accepted");
}

TEST(ReadScheme, AMissingFileIsAnInputError) { EXPECT_THROW(read_scheme_file("/nonexistent.toml"), InputError); }

}  // namespace
}  // namespace limes
