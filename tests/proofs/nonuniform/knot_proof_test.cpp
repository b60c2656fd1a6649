// Theorem N1: rules without symmetry, and each test of root dominance alone.

#include "schemes/catalogue.hpp"
#include "tests/proofs/nonuniform/decide.hpp"

namespace limes {
namespace {

using test::decide;
using test::own;

Scheme catalogue(const std::string& name) {
  return Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name);
}

ProofLimits only(DominanceMethod method) {
  ProofLimits limits;
  limits.dominance.methods = {method};
  return limits;
}

int leaves(const Verdict& verdict, DominanceMethod method) {
  int count = 0;
  for (const DominatedFactor& factor : std::get<KnotProof>(verdict.certificate->proof).factors) {
    for (const auto* boxes : {&factor.leaves, &factor.mirrored_leaves}) {
      for (const DominanceLeaf& leaf : *boxes) count += leaf.method == method;
    }
  }
  return count;
}

TEST(KnotProof, RulesWithoutMirrorSymmetry) {
  // Quadratic interpolation with unequal weights of the two sides.
  const Verdict verdict = decide(own("9/16*at(f(2,0),1/2) + 7/16*at(f(2,1),1/2)", 4), "C1", "1/16");
  ASSERT_EQ(verdict.outcome, Outcome::certified) << verdict.reason;
  const auto& proof = std::get<KnotProof>(verdict.certificate->proof);
  EXPECT_TRUE(proof.both_sides);
  for (const DominatedFactor& factor : proof.factors) EXPECT_FALSE(factor.mirrored_leaves.empty());
  // With the two sides as a parameter.
  EXPECT_EQ(decide(own("(1/2+w)*at(f(2,0),1/2) + (1/2-w)*at(f(2,1),1/2)", 4), "C1", "[0, 1/8]").outcome, Outcome::certified);
  EXPECT_FALSE(std::get<KnotProof>(decide(catalogue("cr1"), "C1", "1/16").certificate->proof).both_sides);
}

// Smooth at equal intervals, but for small ratios a second eigenvalue exceeds 1/2; its mirror image fails for large ratios only.
TEST(KnotProof, LargeRatiosCount) {
  for (const bool left : {true, false}) {
    const Verdict verdict = decide(own(left ? "21/20*at(f(2,0),1/2) - 1/20*at(f(2,1),1/2)"
                                            : "21/20*at(f(2,1),1/2) - 1/20*at(f(2,0),1/2)", 4), "C1", "1/16");
    ASSERT_EQ(verdict.outcome, Outcome::refuted) << verdict.reason;
    ASSERT_EQ(verdict.certificate->theorem, Theorem::n3);
    const Rational gamma = std::get<RatioWitness>(std::get<LeafProof>(verdict.certificate->proof).leaves.front().witness).gamma;
    EXPECT_EQ(gamma < 1, left);
  }
}

TEST(KnotProof, EachTestAlone) {
  EXPECT_GT(leaves(decide(catalogue("a2-5-3"), "C2", "[1/100, 11/1000]", only(DominanceMethod::rouche)), DominanceMethod::rouche), 0);
  EXPECT_GT(leaves(decide(catalogue("a2-5-3"), "C2", "[1/100, 11/1000]", only(DominanceMethod::circle)), DominanceMethod::circle), 0);
  EXPECT_GT(leaves(decide(catalogue("a2-5-3"), "C2", "[1/100, 11/1000]", only(DominanceMethod::boundary)), DominanceMethod::boundary),
            0);
}

// Karciauskas & Peters 2013, Props. 2 and 5, by the separation of real roots as there.
TEST(KnotProof, SeparationOfRoots) {
  for (const auto& [name, claim, w] : std::vector<std::array<std::string, 3>>{{"repeated-cr1", "C2", ""},
                                                                              {"repeated-a1-3-1", "C2", ""},
                                                                              {"a3-5-3-3", "C3", "141/10000"},
                                                                              {"a3-5", "C3", "141/10000"},
                                                                              {"cr1", "C1", "[1/20, 3/20]"}}) {
    const Verdict verdict = decide(catalogue(name), claim, w, only(DominanceMethod::sign_separation));
    ASSERT_EQ(verdict.outcome, Outcome::certified) << name << ": " << verdict.reason;
    EXPECT_GT(leaves(verdict, DominanceMethod::sign_separation), 0);
  }
}

}  // namespace
}  // namespace limes
