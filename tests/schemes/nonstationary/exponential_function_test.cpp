#include "schemes/nonstationary/exponential_function.hpp"

#include "algebra/error.hpp"
#include "schemes/claim.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

TEST(ExponentialFunction, TextAndBack) {
  for (const char* text :
       {"1", "y", "y^2", "y^16", "cos", "sin", "cosh", "sinh", "cos(2y)", "y cos", "y^3 sinh(12y)"}) {
    EXPECT_EQ(to_string(read_exponential_function(text)), text);
  }
  EXPECT_EQ(to_string(read_exponential_function(" y  cos(1y) ")), "y cos");
  EXPECT_EQ(to_string(read_exponential_functions("{ 1,y ,cos,sin }")), "{1, y, cos, sin}");
}

TEST(ExponentialFunction, OtherTextsAreErrors) {
  for (const char* text : {"", "2", "x", "y^0", "y^17", "y^100", "cos(0y)", "cos(17y)", "cos(y", "tan", "cosy", "1 cos",
                           "cos y", "sin sin"}) {
    EXPECT_THROW(read_exponential_function(text), InputError) << text;
  }
  for (const char* text : {"", "{}", "{1", "1, y", "{1,,y}", "{1, 1}", "{1, y,}"}) {
    EXPECT_THROW(read_exponential_functions(text), InputError) << text;
  }
}

TEST(ExponentialFunction, StatementsAboutSpaces) {
  for (const char* text :
       {"reproduces {1, y, cos, sin}", "does not reproduce {y^2}", "generates {1}", "does not generate {y cosh}"}) {
    const Claim claim = read_statement(text);
    ASSERT_TRUE(claim.space.has_value());
    EXPECT_EQ(statement(claim), text);
  }
  EXPECT_FALSE(read_statement("C2").space);
  EXPECT_THROW(read_statement("not reproduces {1}"), InputError);
  EXPECT_THROW(read_statement("reproduces"), InputError);
}

}  // namespace
}  // namespace limes
