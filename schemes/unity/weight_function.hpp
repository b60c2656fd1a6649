#pragma once

#include "algebra/expression/expression.hpp"
#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/polynomial.hpp"

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace limes {

/// Polynomials between breaks b_0 < .. < b_r: pieces[k] as a polynomial in u - b_k on [b_k, b_{k+1}), the last piece on a closed
/// interval. Outside zero, or, when `global` (one piece only), the same polynomial everywhere.
struct PiecewisePolynomial {
  std::vector<Rational> breaks;
  std::vector<Polynomial> pieces;
  bool global = false;
};

/// exp(-sigma u^2 / (c^2 - u^2)) for |u| < c, otherwise zero: infinitely smooth. With `interpolating` times sin(pi u) / (pi u).
/// [MoltajiRunionsSamavati2016, eqs. 33 and 34]
struct CinpactWeight {
  Rational radius;  ///< c
  Rational sigma;
  bool interpolating = false;
};

/// Expressions in u, exp, log, sin, cos, sqrt, abs and pi on intervals that meet at their ends; zero outside.
struct PiecewiseExpression {
  std::vector<Rational> breaks;
  std::vector<Expression> pieces;
};

/// A weight function w of partition of unity parametrics, Q(u) = sum_i w(u - i) P_i / sum_i w(u - i): w(u) = shape(u - centre).
/// [MoltajiRunionsSamavati2016, eq. 2]
struct WeightFunction {
  std::variant<PiecewisePolynomial, CinpactWeight, PiecewiseExpression> shape;
  Rational centre;

  static constexpr int infinitely_smooth = std::numeric_limits<int>::max();

  /// The least closed interval known to contain the support; of a global polynomial, its domain.
  Interval support() const;
  /// s with w(s + u) = w(s - u) for all u, when that is known.
  std::optional<Rational> axis() const;
  /// The greatest k with w in C^k on the whole line (-1: it jumps), when that is known.
  std::optional<int> smoothness() const;
};

/// The centred uniform B-spline of a degree on the knots -(d+1)/2, .., (d+1)/2; its integer shifts sum to 1.
/// \throws InputError unless 0 <= degree <= 30
WeightFunction bspline_weight(int degree);
/// \throws InputError for an empty domain, a zero polynomial, a degree above 60
WeightFunction polynomial_weight(const Polynomial& polynomial, const Interval& domain, bool global);
/// \throws InputError unless 0 < c <= 64 and 0 <= sigma <= 10000
WeightFunction cinpact_weight(const Rational& radius, const Rational& sigma, bool interpolating);

/// Reads 'cinpact(c=5, sigma=479/100)', 'interpolating-cinpact(..)', 'bspline(degree=3)', 'polynomial(64-48*u^2, domain=[-2,2])', each with an
/// optional 'centre=..', a polynomial with an optional 'global'. \throws InputError
WeightFunction read_weight(const std::string& text);
/// The same text with another value of an argument. \throws InputError
std::string with_argument(const std::string& text, const std::string& name, const Rational& value);
/// One expression in u for each interval between two breaks; exact when all are polynomials. \throws InputError
WeightFunction piecewise_weight(std::vector<Rational> breaks, std::vector<Expression> pieces);

}  // namespace limes
