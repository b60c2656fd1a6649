#pragma once

#include "algebra/stop.hpp"
#include "analysis/spectral_radius/polytope_norm.hpp"
#include "proofs/certificate.hpp"
#include "proofs/proof_limits.hpp"

#include <map>
#include <optional>
#include <string>

namespace limes {

/// Proves on boxes that the difference scheme S_b of a mask contracts: by the norm of a low level, which is cheap, else by a
/// polytope, which reaches closer to the boundary of the contractive range, else by the norm of a high level.
class ContractionProver {
 public:
  /// \param denominator D, a common denominator of b
  ContractionProver(const LaurentPolynomial& b, const MultivariatePolynomial& denominator, int arity, const ProofLimits& limits,
                    const Stop& stop)
      : b_(b), denominator_(denominator), arity_(arity), limits_(limits), stop_(stop) {}

  struct Attempt {
    std::optional<std::variant<ContractionWitness, PolytopeWitness>> witness;
    /// Why there is none.
    std::string reason;
    /// A point of the box at which S_b seems not to contract, or resists by itself: smaller boxes will not help.
    std::optional<std::vector<Rational>> failing_point;
  };
  Attempt attempt(const Box& box) const;

  /// Where to cut a box on which there is no proof, strictly inside: in the middle, or nearer to an end at which the difference scheme
  /// hardly contracts, so that the least gap 1 - JSR falls by equal factors over the two halves: leaves may be longer far from the
  /// boundary of the contractive range.
  Rational cut(const Box& box, int axis) const;

 private:
  /// The least level at which the norm at the point seems to be below 1; nothing when no level within the limits does.
  std::optional<int> approx_level(const std::vector<Rational>& point) const;
  std::optional<int> new_approx_level(const std::vector<Rational>& point) const;
  bool has_polytope_at(const std::vector<Rational>& point) const;
  bool proves_norm(int level, const Box& box) const;
  std::optional<PolytopeWitness> find_polytope_on(const Box& box) const;
  bool is_cheap(int level, const Box& box) const;
  struct Gaps {
    double lower, upper;
  };
  /// 1 - JSR at the ends of the one axis of the box that is no point, floating; nothing when there are more or the scheme is undefined there.
  std::optional<Gaps> approx_gaps(const Box& box) const;

  const LaurentPolynomial& b_;
  const MultivariatePolynomial& denominator_;
  int arity_;
  const ProofLimits& limits_;
  const Stop& stop_;
  /// What was found out at points: boxes have corners in common.
  mutable std::map<std::vector<Rational>, std::optional<int>> levels_;
  mutable std::map<std::vector<Rational>, bool> has_polytope_;
};

}  // namespace limes
