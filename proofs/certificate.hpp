#pragma once

#include "analysis/nonstationary/asymptotic_bound.hpp"
#include "analysis/nonstationary/space_moments.hpp"
#include "analysis/nonuniform/dominance_test.hpp"
#include "analysis/spectral_radius/moving_polytope.hpp"
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
  /// The spectral condition of a surface scheme at extraordinary vertices. [Reif 1995; Peters & Reif 2008]
  e1,
  /// With it, a regular and injective characteristic map proves C^1 at extraordinary vertices. [Reif 1995; Zorin 2000]
  e2,
};

std::string to_string(Theorem theorem);

/// ||S_b^level|| < 1 on the leaf (U1).
struct ContractionWitness {
  int level = 1;
};
/// A norm of bound < 1 for all matrices of section_hull() on the leaf, or one for each parameter value there (U1).
struct PolytopeWitness {
  std::variant<PolytopeNorm, MovingNorm> norm;

  const Rational& bound() const;
  /// Vectors of all blocks.
  std::size_t vectors() const;
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

/// c = cos(2 pi/n) between the last cell's end and this one's: one eigenvalue of Fourier block 1 has a modulus above the separator, and
/// it lies in the interval `root`.
struct CosineCell {
  Rational to, separator;
  Interval root;
};

/// Of the spectral condition for all valences n >= from: cells from `start` to 1, and a bound of the other eigenvalues of blocks that no cell
/// knows. Where the second eigenvalue of block 0 has the same limit as the subdominant one, as n grows, it alone is above `touch`.
struct AllValencesProof {
  int from = 3;
  Rational start, bound;
  std::optional<Rational> touch;
  std::vector<CosineCell> cells;
};

/// Characteristic maps are regular and injective: how often the annulus is subdivided, for each single valence, and for all others on
/// intervals of cos(pi/n) from `start` to 1.
struct CharacteristicMapProof {
  struct Piece {
    Rational to;
    int level = 0;
  };
  std::vector<int> levels;
  Rational start;
  std::vector<Piece> pieces;
};

/// The witness data of Theorem E1 and, with a map, of Theorem E2.
struct VertexProof {
  int rings = 1;
  /// Of the curve scheme's contraction (U1 for C^1).
  int level = 1;
  /// From which on the rules are defined by one test, in a nonstationary scheme.
  int from_level = 0;
  /// Of the claim's first valence and the next ones: only 1 and the subdominant eigenvalue have a modulus above it.
  std::vector<Rational> separators;
  /// Of the others, when there is no last valence.
  std::optional<AllValencesProof> all;
  std::optional<CharacteristicMapProof> map;
};

/// A complete proof of a verdict, self-contained: docs/certificate.md defines its JSON form and what limes-check verifies.
struct Certificate {
  std::string scheme;
  VariableNames parameters;
  std::variant<Mask, InsertionRuleText, MaskSequence, SurfaceRule> definition;
  Claim claim;
  /// certified or refuted
  Outcome verdict = Outcome::certified;
  Theorem theorem = Theorem::u1;
  using Proof = std::variant<LeafProof, KnotProof, AsymptoticProof, SpaceProof, ConeProof, ZeroLimitProof, VertexProof>;
  Proof proof;

  /// Highest level of a contraction leaf, the level of a contraction over a cone, 0 without one.
  int level() const;
  /// Number of boxes of the proof; of a proof about vertices, of valences and cells.
  int leaf_count() const;
};

/// The JSON text, deterministic byte by byte.
std::string to_json(const Certificate& certificate);

}  // namespace limes
