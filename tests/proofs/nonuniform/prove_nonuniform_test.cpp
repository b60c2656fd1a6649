// Karciauskas & Peters 2013, section 4: every proposition, as the catalogue states it.

#include "schemes/catalogue.hpp"
#include "tests/proofs/nonuniform/decide.hpp"

namespace limes {
namespace {

using test::decide;
using test::own;

Outcome outcome(const std::string& scheme, const std::string& text, const std::string& w = "") {
  return decide(Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(scheme), text, w).outcome;
}

TEST(ProveNonuniform, Proposition1) {
  EXPECT_EQ(outcome("cr1", "C1", "[1/1000, 3/20]"), Outcome::certified);
  EXPECT_EQ(outcome("cr1", "C2", "1/16"), Outcome::refuted);
  EXPECT_EQ(outcome("cr1", "C1", "1/5"), Outcome::refuted);  // beyond w*, already for equal intervals
}

// The remark after eq. (18): averaging fails where the uniform scheme is C^1.
TEST(ProveNonuniform, AveragingAtThirteenHundredths) {
  EXPECT_EQ(outcome("a1-3-1", "C1", "13/100"), Outcome::refuted);
  EXPECT_EQ(outcome("a1-3-1", "not C1", "13/100"), Outcome::certified);
  EXPECT_EQ(outcome("four-point", "C1", "13/100"), Outcome::certified);
  EXPECT_EQ(outcome("a1-3-1", "C1", "[1/1000, 3/25]"), Outcome::certified);
}

TEST(ProveNonuniform, Proposition2) {
  EXPECT_EQ(outcome("repeated-cr1", "C2"), Outcome::certified);
  EXPECT_EQ(outcome("repeated-a1-3-1", "C2"), Outcome::certified);
}

TEST(ProveNonuniform, Proposition3) { EXPECT_EQ(outcome("cr2", "C2", "(0, 21/500]"), Outcome::certified); }

TEST(ProveNonuniform, Proposition4) {
  EXPECT_EQ(outcome("a2-5-3", "C2", "[1/1000, 1/50]"), Outcome::certified);
  EXPECT_EQ(outcome("a2-5-3", "C3", "141/10000"), Outcome::refuted);
}

TEST(ProveNonuniform, Proposition5) {
  EXPECT_EQ(outcome("a3-5-3-3", "C3", "141/10000"), Outcome::certified);
  EXPECT_EQ(outcome("a3-5", "C3", "141/10000"), Outcome::certified);
}

TEST(ProveNonuniform, EightPoints) { EXPECT_EQ(outcome("eight-point-nonuniform", "C3", "[1/500, 7/2000]"), Outcome::certified); }

TEST(ProveNonuniform, SplinesOfCubicInterpolants) {
  EXPECT_EQ(outcome("cu2-4", "C2", "1/288"), Outcome::certified);
  EXPECT_EQ(outcome("cu2-4", "C2", "7/200"), Outcome::refuted);
}

TEST(ProveNonuniform, ASmoothUniformSchemeIsNotEnough) {
  // Constant weights of the four-point scheme at w = 1/16, whatever the knots: constants are reproduced, linear functions are
  // not, so no polynomial eigenvector belongs to 1/2.
  const Scheme scheme = read_scheme(
      "name = \"own\"\nkind = \"nonuniform\"\n[nonuniform]\npoints = 4\n[nonuniform.rule]\n"
      "coefficients = [\"-1/16\", \"9/16\", \"9/16\", \"-1/16\"]\n", "own.toml");
  EXPECT_NE(decide(scheme, "C1").outcome, Outcome::certified);
}

}  // namespace
}  // namespace limes
