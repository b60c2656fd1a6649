#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/laurent_polynomial.hpp"
#include "analysis/spectral_radius/matrix_family.hpp"

#include <optional>

namespace limes {

/// Rational matrices whose convex hulls hold the finite sections of S_b at every point of the closed box: with b = B / D and the
/// Bernstein coefficients B_I, D_I in one multidegree n, B(x) / D(x) = sum_I lambda_I B_I / D_I, lambda_I = D_I beta_I(x) / D(x) >= 0, of
/// sum 1. So a norm in which the sections M_{I,e} of all B_I / D_I are contractions proves that S_b contracts on the box. Element
/// I p + e is M_{I,e}, e = 0 .. p-1, I in Bernstein order (the last axis fastest). Without parameters: the sections themselves.
/// Nothing when the D_I have not all one sign.
/// \pre every parameter has an interval in `box`; b != 0
std::optional<MatrixFamily> section_hull(const LaurentPolynomial& b, const MultivariatePolynomial& denominator, int arity, const Box& box);

}  // namespace limes
