#pragma once

#include "algebra/polynomial/polynomial.hpp"

#include <optional>

namespace limes {

/// The only root of `polynomial`, irreducible over Q and monic, in the interval [lower, upper]; lower == upper when it is rational.
struct AlgebraicNumber {
  Polynomial polynomial;
  Rational lower;
  Rational upper;

  bool is_rational() const { return polynomial.degree() == 1; }
};

/// The same number in an interval of width <= 2^-bits.
AlgebraicNumber refined(AlgebraicNumber x, int bits);

/// alpha = |lambda|^{1/root} for a real root lambda != 0 of `chi` near `value`, with sign(lambda) = sign(value): the irreducible factor
/// of f(+-x^root), f that of chi, with a root near |value|^{1/root}. Nothing when chi has no or more than one such root within a relative distance 1e-6 of value, or when its
/// degree would exceed 64.
/// \pre chi != 0, value != 0, root >= 1
std::optional<AlgebraicNumber> algebraic_root(const Polynomial& chi, double value, int root);

/// The field Q(alpha), elements as polynomials in alpha of degree < deg alpha.
class NumberField {
 public:
  /// \pre alpha > 0
  explicit NumberField(AlgebraicNumber alpha);
  const AlgebraicNumber& alpha() const { return alpha_; }
  Polynomial reduced(const Polynomial& p) const { return divide(p, alpha_.polynomial).second; }
  /// p alpha^k, k of any sign.
  Polynomial times_power(const Polynomial& p, int k) const;
  /// A multiple of 2^-bits within `error` of p(alpha), and that error bound.
  struct Enclosure {
    Rational value;
    Rational error;
  };
  Enclosure enclose(const Polynomial& p, int bits) const;

 private:
  mutable AlgebraicNumber alpha_;  // narrowed when an enclosure needs it
  Polynomial inverse_;  // of alpha
};

}  // namespace limes
