#pragma once

#include "analysis/spectral_radius/algebraic_number.hpp"
#include "analysis/spectral_radius/polytope_norm.hpp"

#include <variant>

namespace limes {

/// A vector over Q(alpha): entries are polynomials in alpha.
using AlgebraicVector = std::vector<Polynomial>;

/// A proof that JSR = alpha for a family of one block, alpha algebraic: B_word v_0 = sign alpha^{|word|} v_0 shows JSR >= alpha; and
/// P, the hull of +-v_1 .. +-v_M and +-unit e_k, satisfies B_e P in alpha P. The vectors are the starts and then, for each
/// (i, e) of the tree, B_e v_i / alpha. images[e][i], i < M, says why B_e v_i is in alpha P: it is +-alpha v_j exactly, or a combination as in
/// Polytope with norm <= the lower end of alpha; so does images[e][M + k] for B_e (unit e_k). [Guglielmi & Protasov 2013, 2016]
struct ExactPolytope {
  struct SignedVector {
    int index = 0;
    int sign = 1;
  };
  using Image = std::variant<SignedVector, SparseCombination>;

  AlgebraicNumber radius;
  Word word;
  int sign = 1;
  std::vector<AlgebraicVector> starts;
  std::vector<std::pair<int, int>> tree;   // (i, e)
  Rational unit = 1;
  std::vector<std::vector<Image>> images;
};

/// Looks for such a proof with leading words as starts: it exists when the leading products have real, simple leading eigenvalues and
/// all others are smaller by a gap; nothing when the polytope does not close within the limits. What is returned is proved.
std::optional<ExactPolytope> find_exact_polytope(const MatrixFamily& family, const PolytopeLimits& limits, const Stop& stop);

}  // namespace limes
