#pragma once

#include "algebra/polynomial/multivariate_polynomial.hpp"

namespace limes {

/// numerator / denominator in lowest terms over Q, in a fixed number of variables. The denominator is non-zero, and its leading
/// coefficient in lexicographic order is 1, so that equal functions have equal parts.
class RationalFunction {
 public:
  /// Zero in no variable.
  RationalFunction() : RationalFunction(0) {}
  explicit RationalFunction(int variables);
  /*implicit*/ RationalFunction(MultivariatePolynomial polynomial);
  /// \throws DomainError when the denominator is zero.
  RationalFunction(MultivariatePolynomial numerator, MultivariatePolynomial denominator);
  static RationalFunction constant(int variables, const Rational& c);
  static RationalFunction variable(int variables, int index);

  const MultivariatePolynomial& numerator() const { return numerator_; }
  const MultivariatePolynomial& denominator() const { return denominator_; }
  int variables() const { return numerator_.variables(); }
  bool is_zero() const { return numerator_.is_zero(); }
  bool is_constant() const { return numerator_.is_constant() && denominator_.is_constant(); }
  bool is_polynomial() const { return denominator_.is_constant(); }
  Rational constant_value() const;

  /// Value at a point. \throws DomainError at a pole. \pre point.size() == variables()
  Rational operator()(std::span<const Rational> point) const;
  /// \throws DomainError when the denominator vanishes identically after the substitution.
  RationalFunction substitute(int index, const Rational& value) const;
  RationalFunction substitute(int index, const RationalFunction& value) const;
  RationalFunction mapped(int variables, std::span<const int> map) const;

  RationalFunction operator-() const;
  RationalFunction& operator+=(const RationalFunction&);
  RationalFunction& operator-=(const RationalFunction&);
  RationalFunction& operator*=(const RationalFunction&);
  /// \throws DomainError when the divisor is zero.
  RationalFunction& operator/=(const RationalFunction&);
  friend RationalFunction operator+(RationalFunction a, const RationalFunction& b) { return a += b; }
  friend RationalFunction operator-(RationalFunction a, const RationalFunction& b) { return a -= b; }
  friend RationalFunction operator*(RationalFunction a, const RationalFunction& b) { return a *= b; }
  friend RationalFunction operator/(RationalFunction a, const RationalFunction& b) { return a /= b; }
  friend bool operator==(const RationalFunction& a, const RationalFunction& b);

 private:
  void reduce();
  MultivariatePolynomial numerator_;
  MultivariatePolynomial denominator_;
};

RationalFunction power(const RationalFunction& a, int exponent);
/// Plain text, readable by the expression reader.
std::string to_string(const RationalFunction& a, const VariableNames& names);
/// LaTeX, printed by GiNaC; names such as "beta_1" or "w" become \beta_{1} and w.
std::string to_latex(const RationalFunction& a, const VariableNames& names);

}  // namespace limes
