#include "algebra/expression/expression.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace limes {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

// The fully bracketed form of a tree, so that its shape can be compared.
std::string shape(const Expression& expression);

std::string shape(const std::vector<Expression>& expressions) {
  std::string result;
  for (const auto& e : expressions) result += (result.empty() ? "" : ",") + shape(e);
  return result;
}

std::string shape(const Expression& expression) {
  struct Visitor {
    std::string operator()(const Expression::Number& n) const { return to_string(n.value); }
    std::string operator()(const Expression::Name& n) const { return n.name; }
    std::string operator()(const Expression::Operation& n) const {
      if (n.operands.size() == 1) return "(" + std::string(1, n.op) + shape(n.operands[0]) + ")";
      return "(" + shape(n.operands[0]) + n.op + shape(n.operands[1]) + ")";
    }
    std::string operator()(const Expression::Power& n) const {
      return "(" + shape(n.base.front()) + "^" + std::to_string(n.exponent) + ")";
    }
    std::string operator()(const Expression::Call& n) const { return n.function + "(" + shape(n.arguments) + ")"; }
    std::string operator()(const Expression::List& n) const { return "[" + shape(n.elements) + "]"; }
  };
  return std::visit(Visitor(), expression.node);
}

void expect_error(const std::string& text, int column, const std::string& reason) {
  try {
    read_expression(text);
    ADD_FAILURE() << "no error for " << text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.position().column, column) << text << ": " << error.what();
    EXPECT_EQ(error.reason(), reason) << text;
  }
}

TEST(ReadExpression, Precedence) {
  EXPECT_EQ(shape(read_expression("-w^2")), "(~(w^2))");
  EXPECT_EQ(shape(read_expression("2*-w")), "(2*(~w))");
  EXPECT_EQ(shape(read_expression("a-b-c")), "((a-b)-c)");
  EXPECT_EQ(shape(read_expression("a/b*c/d")), "(((a/b)*c)/d)");
  EXPECT_EQ(shape(read_expression("a+b*c^-2")), "(a+(b*(c^-2)))");
  EXPECT_EQ(shape(read_expression("+-+a")), "(~a)");
  EXPECT_EQ(shape(read_expression("((a))")), "a");
}

TEST(ReadExpression, LongSumsAreBalanced) {
  EXPECT_EQ(shape(read_expression("a-b+c-d")), "((a-b)+(c-d))");
  EXPECT_EQ(shape(read_expression("a-b-c+d")), "((a-b)-(c-d))");
  EXPECT_NO_THROW(read_expression("1" + repeated("+1", 40000)));
}

TEST(ReadExpression, CallsAndLists) {
  EXPECT_EQ(shape(read_expression("at(join(2, f(2,0)), 1/2)")), "at(join(2,f(2,0)),(1/2))");
  EXPECT_EQ(shape(read_expression("dot([1/12, -1], cr2)")), "dot([(1/12),(~1)],cr2)");
  EXPECT_EQ(shape(read_expression("g() + []")), "(g()+[])");
}

TEST(ReadExpression, NumbersAreExact) {
  EXPECT_EQ(shape(read_expression("0.0141")), "141/10000");
  EXPECT_EQ(shape(read_expression(".5")), "1/2");
  EXPECT_EQ(shape(read_expression("5.")), "5");
  EXPECT_EQ(shape(read_expression("1e-3")), "1/1000");
  EXPECT_EQ(shape(read_expression("2.50E+2")), "250");
  EXPECT_EQ(shape(read_expression("5.e1")), "50");
  EXPECT_EQ(shape(read_expression("010")), "10");
}

TEST(ReadExpression, BlanksAndColumns) {
  const Expression e = read_expression(" \ta\r\n + b ");
  EXPECT_EQ(shape(e), "(a+b)");
  EXPECT_EQ(e.column, 7);
  EXPECT_EQ(std::get<Expression::Operation>(e.node).operands[0].column, 3);
  EXPECT_EQ(std::get<Expression::Operation>(e.node).operands[1].column, 9);
}

