// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/polynomial.hpp"

#include <nlohmann/json_fwd.hpp>

#include <compare>
#include <optional>

namespace limes::checker {

/// sum_e p[e] x^e with non-zero coefficients, e of either sign.
using Laurent = std::map<int, mpq_class>;
Laurent add(Laurent p, const Laurent& q, const mpq_class& factor = 1);
/// The nanoseconds of a multiplication.
double multiply_cost(const Laurent& p, const Laurent& q);
Laurent multiply(const Laurent& p, const Laurent& q, Budget& budget);

/// A control point (a, b) of a sector, between two spokes of an isolated vertex (face) of valence n. Primal schemes: (0, 0) is the
/// vertex, else a >= 1, b >= 0, and (a, 0) is spoke s; in the grid of sector s, (0, b) is (b, 0) of sector s+1. Dual schemes: a, b >= 0.
struct RingPoint {
  int a = 0, b = 0;
  auto operator<=>(const RingPoint&) const = default;
};

/// A term of a rule for a new point of sector s: weight p_{s+sector}(point), or, with a harmonic h >= 0,
/// weight (1/n) sum_t cos(2 pi h (t - s)/n) p_t(point).
struct RingTerm {
  RingPoint point;
  int sector = 0, harmonic = -1;
  Fraction weight;  ///< in the scheme's variables
};

/// A scheme of kind "surface". New points that have no rule of their own follow the tensor product of the mask.
struct RingScheme {
  std::string name;
  bool dual = false;
  int last = 0;  ///< the mask's indices run from -last (dual: 1 - last) to last
  /// "n" and, for a nonstationary scheme, before it the level parameter.
  std::vector<std::string> variables;
  std::string angle;  ///< of a nonstationary scheme, the parameter theta: mu_k = cos x_k (hyperbolic: cosh x_k), x_k = theta 2^{-(k+1)}
  bool hyperbolic = false;
  std::vector<Fraction> mask;  ///< in the scheme's variables; n does not occur
  std::map<RingPoint, std::vector<RingTerm>> given;

  bool has_levels() const { return variables.size() > 1; }
  int first() const { return dual ? 1 - last : -last; }
  /// The greatest coordinate of a point with a rule of its own; -1 without one.
  int given_reach() const;
};

/// \throws Rejected at "scheme"
RingScheme read_ring_scheme(const nlohmann::json& json, Budget& budget);
/// The same for mu = 1: weights in n alone. \throws Rejected at "denominator"
RingScheme limit_scheme(const RingScheme& scheme, Budget& budget);

/// The points of a sector in the rings up to `rings` but for the vertex, by (ring, a, b).
std::vector<RingPoint> sector_points(bool dual, int rings);
/// Ring of a point: max(a, b), in dual schemes one more.
inline int ring_of(bool dual, RingPoint p) { return (p.a < p.b ? p.b : p.a) + (dual ? 1 : 0); }

/// The rule of a new point of sector 0. \throws Rejected at "scheme" when the tensor product would reach beyond the vertex (face)
std::vector<RingTerm> ring_rule(const RingScheme& scheme, RingPoint point, Budget& budget);

/// What a new point of sector 0 takes from the old points (a, b) of all sectors: sum_k by_sector[k] p_k, and weights of means with
/// harmonics 0 and 1. Weights are Laurent polynomials in x = 1/n; for one valence, constants.
struct RingEntry {
  std::map<int, Laurent> by_sector;
  Laurent mean, first;
};
using RingRow = std::map<RingPoint, RingEntry>;
/// \pre the only variable is n. \throws Rejected at "scheme", also when a weight is no Laurent polynomial in n
RingRow ring_row(const RingScheme& scheme, RingPoint point, std::optional<int> valence, Budget& budget);

/// A square matrix, row by row.
struct RingMatrix {
  std::size_t size = 0;
  std::vector<Laurent> entries;
  const Laurent& at(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

/// The subdivision matrix on the points of `rings` rings, p_t = omega^t p_0: rows and columns are sector_points(). In block j, omega =
/// e^{2 pi i j/n}.
struct RingBlocks {
  std::vector<RingPoint> points;
  std::vector<std::size_t> image;  ///< of the points under the reflection of sector 0 (of a point of spoke 0: on spoke 1)
  RingMatrix zero;     ///< block 0, in x = 1/n; primal schemes: the vertex comes first
  RingMatrix first;    ///< blocks 1 and n - 1, in omega
  RingMatrix generic;  ///< the others, in omega
};

/// Verified are: the rings are invariant and contain the points with rules of their own, rows sum to 1, the rules are symmetric
/// under the reflections of the n-gon. \throws Rejected at "rings", "sum", "symmetry" or "scheme"
RingBlocks ring_blocks(const RingScheme& scheme, int rings, std::optional<int> valence, Budget& budget);

/// det(lambda - M) is a product of polynomials in lambda, c_0, .., c_d = 1 of each: one for every strongly connected part of M, made closed
/// under an involution of the indices.
std::vector<std::vector<Laurent>> characteristic_factors(const RingMatrix& matrix, const std::vector<std::size_t>& image,
                                                         Budget& budget);

/// What the spectrum says about surfaces, it says because: the curve scheme is C^1, by theorem U1 at this level; so many rings determine the
/// limit near the vertex (face); and every control point of theirs but for the vertex has influence on it.
/// \pre the only variable is n. \throws Rejected at "rings", "effective" or a step of theorem U1
void prove_regular_part(const RingScheme& scheme, int rings, int level, Budget& budget);

}  // namespace limes::checker
