#pragma once

#include "schemes/surface/ring_rule.hpp"

#include <vector>

namespace limes {

/// Block j of the subdivision matrix on the control points of some rings around an isolated vertex (face) of valence n: the matrix is
/// circulant in the sectors, and the discrete Fourier transform over these, p_s = omega^s p_0 with omega = e^{2 pi i j/n}, leaves one matrix
/// on the points of one sector for each j = 0 .. n-1. Entries are Laurent polynomials in omega over Q(mu, n).
struct VertexBlock {
  /// Those of sector 0 (sector_points); block 0 of a primal scheme has the centre 0,0 before them.
  std::vector<RingPoint> points;
  /// Row by row: the row of a new point, the column of an old one.
  std::vector<LaurentPolynomial> entries;

  int size() const { return static_cast<int>(points.size()); }
  const LaurentPolynomial& operator()(int row, int column) const { return entries[static_cast<std::size_t>(row * size() + column)]; }
  /// The same at one mu and n, as constants in the same two variables. \throws DomainError at a pole
  VertexBlock at(const Rational& mu, int n) const;
  VertexBlock at_valence(int n) const;
};

/// The block of a j that is no harmonic of the rule: j != +-k mod n for its harmonics k. \pre rings >= rule.invariant_rings()
VertexBlock generic_block(const RingRule& rule, int rings);
/// The block of j = k >= 0, when no other harmonic of the rule is +-k mod n and 2k is not 0 mod n or k = 0; omega is e^{2 pi i k/n}
/// (k = 0: all exponents of omega are 0).
VertexBlock harmonic_block(const RingRule& rule, int rings, int k);
/// Block j of valence n, whatever coincides; weights in n are taken at n, mu stays. (j = 0: all exponents of omega are 0.) \pre n >= 3
VertexBlock block(const RingRule& rule, int rings, int n, int j);

/// The harmonics of the rules, ascending, always with 0.
std::vector<int> harmonics(const RingRule& rule);

/// Whether affine combinations stay such: for every n, all rules of new points in these rings have weights of sum 1.
bool rows_sum_to_one(const RingRule& rule, int rings);
/// Whether the rules of these rings are those of the mirrored mesh: (a, b) of sector s <-> (b, a) of sector -s, and spoke s <-> spoke
/// 1 - s, (a, 0) of sector s <-> (a, 0) of sector 1 - s of a primal scheme. Then block j and block n - j are similar, and characteristic
/// polynomials are polynomials in c = cos(2 pi j/n).
bool mirror_symmetric(const RingRule& rule, int rings);

/// A polynomial sum_k coefficients[k] lambda^k with coefficients in Q[mu, n, c], c = (omega + 1/omega)/2; the last one is free of c.
struct LambdaPolynomialInC {
  std::vector<MultivariatePolynomial> coefficients;
  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
};

/// The characteristic polynomial of a block as a product, up to factors that depend on mu and n only: one for each irreducible diagonal block of its
/// triangular form (by the exact pattern of zeros), mirror images together.
/// \throws DomainError when one of them is not symmetric in omega and 1/omega, as it is for mirror-symmetric rules
std::vector<LambdaPolynomialInC> characteristic_factors(const VertexBlock& block);
/// Their product.
LambdaPolynomialInC characteristic_polynomial(const VertexBlock& block);

}  // namespace limes