TEST(ReadExpression, ErrorsSayWhereAndWhat) {
  expect_error("", 1, "the expression is empty");
  expect_error(" \n ", 4, "the expression is empty");
  expect_error("1+)", 3, "expected a number, a name or '(' but found ')'");
  expect_error("1+", 3, "expected a number, a name or '(' but found the end of the expression");
  expect_error("2w", 2, "expected an operator or the end but found 'w'");
  expect_error("2 e", 3, "expected an operator or the end but found 'e'");
  expect_error("1e+", 2, "expected an operator or the end but found 'e'");
  expect_error("(w+1", 5, "expected an operator or ')' (for the '(' in column 1) but found the end of the expression");
  expect_error("f(1;2)", 4, "expected an operator, ',' or ')' (for the '(' in column 2) but found ';'");
  expect_error("[1)", 3, "expected an operator, ',' or ']' (for the '[' in column 1) but found ')'");
  expect_error("f(1,)", 5, "expected a number, a name or '(' but found ')'");
  expect_error("w^v", 3, "expected an integer exponent but found 'v'");
  expect_error("w^--1", 4, "expected an integer exponent but found '-'");
  expect_error("2^1.5", 4, "the exponent must be an integer");
  expect_error("2^3^2", 4, "a power of a power needs parentheses");
  expect_error(".", 1, "expected a digit before or after '.'");
  expect_error("_a", 1, "expected a number, a name or '(' but found '_a'");
  expect_error("w\xC3\xA4", 2, "expected an operator or the end but found the byte 0xC3, which is not ASCII");
  expect_error(std::string("1\0", 2), 2, "expected an operator or the end but found the control character 0x00");
}

TEST(ReadExpression, LimitsAreReported) {
  EXPECT_NO_THROW(read_expression(repeated("(", 100) + "1" + repeated(")", 100)));
  EXPECT_THROW(read_expression(repeated("(", 101) + "1" + repeated(")", 101)), LimitError);
  EXPECT_THROW(read_expression(repeated("(", 99999)), LimitError);
  EXPECT_THROW(read_expression(repeated("-", 99999)), LimitError);
  EXPECT_THROW(read_expression(repeated("f([", 33333)), LimitError);
  EXPECT_THROW(read_expression(repeated(" ", 100001)), LimitError);
  EXPECT_THROW(read_expression("1" + repeated("*1", 40000)), LimitError);
  EXPECT_NO_THROW(read_expression("1" + repeated("*1", 900)));
  EXPECT_NO_THROW(read_expression("w^1000"));
  EXPECT_THROW(read_expression("w^1001"), LimitError);
  EXPECT_THROW(read_expression("w^-" + repeated("9", 5000)), LimitError);
  EXPECT_THROW(read_expression(repeated("9", 10001)), LimitError);
  EXPECT_NO_THROW(read_expression(repeated("9", 10000)));
  EXPECT_THROW(read_expression("1e10001"), LimitError);
  EXPECT_THROW(read_expression("1e-" + repeated("9", 5000)), LimitError);
  EXPECT_THROW(read_expression("1+1+1", {.max_nodes = 4}), LimitError);
  EXPECT_NO_THROW(read_expression("1+1+1", {.max_nodes = 5}));
}

TEST(ReadExpression, RandomTextNeverCrashes) {
  std::mt19937 random(1);
  const std::string alphabet = "01.eEwf_+-*/^()[], \n\xFF";
  int read = 0;
  for (int i = 0; i < 50000; ++i) {
    std::string text(1 + random() % 12, ' ');
    for (char& c : text) c = alphabet[random() % alphabet.size()];
    try {
      // What was read once is read again as the same tree.
      const std::string once = shape(read_expression(text));
      ++read;
      std::string with_minus = once;
      std::replace(with_minus.begin(), with_minus.end(), '~', '-');
      if (once.find('/') == std::string::npos) {
        EXPECT_EQ(shape(read_expression(with_minus)), once) << text;
      }
    } catch (const InputError& error) {
      EXPECT_GE(error.position().column, 1) << text;
      EXPECT_LE(error.position().column, int(text.size()) + 1) << text;
    }
  }
  EXPECT_GT(read, 300);
}

TEST(IsName, LettersThenLettersDigitsUnderscores) {
  EXPECT_TRUE(is_name("w"));
  EXPECT_TRUE(is_name("beta_1"));
  EXPECT_FALSE(is_name(""));
  EXPECT_FALSE(is_name("1w"));
  EXPECT_FALSE(is_name("_w"));
  EXPECT_FALSE(is_name("w v"));
  EXPECT_FALSE(is_name("\xC3\xA4"));
}

}  // namespace
}  // namespace limes
