#pragma once

#include "analysis/nonstationary/asymptotic_bound.hpp"
#include "analysis/nonstationary/space_moments.hpp"
#include "analysis/nonuniform/dominance_test.hpp"
#include "analysis/spectral_radius/polytope_norm.hpp"
#include "analysis/uniform/stability.hpp"
#include "analysis/unity/projective_roughness.hpp"
#include "schemes/scheme.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace limes {

/// The theorems that verdicts rest on (docs/theory.md).
enum class Theorem {
  /// Contractivity of the difference scheme proves C^m. [Dyn 1992; Dyn & Levin 2002]
  u1,
  /// A missing factor or an expanding word of difference sections disproves C^m. [Dyn & Levin 2002]
  u2,
  /// The uniform scheme by U1 and dominated eigenvalues at every isolated knot ratio prove C^m for all knots. [Warren 1995;
  /// Daubechies, Guskov & Sweldens 1999]
  n1,
  /// An eigenvalue at one isolated knot ratio that C^m does not admit.
  n3,
  /// Asymptotic equivalence to a uniform scheme that U1 proves C^m. [Dyn & Levin 1995]
  s1,
  /// Functions that every step of a nonstationary scheme reproduces or generates, as identities.
  s2,
  /// Even or odd coefficients that do not sum to 1 leave no limits but zero; a growing word leaves none for some data.
  p0,
  /// The projective scheme of a mask converges, by contraction over a cone of weights.
  p1,
  /// It is not C^1, by a visible eigenvalue of a word.
  p2,
};

std::string to_string(Theorem theorem);

/// ||S_b^level|| < 1 on the leaf (U1).
struct ContractionWitness {
  int level = 1;
};
/// A norm of bound < 1 for all matrices of section_hull() on the leaf (U1).
struct PolytopeWitness {
  PolytopeNorm norm;
};
/// sigma^{m+1} does not divide the symbol at any point of the leaf (U2).
struct MissingFactorWitness {};
/// The product of the difference sections along the word has spectral radius >= 1 on the leaf (U2).
struct WordWitness {
  std::vector<int> word;
};

/// The eigenvalues at the knot ratio gamma are not those of a C^m scheme, everywhere on the leaf (N3).
struct RatioWitness {
  Rational gamma;
};

/// One box of a proof with the witness that settles it.
struct ProofLeaf {
  Box region;
  std::variant<ContractionWitness, PolytopeWitness, MissingFactorWitness, WordWitness, RatioWitness> witness;
};

/// The witness data of Theorems U1, U2 and N3.
struct LeafProof {
  /// For U2.
  std::optional<Stability> stability;
  std::vector<ProofLeaf> leaves;
};

/// A factor of the characteristic polynomial at an isolated knot ratio, with boxes (parameters, then gamma) that cover
/// gamma in (0, 1] times the region, on each of which its roots are dominated; and the same for 1/gamma in place of gamma, when the
/// rule is not mirror-symmetric.
struct DominatedFactor {
  LambdaPolynomial polynomial;
  int multiplicity = 1;
  std::vector<DominanceLeaf> leaves;
  std::vector<DominanceLeaf> mirrored_leaves;
};

/// The witness data of Theorem N1.
struct KnotProof {
  std::vector<ProofLeaf> uniform_leaves;
  std::vector<DominatedFactor> factors;
  /// Whether the factors have mirrored leaves.
  bool both_sides = false;
};

/// The witness data of Theorem S1.
struct AsymptoticProof {
  AsymptoticBound bound;
  /// The U1 certificate of the limit scheme, in JSON, and its level.
  std::string limit_certificate;
  int limit_level = 0;
};

/// The witness data of Theorem S2.
struct SpaceProof {
  /// From which on the masks are defined by one test.
  int from_level = 0;
  /// One for each function, when it is to be shown that none is reproduced (generated).
  std::vector<MomentDefect> defects;
  /// Of a refutation: the function, by its place in the statement, and the angles at which the opposite is shown for it.
  std::optional<int> function;
  Interval angles;
};

/// The witness data of Theorem P1 and, with the roughness, of Theorem P2.
struct ConeProof {
  ProjectiveContraction contraction;
  std::optional<ProjectiveRoughness> roughness;
};

/// The witness data of Theorem P0: for "not C^m" a growing word.
struct ZeroLimitProof {
  std::optional<std::vector<int>> word;
};

/// A complete proof of a verdict, self-contained: docs/certificate.md defines its JSON form and what limes-check verifies.
struct Certificate {
  std::string scheme;
  VariableNames parameters;
  std::variant<Mask, InsertionRuleText, MaskSequence> definition;
  Claim claim;
  /// certified or refuted
  Outcome verdict = Outcome::certified;
  Theorem theorem = Theorem::u1;
  using Proof = std::variant<LeafProof, KnotProof, AsymptoticProof, SpaceProof, ConeProof, ZeroLimitProof>;
  Proof proof;

  /// Highest level of a contraction leaf, the level of a contraction over a cone, 0 without one.
  int level() const;
  /// Number of boxes of the proof.
  int leaf_count() const;
};

/// The JSON text, deterministic byte by byte.
std::string to_json(const Certificate& certificate);

}  // namespace limes
