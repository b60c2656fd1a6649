#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <vector>

namespace limes {

/// A rectangle that contains exactly `count` roots, with their multiplicities, of every polynomial whose coefficients lie in given intervals; with
/// count = 1 and im = {0} the root is real. Closed intervals.
struct RootCluster {
  Interval re, im, modulus;
  int count = 1;
};

/// The roots of sum_k coefficients[k] x^k, all together, in pairwise disjoint rectangles; coefficients are evaluated at a point of a box in
/// ball arithmetic of `bits` bits. Around approximate roots z_i of a monic polynomial p of degree d lie the discs of radius
/// d |p(z_i)| / prod_{k != i} |z_i - z_k|; their union contains all roots, and each connected component of m discs m of them [Smith 1970].
/// Roots closer than the precision, or the width of the box, can tell are in one cluster.
/// \pre the last coefficient is not zero on the box, all have box.size() variables
/// \throws DomainError when the last coefficient may vanish
std::vector<RootCluster> enclose_root_clusters(const std::vector<MultivariatePolynomial>& coefficients, const Box& box, int bits);

}  // namespace limes
