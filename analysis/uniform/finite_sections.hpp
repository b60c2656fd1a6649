#pragma once

#include "algebra/matrix/polynomial_matrix.hpp"
#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/laurent_polynomial.hpp"

#include <vector>

namespace limes {

/// The size of the index set R of the finite sections for a symbol of degree N: max(1, ceil(N/(p-1))). Smaller ones give false values.
int section_size(int degree, int arity);

/// The finite sections of S_b: with b shifted to support [0, N], (B_e)_{ij} = b_{e + p j - i} for i, j in R = {0, .., max(1, ceil(N/(p-1))) - 1},
/// e = 0 .. p-1. R is invariant: b_{e+pj-i} != 0 and i in R imply j in R, so that the joint spectral radius of the B_e is the
/// spectral radius lim ||S_b^l||^{1/l}.
class FiniteSections {
 public:
  /// With D the least common denominator. \pre b != 0, arity >= 2. \throws DomainError
  FiniteSections(const LaurentPolynomial& b, int arity);
  /// \param denominator D, any common denominator of b
  FiniteSections(const LaurentPolynomial& b, MultivariatePolynomial denominator, int arity);

  int arity() const { return arity_; }
  int size() const { return size_; }
  /// D, the common denominator of b: the sections are B_e = numerators(e) / D.
  const MultivariatePolynomial& denominator() const { return denominator_; }
  const PolynomialMatrix& numerators(int e) const { return numerators_[e]; }
  /// B_{w_1} ... B_{w_k} at a parameter value. \throws DomainError at a pole.
  RationalMatrix product(const std::vector<int>& word, std::span<const Rational> point) const;

 private:
  int arity_;
  int size_;
  MultivariatePolynomial denominator_;
  std::vector<PolynomialMatrix> numerators_;
};

}  // namespace limes
