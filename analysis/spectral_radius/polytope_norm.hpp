#pragma once

#include "algebra/stop.hpp"
#include "analysis/spectral_radius/invariant_subspace.hpp"

#include <optional>

namespace limes {

/// (re + i im) v_index, or of conj(v_index).
struct HullTerm {
  int index = 0;
  bool conjugate = false;
  Rational re;
  Rational im;
};
using SparseCombination = std::vector<HullTerm>;

/// The norm on C^n whose unit ball P is the convex hull of all z v_j, z conj(v_j) and z unit e_k, |z| = 1 (with real vectors and real
/// coefficients only: the hull of +-v_j and +-unit e_k in R^n), and combinations that show B_e P to lie in R P: images[e][i] belongs to
/// B_e v_i for i < M and to B_e (unit e_{i-M}) for i >= M. With the exact remainder r = B_e v_i - sum of terms,
/// ||B_e v_i|| <= sum |c_j| + ||r||_1 / unit; the remainder is not stored.
struct Polytope {
  /// Of length n, or 2n: real parts, then imaginary parts.
  std::vector<std::vector<Rational>> vectors;
  Rational unit = 1;
  std::vector<std::vector<SparseCombination>> images;
};

/// Polytopes for the diagonal blocks of a block triangular form of a family: JSR <= bound for the family.
struct PolytopeNorm {
  Rational bound;
  BlockTriangularForm form;
  std::vector<Polytope> blocks;
};

/// max over e and i of sum_j |c_j| + ||r||_1 / unit, exactly but for square roots that are rounded up: an upper bound R of the joint
/// spectral radius of the family of one block. Floating point has no part in it. \pre unit > 0
Rational exact_polytope_bound(const Polytope& polytope, const MatrixFamily& family);

/// What the search for a polytope may cost.
struct PolytopeLimits {
  /// Vectors of one block.
  std::size_t max_vectors = 1000;
  /// Coordinates of vectors are multiples of 2^-precision, at unit scale.
  int precision = 64;
  /// From 0 to 1: how much of the room between the radius of the leading words and the bound is used to keep the vectors few. Vectors are
  /// stretched by up to the inverse of the radius, so that near images of nearby matrices (those at both ends of a short
  /// interval) lie inside. With 0 the vectors are those of the orbit scaled by the bound.
  double eagerness = 0;
  /// With eagerness, how much room allows real vectors although the leading eigenvalue is complex.
  double real_room = 0.002;
  /// Of the field of an exact polytope: arithmetic there takes long where the degree is high.
  int max_degree = 64;
};

/// A polytope in which no B_e is longer than `bound`; nothing when none was found, in particular when bound < JSR. Above the joint
/// spectral radius one exists, and the work grows as `bound` approaches it: the vectors are images of leading eigenvectors (real
/// or complex) under products [Guglielmi & Protasov 2013, 2016]. What is returned is proved. \pre bound > 0
std::optional<Polytope> find_block_polytope(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits,
                                            const Stop& stop);

/// The same for every diagonal block, so that JSR <= bound.
///
/// For matrices affine in a parameter on an interval, take the matrices at both ends as one family: R P is convex, so the same norm
/// proves JSR <= bound at every parameter value in between (blocks included). \pre bound > 0
std::optional<PolytopeNorm> find_polytope(const BlockTriangularForm& form, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop);
std::optional<PolytopeNorm> find_polytope(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop);

}  // namespace limes
