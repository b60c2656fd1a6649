#pragma once

#include "algebra/polynomial/root_clusters.hpp"
#include "algebra/stop.hpp"
#include "analysis/surface/vertex_matrix.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limes {

/// An eigenvalue of the subdivision matrix around a vertex of valence n, as an eigenvalue of its Fourier blocks j and n - j.
struct VertexEigenvalue {
  /// Closed; a point when the eigenvalue is rational and known exactly. im = {0}: real.
  Interval re, im, modulus;
  /// In the whole matrix as far as it belongs to the blocks `fourier` and n - fourier (twice that of one block when these are two).
  int multiplicity = 1;
  /// j, 0 <= j <= n/2.
  int fourier = 0;
  /// More than one eigenvalue, which the precision cannot tell apart; multiplicity is the sum of theirs.
  bool is_cluster = false;
  /// The factor of the block's characteristic polynomial that has it as a root, in lambda, c = cos(2 pi j/n) and mu; several for a cluster.
  std::string factor;
};

/// The level parameter mu: exact, or an irrational number, which is enclosed to any number of bits. As it may be transcendental,
/// multiplicities that it alone causes show as clusters.
struct LevelParameter {
  std::optional<Rational> exact;
  std::function<Interval(int bits)> enclosure;
};

/// Eigenvalues for any level parameter and valence. Characteristic polynomials are split into irreducible factors over Q (mu exact), or into
/// square-free ones over Q(mu), as polynomials in lambda and c; their roots at c = cos(2 pi j/n) are enclosed, and told apart by
/// disjoint enclosures, or, for exact mu, by an exact square-free decomposition over Q(c).
class VertexSpectrum {
 public:
  /// \param rings 0: the least number that works
  /// \throws InputError when the rules are not mirror symmetric, or the rings not invariant
  explicit VertexSpectrum(RingRule rule, int rings = 0);
  ~VertexSpectrum();

  /// All eigenvalues by falling modulus; where enclosures of moduli overlap, by rising Fourier index, then real ones first, then by falling real part.
  /// Enclosures are about 2^-bits wide, if nothing is in a cluster. \pre n >= 3, 16 <= bits <= 1024
  /// \throws DomainError at a pole
  std::vector<VertexEigenvalue> eigenvalues(int n, const LevelParameter& level, int bits = 64, const Stop& stop = Stop()) const;
  /// The number of eigenvalues of the whole matrix: its size.
  int size(int n) const;
  int rings() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limes
