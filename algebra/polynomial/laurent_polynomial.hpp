#pragma once

#include "algebra/polynomial/rational_function.hpp"

#include <optional>
#include <vector>

namespace limes {

/// A Laurent polynomial sum_i c_i z^i in one variable z with coefficients in Q(x_0, .., x_{n-1}). Stored as the lowest exponent
/// and the coefficients from there on; first and last coefficients are non-zero, and zero has no coefficients.
class LaurentPolynomial {
 public:
  LaurentPolynomial() = default;
  explicit LaurentPolynomial(int variables) : variables_(variables) {}
  /// sum_k coefficients[k] z^{lowest + k}; all coefficients in the same number of variables.
  LaurentPolynomial(int variables, int lowest, std::vector<RationalFunction> coefficients);
  static LaurentPolynomial from_rationals(int lowest, const std::vector<Rational>& coefficients);

  int variables() const { return variables_; }
  bool is_zero() const { return coefficients_.empty(); }
  /// Lowest and highest exponent with a non-zero coefficient. \pre not zero
  int lowest() const;
  int highest() const;
  /// highest() - lowest() + 1, or 0.
  int length() const { return static_cast<int>(coefficients_.size()); }
  const std::vector<RationalFunction>& coefficients() const { return coefficients_; }
  /// The coefficient of z^i; zero outside of the support.
  RationalFunction coefficient(int i) const;

  LaurentPolynomial operator-() const;
  LaurentPolynomial& operator+=(const LaurentPolynomial&);
  LaurentPolynomial& operator-=(const LaurentPolynomial&);
  friend LaurentPolynomial operator+(LaurentPolynomial a, const LaurentPolynomial& b) { return a += b; }
  friend LaurentPolynomial operator-(LaurentPolynomial a, const LaurentPolynomial& b) { return a -= b; }
  friend LaurentPolynomial operator*(const LaurentPolynomial& a, const LaurentPolynomial& b);
  friend LaurentPolynomial operator*(const RationalFunction& c, const LaurentPolynomial& a);
  friend bool operator==(const LaurentPolynomial& a, const LaurentPolynomial& b);

  /// z^k a(z).
  LaurentPolynomial shifted(int k) const;
  /// a(z^k). \pre k >= 1
  LaurentPolynomial dilated(int k) const;
  /// a(-z).
  LaurentPolynomial alternated() const;
  /// d/dz.
  LaurentPolynomial differentiated() const;
  /// a(1) or any other rational argument. \pre z != 0
  RationalFunction operator()(const Rational& z) const;
  /// Parameters at a point; the result has no variables. \throws DomainError at a pole.
  LaurentPolynomial at(std::span<const Rational> point) const;
  LaurentPolynomial substitute(int index, const Rational& value) const;
  /// The coefficients as rationals. \throws DomainError when one is not constant.
  std::vector<Rational> rational_coefficients() const;

 private:
  void trim();
  int variables_ = 0;
  int lowest_ = 0;
  std::vector<RationalFunction> coefficients_;
};

/// {quotient, remainder} of a by the polynomial d (lowest exponent 0, leading coefficient constant and non-zero), as identities
/// in the parameters: a = quotient d + remainder with remainder supported on [a.lowest(), a.lowest() + deg d - 1].
std::pair<LaurentPolynomial, LaurentPolynomial> divide(const LaurentPolynomial& a, const LaurentPolynomial& d);
/// 1 + z + ... + z^{arity-1} in the given number of variables.
LaurentPolynomial sigma(int variables, int arity);
LaurentPolynomial power(const LaurentPolynomial& a, int exponent);
/// The least common multiple of the coefficients' denominators, with leading coefficient 1.
MultivariatePolynomial common_denominator(const LaurentPolynomial& a);
/// The polynomials denominator * c for the coefficients c. \throws DomainError when one of them is no polynomial.
std::vector<MultivariatePolynomial> numerators_over(const LaurentPolynomial& a, const MultivariatePolynomial& denominator);

}  // namespace limes
