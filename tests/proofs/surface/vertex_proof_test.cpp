#include "algebra/error.hpp"
#include "schemes/catalogue.hpp"
#include "tests/proofs/surface/decide.hpp"

#include <gtest/gtest.h>


using namespace limes;

namespace {

using test::decide;

Claim spectral(const Scheme& scheme, const std::string& valences) {
  Claim claim = read_statement("spectral-condition");
  claim.valences = read_valences(valences);
  claim.region = scheme.parameter_box();
  if (const MaskSequence* sequence = scheme.level_sequence()) claim.region = {sequence->types.front().angles};
  return claim;
}

Scheme with_rules(const std::string& curve, const std::string& rules) {
  return read_scheme("name = \"test\"\nkind = \"surface\"\n[surface]\ncurve = \"" + curve + "\"\n[surface.rules]\n" + rules, "test.toml");
}

// Catmull & Clark 1978, Doo & Sabin 1978 and the four-point scheme with virtual points satisfy the spectral condition for every valence.
TEST(VertexProof, KnownSchemesForAllValences) {
  for (const char* name : {"catmull-clark", "doo-sabin", "unified"}) {
    const Scheme scheme = load_scheme(name);
    const Verdict verdict = decide(scheme, spectral(scheme, "[3, inf)"), std::string(name) + ".spectrum.all.json");
    EXPECT_EQ(verdict.outcome, Outcome::certified) << name << ": " << verdict.reason;
    ASSERT_TRUE(verdict.certificate);
    EXPECT_EQ(verdict.certificate->theorem, Theorem::e1);
  }
}

TEST(VertexProof, KnownSchemesOneByOne) {
  for (const char* name : {"catmull-clark", "doo-sabin", "unified"}) {
    const Scheme scheme = load_scheme(name);
    for (const char* valences : {"3", "[3, 12]", "[49, 50]"}) {
      const Verdict verdict = decide(scheme, spectral(scheme, valences), std::string(name) + ".spectrum.json");
      EXPECT_EQ(verdict.outcome, Outcome::certified) << name << ": " << verdict.reason;
    }
  }
}

TEST(VertexProof, NonstationarySchemesAreNotSaidToBeSmooth) {
  const Scheme scheme = load_scheme("unified");
  Claim claim = spectral(scheme, "[3, 8]");
  claim.type = AngleType::hyperbolic;
  claim.region = {scheme.surface->sequence.find(AngleType::hyperbolic)->angles};
  const Verdict verdict = decide(scheme, claim, "unified.spectrum.hyperbolic.json");
  ASSERT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
  EXPECT_NE(verdict.reason.find("sum of 2^k ||M_k - M|| is finite"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("not C1"), std::string::npos) << verdict.reason;
}

// What fails is undecided, and says at which valence.
TEST(VertexProof, FailuresAreUndecidedWithAReason) {
  const auto reason = [](const Scheme& scheme, const std::string& valences) {
    const Verdict verdict = prove(scheme, spectral(scheme, valences));
    EXPECT_EQ(verdict.outcome, Outcome::undecided);
    EXPECT_FALSE(verdict.certificate);
    return verdict.reason;
  };
  const Scheme lazy = with_rules("b-spline-3", "\"0,0\" = \"at(0,0)\"");  // a fixed vertex: 0.65 in block 0
  EXPECT_NE(reason(lazy, "[3, 8]").find("valence 3: block 1"), std::string::npos);
  EXPECT_FALSE(reason(lazy, "[3, inf)").empty());
  const Scheme wrong_block =
      with_rules("b-spline-2", "\"0,0\" = \"1/4*at(0,0) + 1/4*at(0,0,2) + 1/4*at(0,0,-2) + 1/4*mean(0,0)\"");
  EXPECT_NE(reason(wrong_block, "5").find("block 2"), std::string::npos);
  const Scheme lopsided = with_rules("b-spline-2", "\"0,0\" = \"1/4*at(0,0) + 1/4*at(0,0,1) + 1/2*mean(0,0)\"");
  EXPECT_NE(reason(lopsided, "5").find("symmetric"), std::string::npos);
  const Scheme pole = with_rules("b-spline-2", "\"0,0\" = \"1/(n-4)*at(0,0) + (1-1/(n-4))*mean(0,0) + 1/2*harmonic(1,0,0)\"");
  EXPECT_FALSE(reason(pole, "4").empty());
  const Scheme leaking = with_rules("b-spline-2", "\"0,0\" = \"1/4*at(0,0) + 1/2*mean(0,0)\"");
  EXPECT_NE(reason(leaking, "5").find("sum to 1"), std::string::npos);
}

TEST(VertexProof, ValencesAreReadAndWritten) {
  EXPECT_EQ(to_string(read_valences("[3, inf)")), "[3, inf)");
  EXPECT_EQ(to_string(read_valences("3..50")), "[3, 50]");
  EXPECT_EQ(to_string(read_valences("[3,50]")), "[3, 50]");
  EXPECT_EQ(to_string(read_valences("4..")), "[4, inf)");
  EXPECT_EQ(to_string(read_valences("7")), "7");
  for (const char* text : {"", "2", "[3, 2]", "1001", "[3]", "[3, inf]", "[3; 5]", "3..2", "x", "[3, 5)", "inf"})
    EXPECT_THROW(read_valences(text), InputError) << text;
}

}  // namespace
