#pragma once

#include "algebra/stop.hpp"
#include "analysis/spectral_radius/invariant_subspace.hpp"

#include <optional>

namespace limes {

/// sum_j c_j v_j as pairs (j, c_j).
using SparseCombination = std::vector<std::pair<int, Rational>>;

/// The norm whose unit ball P is the convex hull of +-v_1 .. +-v_M and +-unit e_1 .. +-unit e_n, and combinations that show
/// B_e P to lie in R P: images[e][i] belongs to B_e v_i for i < M and to B_e (unit e_{i-M}) for i >= M. With the exact remainder
/// r = B_e v_i - sum_j c_j v_j one has ||B_e v_i|| <= sum_j |c_j| + ||r||_1 / unit; the remainder is not stored.
struct Polytope {
  std::vector<std::vector<Rational>> vectors;
  Rational unit;
  std::vector<std::vector<SparseCombination>> images;
};

/// Polytopes for the diagonal blocks of a block triangular form of a family: JSR <= bound for the family.
struct PolytopeNorm {
  Rational bound;
  BlockTriangularForm form;
  std::vector<Polytope> blocks;
};

/// max over e and i of sum_j |c_j| + ||r||_1 / unit, exactly: an upper bound R of the joint spectral radius of the family of one
/// block. Floating point has no part in it. \pre unit > 0
Rational exact_polytope_bound(const Polytope& polytope, const MatrixFamily& family);

/// What the search for a polytope may cost.
struct PolytopeLimits {
  /// Vectors of one block.
  std::size_t max_vectors = 1500;
  /// Coordinates of vectors are multiples of 2^-precision, at unit scale.
  int precision = 64;
};

/// A polytope norm in which no B_e is longer than `bound`, so that JSR <= bound; nothing when none was found, in particular when
/// bound < JSR. Above the joint spectral radius one exists, and the work grows as `bound` approaches it: the vectors are
/// images of leading eigenvectors under products [Guglielmi & Protasov 2013, 2016]. What is returned is proved.
///
/// For matrices affine in a parameter on an interval, take the matrices at both ends as one family: R P is convex, so the same norm
/// proves JSR <= bound at every parameter value in between (blocks included). \pre bound > 0
std::optional<PolytopeNorm> find_polytope(const MatrixFamily& family, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop);
std::optional<PolytopeNorm> find_polytope(const BlockTriangularForm& form, const Rational& bound, const PolytopeLimits& limits,
                                          const Stop& stop);

}  // namespace limes
