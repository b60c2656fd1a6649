#pragma once

#include "algebra/number/rational.hpp"
#include "algebra/polynomial/polynomial.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limes {

/// The names of the variables x_0, x_1, ... in printing and reading. A polynomial itself knows only how many there are.
using VariableNames = std::vector<std::string>;

/// A polynomial over Q in a fixed number of variables x_0 .. x_{n-1} (n may be 0: constants). FLINT inside; operands of one
/// operation must have the same n. \throws DomainError when they do not.
class MultivariatePolynomial {
 public:
  /// One term c x^e; exponents.size() == variables().
  struct Term {
    std::vector<int> exponents;
    Rational coefficient;
  };

  /// Zero in no variable.
  MultivariatePolynomial();
  explicit MultivariatePolynomial(int variables);
  static MultivariatePolynomial constant(int variables, const Rational& c);
  /// The variable x_index. \pre 0 <= index < variables
  static MultivariatePolynomial variable(int variables, int index);
  static MultivariatePolynomial from_terms(int variables, const std::vector<Term>& terms);
  MultivariatePolynomial(const MultivariatePolynomial&);
  MultivariatePolynomial(MultivariatePolynomial&&) noexcept;
  MultivariatePolynomial& operator=(const MultivariatePolynomial&);
  MultivariatePolynomial& operator=(MultivariatePolynomial&&) noexcept;
  ~MultivariatePolynomial();

  int variables() const;
  bool is_zero() const;
  bool is_constant() const;
  /// The value of a constant polynomial. \throws DomainError when it is not constant.
  Rational constant_value() const;
  /// Degree in x_index; -1 for the zero polynomial.
  int degree(int index) const;
  /// Degrees in all variables (0s for the zero polynomial).
  std::vector<int> degrees() const;
  /// Non-zero terms in descending lexicographic order.
  std::vector<Term> terms() const;
  std::size_t term_count() const;

  /// Value at a point. \pre point.size() == variables()
  Rational operator()(std::span<const Rational> point) const;
  /// x_index := value; the result has the same number of variables.
  MultivariatePolynomial substitute(int index, const Rational& value) const;
  /// x_index := q(x); the result has the same number of variables.
  MultivariatePolynomial substitute(int index, const MultivariatePolynomial& q) const;
  /// The same polynomial among `variables` variables, x_i becoming x_{map[i]}. \throws DomainError when a used variable has no image.
  MultivariatePolynomial mapped(int variables, std::span<const int> map) const;
  /// Coefficients with respect to x_index: element k multiplies x_index^k and does not contain x_index.
  std::vector<MultivariatePolynomial> coefficients(int index) const;
  /// As a univariate polynomial in x_index. \throws DomainError when another variable occurs.
  Polynomial univariate(int index) const;
  static MultivariatePolynomial from_univariate(int variables, int index, const Polynomial& p);

  MultivariatePolynomial operator-() const;
  MultivariatePolynomial& operator+=(const MultivariatePolynomial&);
  MultivariatePolynomial& operator-=(const MultivariatePolynomial&);
  MultivariatePolynomial& operator*=(const MultivariatePolynomial&);
  MultivariatePolynomial& operator*=(const Rational&);
  friend MultivariatePolynomial operator+(MultivariatePolynomial a, const MultivariatePolynomial& b) { return a += b; }
  friend MultivariatePolynomial operator-(MultivariatePolynomial a, const MultivariatePolynomial& b) { return a -= b; }
  friend MultivariatePolynomial operator*(MultivariatePolynomial a, const MultivariatePolynomial& b) { return a *= b; }
  friend MultivariatePolynomial operator*(const Rational& c, MultivariatePolynomial a) { return a *= c; }
  friend bool operator==(const MultivariatePolynomial& a, const MultivariatePolynomial& b);

  struct Impl;
  const Impl& impl() const { return *impl_; }
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// a / b when the division is exact, otherwise nothing. \throws DomainError when b = 0.
std::optional<MultivariatePolynomial> exact_quotient(const MultivariatePolynomial& a, const MultivariatePolynomial& b);
/// Greatest common divisor, normalised to leading coefficient 1 in lexicographic order; gcd(0, 0) = 0.
MultivariatePolynomial gcd(const MultivariatePolynomial& a, const MultivariatePolynomial& b);
MultivariatePolynomial power(const MultivariatePolynomial& a, int exponent);
/// {(g_i, e_i)}: a = c prod g_i^{e_i}, g_i irreducible over Q. Can take minutes for dense polynomials; meant for small ones
/// (display of factors). \pre a != 0
std::vector<std::pair<MultivariatePolynomial, int>> factorisation(const MultivariatePolynomial& a);
/// Plain text such as "-3*w - 1/16", readable by the expression reader.
std::string to_string(const MultivariatePolynomial& a, const VariableNames& names);

}  // namespace limes
