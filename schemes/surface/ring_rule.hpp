#pragma once

#include "algebra/polynomial/rational_function.hpp"
#include "schemes/uniform/mask.hpp"

#include <map>
#include <vector>

namespace limes {

/// A control point near an isolated vertex (primal schemes) or face (dual schemes) of valence n, in one of its n sectors.
///
/// Primal: (0, 0) is the vertex itself, which belongs to all sectors; a sector has the points a >= 1, b >= 0. The points (a, 0) are spoke s,
/// and (0, b) of sector s is (b, 0) of sector s + 1: spoke s + 1. Lines of the mesh that pass the vertex go on beyond a spoke:
/// (a, -b) of sector s is (b, a) of sector s - 1 (a >= 0, b >= 1), and (-a, b) of sector s is (b, a) of sector s + 1 (a, b >= 1); as part of
/// a footprint at the side b >= 0 of the line of spoke s, (-a, 0) is (a, 0) of sector s + 2.
/// Dual: a sector has the points a >= 0, b >= 0; (a, -1 - b) of sector s is (b, a) of sector s - 1, (-1 - a, b) is (b, a) of sector s + 1.
/// Ring r holds the points with max(a, b) = r (primal; r = 0 is the vertex), max(a, b) = r - 1 (dual).
struct RingPoint {
  int a = 0;
  int b = 0;
  auto operator<=>(const RingPoint&) const = default;
};

/// A term of a rule for a new point of sector s, where p_t(x) is the old point x of sector t:
///
///     weight * p_{s+sector}(x)                                     harmonic < 0
///     weight * (1/n) sum_t cos(2 pi harmonic (t - s)/n) p_t(x)     harmonic = 0 (the mean), 1, ..
///
/// In Fourier block j (p_t = omega^t p_0, omega = e^{2 pi i j/n}) the first is weight * omega^sector, the second is weight for j = 0 =
/// harmonic, weight/2 for j = +-harmonic != 0 mod n (twice that where both coincide), and 0 in every other block. So blocks depend on n by
/// omega and by the weights only.
struct RingTerm {
  RingPoint point;
  int sector = 0;
  int harmonic = -1;
  /// In two variables: mu, the level parameter (variable 0), and the valence n (variable 1).
  RationalFunction weight;
};

/// The rules of a scheme for quadrilateral meshes around an isolated extraordinary vertex or face: where the mask of the curve scheme, as a
/// tensor product, has all of its old points at one side of a line through the vertex (face), it is that; elsewhere the rule is given.
struct RingRule {
  bool dual = false;
  /// The curve scheme, in mu (variable 0 of two), symmetric: a_{-i} = a_i (primal), a_{1-i} = a_i (dual).
  Mask curve;
  /// The new points of sector 0 that have a rule of their own.
  std::map<RingPoint, std::vector<RingTerm>> given;

  /// The rule of a new point of sector 0: the one given, or the tensor product.
  /// \throws InputError when the tensor product would need points beyond the extraordinary vertex (face).
  std::vector<RingTerm> at(RingPoint point) const;
  /// The least number R of rings such that new points of the rings up to R depend on old ones of the rings up to R only, and at least
  /// `least` and 1.
  /// \throws InputError as at(), and when there is none up to 20.
  int invariant_rings(int least = 0) const;
};

/// The points of a sector in the rings up to `rings`, without the centre of a primal scheme: in the order of (ring, a, b).
std::vector<RingPoint> sector_points(bool dual, int rings);
/// max(a, b), and one more for dual schemes.
int ring_of(bool dual, RingPoint point);

/// A rule without given points for a symmetric binary mask in at most one variable (mu): primal when it has odd length.
/// \throws InputError for other masks
RingRule tensor_rule(const Mask& curve);
/// The rule of a four-point scheme (alpha, 0, beta, 1, beta, 0, alpha) that continues the spokes L_i through the vertex P by virtual points
///
///     V_i = (4/n) sum L - (L_{i-1} + L_i + L_{i+1}) + kappa (K_{i-2} + K_{i-1} + K_i + K_{i+1} - (4/n) sum K),  kappa = -alpha/beta,
///
/// K_i the diagonal vertex of the face between L_i and L_{i+1}. [Kobbelt 1996; Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, corrected]
/// \throws InputError for other masks
RingRule virtual_point_rule(const Mask& curve);

}  // namespace limes
