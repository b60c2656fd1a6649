#pragma once

#include "analysis/spectral_radius/polytope_norm.hpp"

#include <array>

namespace limes {

/// c_j(s) v_j(s), or c_j(s) conj(v_j(s)): c_j is a quadratic with the Bernstein coefficients re + i im.
struct MovingTerm {
  int index = 0;
  bool conjugate = false;
  std::array<Rational, 3> re;
  std::array<Rational, 3> im;
};
using MovingCombination = std::vector<MovingTerm>;

/// A norm for each s in [0, 1]: its unit ball P(s) is the hull of all z v_j(s), z conj(v_j(s)) and z unit e_k, |z| = 1, as for a Polytope, with
/// v_j(s) = (1 - s) v_j(0) + s v_j(1). For matrices B_e(s) = (1 - s) B_e(0) + s B_e(1), images[e][i] shows B_e(s) P(s) to lie in R P(s) for
/// all s: in ||B_e(s) v_i(s)|| <= sum |c_j(s)| + ||r(s)||_1 / unit the sum has at most the quadratic with Bernstein coefficients
/// sum_j |c_j,k| as value, the remainder r is cubic, and so Bernstein coefficients bound both. i >= M belongs to unit e_{i-M}.
///
/// A fixed polytope proves a bound R for an interval about as long as the gap between R and the radius: B_e(0) v and B_e(1) v are too
/// far apart. Vectors that move with the matrices leave remainders of third order in the length.
struct MovingPolytope {
  std::vector<std::array<std::vector<Rational>, 2>> vectors;
  Rational unit = 1;
  std::vector<std::vector<MovingCombination>> images;
};

/// Moving polytopes for the diagonal blocks of a form of the matrices at both ends: JSR(s) <= bound for all s in [0, 1].
struct MovingNorm {
  Rational bound;
  BlockTriangularForm form;
  std::vector<MovingPolytope> blocks;
};

/// max over e and i of the Bernstein coefficients of sum |c_j| + ||r||_1 / unit, exactly but for square roots that are rounded up.
/// \param ends B_0(0) .. B_{m-1}(0), B_0(1) .. B_{m-1}(1) \pre unit > 0
Rational exact_moving_bound(const MovingPolytope& polytope, const MatrixFamily& ends);

/// Looks for moving polytopes in which no B_e(s) is longer than `bound`; nothing when none was found. The vectors are the orbits of leading
/// eigenvectors at both ends under the same words [after Guglielmi & Protasov 2013]. What is returned is proved.
/// \param ends as above \pre bound > 0, an even number of matrices
std::optional<MovingNorm> find_moving_polytope(const MatrixFamily& ends, const Rational& bound, const PolytopeLimits& limits, const Stop& stop);

}  // namespace limes
