// Theorem U2 on regions.

#include "proofs/checker/checker.hpp"
#include "schemes/catalogue.hpp"
#include "tests/proofs/nonuniform/decide.hpp"

namespace limes {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

// The leading eigenvalues of the section B_0 are a complex pair, which crosses the circle at w = 0.001847..: no sign at a real number
// shows it, the determinant of the boundary test does.
TEST(ProveNotSmooth, ComplexPairOnARegion) {
  const Scheme scheme = Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load("ten-point");
  const Verdict verdict = test::decide(scheme, "not C4", "[37/20000, 1/500]");
  ASSERT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
  EXPECT_EQ(verdict.certificate->theorem, Theorem::u2);
  EXPECT_TRUE(checker::check(verdict.certificate_json).valid);
  ASSERT_NE(verdict.certificate_json.find("[37/20000, 1/500]"), std::string::npos);
  // Below the crossing the determinant is positive.
  EXPECT_FALSE(checker::check(replaced(verdict.certificate_json, "[37/20000, 1/500]", "[9/5000, 1/500]")).valid);
}

}  // namespace
}  // namespace limes
