#pragma once

#include "algebra/stop.hpp"
#include "proofs/certificate.hpp"
#include "proofs/proof_limits.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes {

/// What a prover brings back: leaves that cover the region, or why there are none and where it got stuck.
struct ProofAttempt {
  bool proved = false;
  std::vector<ProofLeaf> leaves;
  std::optional<Stability> stability;
  /// Why it is not proved, without the place.
  std::string reason;
  /// A parameter value at which the attempt failed: a candidate for the opposite.
  std::optional<std::vector<Rational>> failing_point;
};

/// The scheme on a region: parameters of point intervals substituted (their number stays the same), and D, the least common
/// denominator of the mask before the substitution, with them substituted in it. A certificate writes the mask over D.
struct RestrictedMask {
  Mask mask;
  MultivariatePolynomial denominator;
};

RestrictedMask restricted(const Mask& mask, const Box& region);

/// Theorem U1: tries to prove C^m at every parameter value of the region, by a(1) = p, sigma^{m+1} | a and ||S_b^l|| < 1 on leaves found by bisection, each
/// with a level of its own.
ProofAttempt prove_smooth(const Mask& mask, int m, const Box& region, const ProofLimits& limits, const Stop& stop);

/// Theorem U2: tries to prove that the scheme is C^m at no parameter value of the region, by proved stability and, on each leaf, a missing factor of
/// the symbol or a word of difference sections with spectral radius >= 1.
ProofAttempt prove_not_smooth(const Mask& mask, int m, const Box& region, const ProofLimits& limits, const Stop& stop);

/// A few parameter values of the region: the midpoint first, then the corners that belong to it.
std::vector<std::vector<Rational>> sample_points(const Box& region);

/// The rational zeros in the region that all polynomials share, ascending, when exactly one parameter is free; otherwise none.
std::vector<Rational> common_rational_zeros(const std::vector<MultivariatePolynomial>& polynomials, const Box& region);

/// The region cut at ascending values of its one free parameter: open pieces between closed points.
std::vector<Box> cut_at(const Box& region, const std::vector<Rational>& values);

}  // namespace limes
