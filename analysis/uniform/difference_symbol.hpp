#pragma once

#include "schemes/uniform/mask.hpp"

#include <optional>

namespace limes {

/// The symbol b of the scheme of order-k divided differences: a(z) = sigma(z)^k p^{-(k-1)} b(z), sigma = 1 + z + ... + z^{p-1},
/// as an identity in the parameters; nothing when sigma^k does not divide a. k = 0 gives b = a / p.
/// If a(1) = p then b(1) = 1. [Dyn 1992; Dyn & Levin 2002]
/// \pre k >= 0
std::optional<LaurentPolynomial> difference_symbol(const Mask& mask, int k);

/// The remainder of a(z), shifted to lowest exponent 0, by sigma(z)^k: zero exactly when sigma^k divides a.
LaurentPolynomial sum_rule_remainder(const Mask& mask, int k);

/// The greatest k such that sigma^k divides a identically in the parameters: the order of the sum rules. \pre a != 0
int sum_rule_order(const Mask& mask);

/// How much the scheme knows of polynomials, identically in the parameters. Degrees are -1 when even constants fail.
struct PolynomialDegrees {
  /// Greatest d such that polynomials of degree <= d map to polynomials of degree <= d: a(1) = p and sum rules of order d + 1.
  int generation = -1;
  /// Greatest d such that samples of polynomials of degree <= d at t_i = i + shift map to samples at (i + shift) / p, with the one
  /// shift that reproduces linear functions, a'(1) / (p (p - 1)). [Conti & Hormann 2011]
  int reproduction = -1;
  /// That shift (0 for primal, +-1/2 for dual binary schemes); meaningful when reproduction >= 1.
  RationalFunction parameter_shift;
};

PolynomialDegrees polynomial_degrees(const Mask& mask);

}  // namespace limes
