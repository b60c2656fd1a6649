#pragma once

#include "algebra/polynomial/polynomial.hpp"

#include <utility>
#include <vector>

namespace limes {

/// The minimal polynomial over Q of cos(2 pi j/n), monic. \pre n >= 1
Polynomial minimal_polynomial_of_cosine(int n, int j);

/// A polynomial sum_k p[k] x^k over the field Q(c) = Q[c]/(minimal), minimal irreducible; coefficients are polynomials in c.
using CosinePolynomial = std::vector<Polynomial>;

CosinePolynomial multiply(const CosinePolynomial& a, const CosinePolynomial& b, const Polynomial& minimal);
/// {(g_i, i)}: pairwise coprime monic square-free g_i of positive degree, a = constant * prod g_i^i (Yun). \pre a != 0
std::vector<std::pair<CosinePolynomial, int>> square_free_factorisation(const CosinePolynomial& a, const Polynomial& minimal);

}  // namespace limes
