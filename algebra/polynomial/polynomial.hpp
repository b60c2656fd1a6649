#pragma once

#include "algebra/number/rational.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limes {

/// A univariate polynomial over Q: c_0 + c_1 x + ... + c_n x^n with c_n != 0, or the zero polynomial (degree -1). FLINT inside.
class Polynomial {
 public:
  Polynomial();
  /// coefficients[i] belongs to x^i; trailing zeros are dropped.
  explicit Polynomial(const std::vector<Rational>& coefficients);
  static Polynomial constant(const Rational& c);
  static Polynomial monomial(const Rational& c, int degree);
  Polynomial(const Polynomial&);
  Polynomial(Polynomial&&) noexcept;
  Polynomial& operator=(const Polynomial&);
  Polynomial& operator=(Polynomial&&) noexcept;
  ~Polynomial();

  int degree() const;
  bool is_zero() const { return degree() < 0; }
  /// 0 beyond the degree. \pre i >= 0
  Rational coefficient(int i) const;
  Rational leading_coefficient() const;
  std::vector<Rational> coefficients() const;
  Rational operator()(const Rational& x) const;

  Polynomial operator-() const;
  Polynomial& operator+=(const Polynomial&);
  Polynomial& operator-=(const Polynomial&);
  Polynomial& operator*=(const Polynomial&);
  Polynomial& operator*=(const Rational&);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
  friend Polynomial operator*(Polynomial a, const Polynomial& b) { return a *= b; }
  friend Polynomial operator*(const Rational& c, Polynomial a) { return a *= c; }
  friend bool operator==(const Polynomial& a, const Polynomial& b);

  struct Impl;
  const Impl& impl() const { return *impl_; }
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// {quotient, remainder} with a = quotient b + remainder, deg remainder < deg b. \throws DomainError when b = 0.
std::pair<Polynomial, Polynomial> divide(const Polynomial& a, const Polynomial& b);
/// Monic greatest common divisor; gcd(0, 0) = 0.
Polynomial gcd(const Polynomial& a, const Polynomial& b);
Polynomial derivative(const Polynomial& a);
/// a(b(x)).
Polynomial compose(const Polynomial& a, const Polynomial& b);
Polynomial power(const Polynomial& a, int exponent);
/// x^n a(1/x) for n = deg a. The zero polynomial stays zero.
Polynomial reversed(const Polynomial& a);
/// Monic, with the roots of a, each once. \pre a != 0
Polynomial square_free_part(const Polynomial& a);
/// {(g_i, i)}: pairwise coprime monic square-free g_i of positive degree, a = c prod g_i^i. \pre a != 0
std::vector<std::pair<Polynomial, int>> square_free_factorisation(const Polynomial& a);
/// The n-th cyclotomic polynomial. \pre n >= 1
Polynomial cyclotomic(int n);
std::string to_string(const Polynomial& a, std::string_view variable);

}  // namespace limes
