#include "algebra/error.hpp"
#include "schemes/scheme.hpp"
#include "tests/schemes/nonuniform/rules.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

std::string read(const std::string& let, const std::string& rule, int points = 6) {
  const std::string text =
      "name = \"mine\"\nkind = \"nonuniform\"\n[parameters]\nw = [\"0\", \"1\"]\n[nonuniform]\npoints = " +
      std::to_string(points) + "\n[nonuniform.let]\n" + let + "\n[nonuniform.rule]\n" + rule + "\n";
  try {
    read_scheme(text, "mine.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string read_new(const std::string& rule, int points = 6) { return read("", "new = \"" + rule + "\"", points); }

void expect_message(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << part << "\nis not in\n" << message;
  EXPECT_TRUE(message.starts_with("mine.toml:")) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(RuleErrors, NamesAndFunctions) {
  expect_message(read_new("at(g, 1/2)"), "mine.toml:10: new: column 4: unknown name 'g' (known: w)");
  expect_message(read("s = \"f(3,0)\"", "new = \"at(v, 1/2)\""),
                 "mine.toml:10: new: column 4: unknown name 'v' (known: w, s)");
  expect_message(read_new("lerp(f(3,0), 1/2)"), "unknown function 'lerp' (known: f, hermite");
  expect_message(read("w = \"1\"", "new = \"at(f(3,0),1/2)\""), "mine.toml:8: w: 'w' names a parameter");
  expect_message(read("at = \"1\"", "new = \"at(f(3,0),1/2)\""),
                 "mine.toml:8: at: 'at' is a function of the vocabulary");
  expect_message(read("\"a b\" = \"1\"", "new = \"at(f(3,0),1/2)\""), "no name");
  expect_message(read_new("at(f(3,0)"), "mine.toml:10: new: column 10: expected");
}

TEST(RuleErrors, CyclesAreNamed) {
  expect_message(read("a = \"degree(5, b)\"\nb = \"1*c\"\nc = \"2*a\"", "new = \"at(a, 1/2)\""),
                 "the definitions form a cycle: a -> b -> c -> a");
  expect_message(read("a = \"a\"", "new = \"at(f(3,0), 1/2)\""),
                 "mine.toml:8: a: the definitions form a cycle: a -> a");
  expect_message(read("x = \"y+1\"\ny = \"x-1\"", "new = \"x*at(f(3,0), 1/2)\""), "cycle: x -> y -> x");
}

TEST(RuleErrors, MistakesInDefinitionsThatNobodyUses) {
  expect_message(read("good = \"f(3,0)\"\nbad = \"degree(2, good)\"", "new = \"at(f(1,0), 1/2)\""),
                 "mine.toml:9: bad: column 8: the segment has degree 3 already");
}

TEST(RuleErrors, KindsOfArguments) {
  expect_message(read_new("f(3,0)"), "a rule must be a point");
  expect_message(read_new("w"), "a rule must be a point");
  expect_message(read_new("at(w, 1/2)"), "expected a segment, not a number");
  expect_message(read_new("at(at(f(3,0),1/2), 1/2)"), "expected a segment, not a point");
  expect_message(read_new("at(f(3,0), w)"), "expected a number without parameters");
  expect_message(read_new("at(f(3,0), f(1,0))"), "expected a number");
  expect_message(read_new("at(f(w,0), 1/2)"), "expected a number without parameters");
  expect_message(read_new("at(f(3/2,0), 1/2)"), "the degree of f must be an integer from 0 to 63");
  expect_message(read_new("again(f(3,0))"), "expected a point");
  expect_message(read_new("dot(1/2, f(3,0))"), "expected a list");
  expect_message(read_new("dot([1/2,1/2], f(3,0))"),
                 "the list has 2 numbers, the segment of degree 3 has 4 coefficients");
  expect_message(read_new("[1]"), "a list stands in dot");
  expect_message(read_new("at(f(3,0)+f(2,0),1/2)"), "cannot add segments of degree 3 in 1 and degree 2 in 1 pieces");
  expect_message(read_new("at(f(3,0),1/2)+1"), "cannot add a number to a sampled point");
  expect_message(read_new("at(f(3,0),1/2)+f(3,0)"), "cannot add a segment to a sampled point: sample it");
  expect_message(read_new("at(f(3,0),1/2)*at(f(3,0),1/2)"), "cannot multiply two sampled points");
  expect_message(read_new("at(f(3,0),1/2)/at(f(3,0),1/2)"), "cannot divide by a sampled point");
  expect_message(read_new("at(f(3,0),1/2)/(w-w)"), "division by zero");
  expect_message(read_new("at(f(3,0),1/2)^2"), "makes no sense");
  expect_message(read_new("at(tension(w, f(2,0)), 1/2)"), "tension needs a segment of odd degree, not 2");
  expect_message(read_new("at(join(2, f(3,0)), 1/2)"),
                 "join(2, S) needs a segment of degree 4 at least, not 3: degree(4, S)");
  expect_message(read_new("at(join(4, degree(8,f(3,0))), 1/2)"), "the order of join must be an integer from 1 to 3");
  expect_message(read_new("at(split(2, f(5,0), 2), 1/2)"), "2 pieces of degree 3 that join C2 do not suffice");
  expect_message(read_new("at(join(2, split(3, f(3,0))), 1/2)"), "expected a segment in one piece, not in 4");
  expect_message(read_new("at(hermite(1, f(2,0)), 1/2)"), "hermite takes three arguments");
}

TEST(RuleErrors, PointsOutsideOfTheStencil) {
  expect_message(
      read_new("at(f(5,0), 1/2)", 4),
      "the rule needs points = 6 at least: it depends on p_(i-2) .. p_(i+3), not only on p_(i-1) .. p_(i+2)");
  expect_message(read_new("at(f(3,1), 1/2)", 4), "needs points = 6 at least");
  expect_message(read_new("at(join(2, degree(4, f(3,0))), 1/2)", 4), "needs points = 6 at least");
  expect_message(read_new("again(at(f(3,0), 1/2))", 4), "needs points = 6 at least");
  expect_message(read_new("again(again(at(f(3,0), 1/2)))", 6), "needs points = 8 at least");
  EXPECT_EQ(read_new("at(f(1,0), 1/2)", 64), "accepted");
}

TEST(RuleErrors, Coefficients) {
  const auto with = [](const std::string& e) {
    return read("", "coefficients = [\"-w*b1\", \"1/2\", \"1/2\", \"" + e + "\"]", 4);
  };
  EXPECT_EQ(with("w*b1/(1+b2)"), "accepted");
  EXPECT_EQ(with("w*b1/((1-2*w)*(b1+b2))"), "accepted");
  expect_message(with("1/(b1-b2)"), "mine.toml:10: coefficients[3]: the denominator must be a product");
  expect_message(with("1/(b1+w)"), "the denominator must be a product");
  expect_message(with("b3"), "unknown name 'b3' (known: w, b1, b2)");
  expect_message(with("at(f(3,0),1/2)"), "a function such as 'at' is not allowed here");
  expect_message(read("", "coefficients = [\"1/2\", \"1/2\"]", 4),
                 "must have as many entries as there are points, 4, not 2");
  expect_message(read("", "coefficients = [1]", 4), "must be a string");
  expect_message(read("s = \"f(3,0)\"", "coefficients = [\"0\", \"1/2\", \"1/2\", \"0\"]", 4),
                 "only numbers are defined");
  expect_message(read("", "coefficients = []", 4), "non-empty array");
}

TEST(RuleErrors, TheFile) {
  expect_message(read("", "", 6), "exactly one of 'new' and 'coefficients'");
  expect_message(read("", "new = \"at(f(1,0),1/2)\"\nold = \"1\"", 6),
                 "mine.toml:11: unknown key 'old' in [nonuniform.rule]");
  expect_message(read("", "new = 1", 6), "must be a string");
  expect_message(read("s = 3", "new = \"at(f(1,0),1/2)\"", 6), "s must be a string");
  expect_message(read_new("at(f(1,0),1/2)", 5), "mine.toml:6: 'points' must be even");
  expect_message(read_new("at(f(1,0),1/2)", 66), "'points' must be an integer from 2 to 64");
}

TEST(RuleErrors, HostileRulesAreRefused) {
  // Each definition doubles the number: refused before it is expanded.
  std::string doubling = "a0 = \"1+w\"\n";
  for (int k = 1; k <= 40; ++k)
    doubling += "a" + std::to_string(k) + " = \"a" + std::to_string(k - 1) + "*a" + std::to_string(k - 1) + "\"\n";
  EXPECT_NE(read(doubling, "new = \"a40*at(f(1,0),1/2)\""), "accepted");
  std::string points = "e0 = \"at(f(1,0),1/2)\"\n";
  for (int k = 1; k <= 200; ++k)
    points += "e" + std::to_string(k) + " = \"e" + std::to_string(k - 1) + "/2+e" + std::to_string(k - 1) + "/2\"\n";
  EXPECT_EQ(read(points, "new = \"e200\""), "accepted");  // shared, not copied
  EXPECT_NE(read_new("again(again(again(again(at(f(1,0),1/2)))))", 64), "accepted");
  EXPECT_NE(read_new("at(tension((1+w)^900, f(7,0)),1/2)", 64), "accepted");
  std::string join = "at(";
  for (int k = 0; k < 40; ++k) join += "join(1,";
  expect_message(read_new(join + "f(2,0)" + std::string(40, ')') + ",1/2)", 64), "needs points = 84 at least");
}

TEST(RuleReader, AnErrorlessFileIsRead) {
  const std::string text = R"toml(name = "mine"
kind = "nonuniform"
[parameters]
w = ["0", "1"]
[nonuniform]
points = 6
[nonuniform.let]
second = "join(2, degree(4, first))"
first = "hermite(1, f(2,0), f(2,1))"
[nonuniform.rule]
new = "(1-w)*at(second,1/2) + w*at(f(1,0),1/2)"
[[claims]]
claim = "C2"
)toml";
  const Scheme scheme = read_scheme(text, "mine.toml");
  EXPECT_EQ(scheme.kind, SchemeKind::nonuniform);
  EXPECT_EQ(to_string(scheme.kind), "nonuniform");
  ASSERT_TRUE(scheme.insertion_rule.has_value());
  EXPECT_EQ(scheme.insertion_rule->points(), 6);
  ASSERT_EQ(scheme.insertion_rule->text().let.size(), 2u);
  EXPECT_EQ(scheme.insertion_rule->text().let[0].name, "second");
  EXPECT_EQ(scheme.rule, "(1-w)*at(second,1/2) + w*at(f(1,0),1/2)");
  EXPECT_EQ(scheme.mask.symbol, uniform_mask(*scheme.insertion_rule).symbol);
}

}  // namespace
}  // namespace limes
