#include "proofs/prove.hpp"

#include "algebra/error.hpp"
#include "proofs/checker/checker.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace limes {
namespace {

/// A scheme from a mask, without a file.
Scheme scheme(const std::string& mask, const std::string& parameters = "", int arity = 2) {
  std::string text = "name = \"test\"\nkind = \"uniform\"\n";
  if (!parameters.empty()) text += "[parameters]\n" + parameters + "\n";
  return read_scheme(text + "[uniform]\narity = " + std::to_string(arity) + "\nmask = [" + mask + "]\n", "test.toml");
}

const std::string four_point = R"("-w", "0", "1/2+w", "1", "1/2+w", "0", "-w")";

/// Proves a statement; what is decided must pass the independent checker, and is left for script/test to check once more.
Verdict decide(const Scheme& s, const std::string& text, const std::string& w = "") {
  static int count = 0;
  Claim claim = read_statement(text);
  claim.region = s.parameter_box();
  if (!w.empty()) claim.region = {read_interval(w)};
  const Verdict verdict = prove(s, claim);
  EXPECT_EQ(verdict.outcome == Outcome::undecided, !verdict.certificate.has_value());
  if (verdict.certificate) {
    EXPECT_TRUE(checker::check(verdict.certificate_json).valid);
    const std::filesystem::path directory = std::filesystem::path(LIMES_BINARY_DIR) / "certificates/proofs";
    std::filesystem::create_directories(directory);
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::ofstream(directory / (std::string(test->name()) + "." + std::to_string(++count) + ".json")) << verdict.certificate_json;
  }
  return verdict;
}

Outcome outcome(const Scheme& s, const std::string& text, const std::string& w = "") { return decide(s, text, w).outcome; }

TEST(Prove, CornerCuttingIsC1AndNotC2) {
  const Scheme chaikin = scheme(R"("1/4", "3/4", "3/4", "1/4")");
  EXPECT_EQ(outcome(chaikin, "C0"), Outcome::certified);
  EXPECT_EQ(outcome(chaikin, "C1"), Outcome::certified);
  EXPECT_EQ(outcome(chaikin, "C2"), Outcome::refuted);
  EXPECT_EQ(outcome(chaikin, "not C2"), Outcome::certified);
  EXPECT_EQ(outcome(chaikin, "not C1"), Outcome::refuted);
}

TEST(Prove, TheVerdictDoesNotDependOnTheIndexOrigin) {
  Scheme s = scheme(four_point, "w = [\"0\", \"1/4\"]");
  for (const int shift : {-7, -1, 2, 5}) {
    Scheme shifted = s;
    shifted.mask.symbol = s.mask.symbol.shifted(shift);
    EXPECT_EQ(outcome(shifted, "C1", "[1/100, 1/8]"), Outcome::certified);
    EXPECT_EQ(outcome(shifted, "C2", "1/16"), Outcome::refuted);
  }
}

// Hechler, Moessner & Reif 2009: C^1 exactly for 0 < w < w*, 32 w*^3 + 4 w* = 1.
TEST(Prove, FourPointSchemeAtTheEndsOfItsRange) {
  const Scheme s = scheme(four_point, "w = [\"-1/4\", \"1/4\"]");
  EXPECT_EQ(outcome(s, "C1", "(0, 1/8]"), Outcome::certified);
  EXPECT_EQ(outcome(s, "C1", "[0, 1/8]"), Outcome::refuted);
  EXPECT_EQ(outcome(s, "C1", "[-1/100, 1/8]"), Outcome::refuted);
  // w* = 0.1927292...; norms of powers would need levels beyond any budget, a polytope does not.
  EXPECT_EQ(outcome(s, "C1", "(0, 19172/100000]"), Outcome::certified);
  EXPECT_EQ(outcome(s, "C1", "[1/1000, 19272/100000]"), Outcome::certified);
  EXPECT_EQ(outcome(s, "not C1", "[19273/100000, 1/4]"), Outcome::certified);
  EXPECT_EQ(outcome(s, "not C1", "[19/100, 1/4]"), Outcome::refuted);  // w* lies inside
  EXPECT_EQ(outcome(s, "not C2"), Outcome::certified);
}

TEST(Prove, UndecidedSaysWhyAndHasNoCertificate) {
  const Scheme s = scheme(four_point, "w = [\"0\", \"1/4\"]");
  // Less than 10^-10 below w*.
  const Verdict verdict = decide(s, "C1", "0.1927292492");
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_NE(verdict.reason.find("w = 481823123/2500000000"), std::string::npos) << verdict.reason;
}

// Karciauskas & Peters 2013, Table 1.
TEST(Prove, SixPointTableRow) {
  const Scheme s = scheme(R"("w","0","-3*w-1/16","0","2*w+9/16","1","2*w+9/16","0","-3*w-1/16","0","w")", "w = [\"-1\", \"1\"]");
  EXPECT_EQ(outcome(s, "C2", "(0, 21/500]"), Outcome::certified);
  EXPECT_EQ(outcome(s, "C2", "[0, 21/500]"), Outcome::refuted);
  EXPECT_EQ(outcome(s, "not C2", "[-1/25, 0]"), Outcome::certified);
}

TEST(Prove, MasksOfOtherArity) {
  // The ternary quadratic B-spline (1 + z + z^2)^3 / 9.
  const Scheme spline = scheme(R"("1/9","3/9","6/9","7/9","6/9","3/9","1/9")", "", 3);
  EXPECT_EQ(outcome(spline, "C1"), Outcome::certified);
  EXPECT_NE(outcome(spline, "C2"), Outcome::certified);
}

// Without one of its hypotheses each of these would pass; none may be certified.
TEST(Prove, TrapsAreNotCertified) {
  const struct {
    const char* mask;
    int arity;
    int smoothness;
  } traps[] = {
      {R"("9/10","9/5","9/10")", 2, 0},                                  // a(1) != 2: diverges
      {R"("9/10","9/5","9/10")", 2, 1},
      {R"("3/8","9/8","9/8","3/8")", 2, 1},                              // 3/8 (1+z)^3
      {R"("3/8","9/8","9/8","3/8")", 2, 0},
      {R"("1/2","4/5","3/2","1","7/10")", 3, 0},                         // (1+z)(1/2 + 3z/10 + 7z^2/10) in place of sigma = 1+z+z^2
      {R"("1/2","1/2","1/2","1/2")", 2, 1},                              // (1+z)(1+z^2)/2
      {R"("1","1")", 2, 0},                                              // the box
      {R"("2")", 2, 0},
      {R"("0","1")", 2, 0},
  };
  for (const auto& trap : traps) {
    const Scheme s = scheme(trap.mask, "", trap.arity);
    EXPECT_NE(outcome(s, "C" + std::to_string(trap.smoothness)), Outcome::certified) << trap.mask;
  }
}

// (1+z)(1+z^2)/2 has dependent shifts: nothing negative may be concluded from its sections. In fact it converges to no continuous limit for
// general data, but not by theorem U2.
TEST(Prove, NoRefutationWithoutStability) {
  const Scheme s = scheme(R"("1/2","1/2","1/2","1/2")");
  EXPECT_EQ(outcome(s, "not C1"), Outcome::undecided);
  EXPECT_EQ(outcome(s, "C1"), Outcome::undecided);
}

TEST(Prove, PolesAreNotCertified) {
  const Scheme s = scheme(R"x("1/2 - 1/(100*w - 10)", "1", "1/2 + 1/(100*w - 10)")x", "w = [\"0\", \"1/4\"]");
  EXPECT_NE(outcome(s, "C0"), Outcome::certified);
  EXPECT_EQ(outcome(s, "C0", "[1/5, 1/4]"), Outcome::certified);
}

TEST(Prove, TwoParameters) {
  // Interpolatory with new points (x, 1/2 - x + y, 1/2 - y, 0 ...): four free weights with sum 1.
  const Scheme s = scheme(R"("x","0","1/2-x","1","1/2-y","0","y")", R"(x = ["-1/8","1/8"]
y = ["-1/8","1/8"])");
  EXPECT_EQ(outcome(s, "C0"), Outcome::certified);
  EXPECT_EQ(outcome(s, "C1"), Outcome::refuted);
}

TEST(Prove, InterruptionIsUndecided) {
  const std::atomic<bool> flag{true};
  const Stop stop(&flag);
  const Scheme s = scheme(four_point, "w = [\"0\", \"1/4\"]");
  Claim claim = read_statement("C1");
  claim.region = {read_interval("[1/100, 1/8]")};
  const Verdict verdict = prove(s, claim, {}, stop);
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_TRUE(verdict.interrupted);
}

TEST(Prove, CertificatesAreTheSameBytesEveryTime) {
  const Scheme s = scheme(four_point, "w = [\"0\", \"1/4\"]");
  EXPECT_EQ(decide(s, "C1", "(0, 37/200]").certificate_json, decide(s, "C1", "(0, 37/200]").certificate_json);
}

}  // namespace
}  // namespace limes
