#pragma once

#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limes {

/// d_0(x) + d_1(x) lambda + .. + d_p(x) lambda^p with d_s in Q[x_0, .., x_{n-1}] and d_p != 0, or zero (degree -1).
/// Characteristic polynomials of non-uniform schemes and their factors have this form, with x = (parameters of the
/// scheme, gamma).
class LambdaPolynomial {
 public:
  explicit LambdaPolynomial(int variables) : variables_(variables) {}
  /// coefficients[s] belongs to lambda^s; trailing zeros are dropped. \pre all in n = `variables` variables
  LambdaPolynomial(int variables, std::vector<MultivariatePolynomial> coefficients);
  /// The inverse of expanded().
  static LambdaPolynomial from_expanded(const MultivariatePolynomial& p);
  /// a lambda - b
  static LambdaPolynomial linear(const MultivariatePolynomial& a, const MultivariatePolynomial& b);

  /// n, without lambda.
  int variables() const { return variables_; }
  /// p, the degree in lambda.
  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  /// d_0 .. d_p
  const std::vector<MultivariatePolynomial>& coefficients() const { return coefficients_; }
  const MultivariatePolynomial& leading() const { return coefficients_.back(); }
  /// The least common multidegree of all d_s.
  std::vector<int> degrees() const;
  /// As a polynomial in n + 1 variables: lambda, x_0, .., x_{n-1}.
  MultivariatePolynomial expanded() const;
  /// The polynomial in lambda at a point. \pre point.size() == variables()
  Polynomial at(std::span<const Rational> point) const;
  /// x_index := value; the number of variables stays.
  LambdaPolynomial substitute(int index, const Rational& value) const;

  friend LambdaPolynomial operator*(const LambdaPolynomial& a, const LambdaPolynomial& b);
  friend bool operator==(const LambdaPolynomial& a, const LambdaPolynomial& b);

 private:
  int variables_;
  std::vector<MultivariatePolynomial> coefficients_;
};

/// a / b when the division is exact, otherwise nothing. \throws DomainError when b = 0.
std::optional<LambdaPolynomial> exact_quotient(const LambdaPolynomial& a, const LambdaPolynomial& b);

/// a = content * part: the content is a greatest common divisor of the d_s; the part has coprime integer coefficients,
/// the lexicographically first of d_p positive. \pre a != 0
struct PrimitivePart {
  MultivariatePolynomial content;
  LambdaPolynomial part;
};
PrimitivePart primitive_part(const LambdaPolynomial& a);

/// "d_p*lambda^p + .." in plain text; names are those of x_0, x_1, ...
std::string to_string(const LambdaPolynomial& a, const VariableNames& names);

}  // namespace limes
