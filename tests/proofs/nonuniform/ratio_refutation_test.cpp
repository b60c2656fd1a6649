// Theorem N3 on regions.

#include "proofs/checker/checker.hpp"
#include "schemes/catalogue.hpp"
#include "tests/proofs/nonuniform/decide.hpp"

namespace limes {
namespace {

using test::decide;
using test::own;

Scheme catalogue(const std::string& name) {
  return Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name);
}

// Karciauskas & Peters 2013, the remark on A^{1,3:1}: uniform C^1 up to 0.1927.., non-uniform up to 1/8.
TEST(RatioRefutation, AveragingBeyondOneEighth) {
  const Verdict verdict = decide(catalogue("a1-3-1"), "not C1", "[1251/10000, 19/100]");
  ASSERT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
  EXPECT_EQ(verdict.certificate->theorem, Theorem::n3);
  EXPECT_EQ(decide(catalogue("a1-3-1"), "not C1", "(1251/10000, 1/4)").outcome, Outcome::certified);
  EXPECT_EQ(decide(catalogue("a1-3-1"), "not C1", "[12/100, 19/100]").outcome, Outcome::undecided);
}

TEST(RatioRefutation, SmoothnessOneOrderHigher) {
  // C^2 by 4 points, C^3 by 6: not even for most w of the uniform scheme.
  EXPECT_EQ(decide(catalogue("cr1"), "not C2", "[1/100, 3/20]").outcome, Outcome::certified);
  EXPECT_EQ(decide(catalogue("cu2-4"), "not C2", "[33/1000, 1/25]").outcome, Outcome::certified);
}

// The ranges of A^{1,3:1} and cu^{2,4} end where an eigenvalue tends to 2^{-m} with the ratio to 0: they are closed there, and what
// lies beyond is refuted at tiny ratios only.
TEST(RatioRefutation, RangesThatEndInTheLimitOfSmallRatios) {
  EXPECT_EQ(decide(catalogue("a1-3-1"), "C1", "(0, 1/8]").outcome, Outcome::certified);
  EXPECT_EQ(decide(catalogue("a1-3-1"), "not C1", "[125000001/1000000000, 1/4]").outcome, Outcome::certified);
  EXPECT_EQ(decide(catalogue("cu2-4"), "C2", "(0, 1/32]").outcome, Outcome::certified);
  EXPECT_EQ(decide(catalogue("cu2-4"), "not C2", "[31251/1000000, 1/10]").outcome, Outcome::certified);
}

// Karciauskas & Peters 2013, cr2: 1/8 is an eigenvalue at every ratio, and cubics are not reproduced. Quadratics are.
TEST(RatioRefutation, AnEigenvalueWithoutItsPower) {
  const Verdict verdict = decide(catalogue("cr2"), "not C3", "[0, 1/10]");
  ASSERT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
  EXPECT_EQ(verdict.certificate->theorem, Theorem::n3);
  EXPECT_EQ(decide(catalogue("cr2"), "not C2", "(0, 1/50]").outcome, Outcome::undecided);
  std::string altered = verdict.certificate_json;
  const std::size_t at = altered.find("not C3");
  ASSERT_NE(at, std::string::npos);
  altered.replace(at, 6, "not C2");
  EXPECT_EQ(checker::check(altered).step, "eigenvalue");
}

// Conjugate eigenvalues, which no sign at a real number shows.
TEST(RatioRefutation, ConjugatePairs) {
  const Verdict verdict = decide(catalogue("a3-5"), "not C3", "[157/10000, 1/50]");
  ASSERT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
  EXPECT_EQ(verdict.certificate->theorem, Theorem::n3);
}

TEST(RatioRefutation, ASecondEigenvalueEverywhere) {
  EXPECT_EQ(decide(own("at(f(1,0),1/2)", 2), "not C1", "[0, 1/4]").outcome, Outcome::certified);
}

}  // namespace
}  // namespace limes
