// Exact vectors of polytope norms. Included by sources only.
#pragma once

#include "analysis/spectral_radius/polytope_norm.hpp"

namespace limes {

using RationalVector = std::vector<Rational>;

/// The nearest multiple of 2^-bits.
Rational round_to_bits(const Rational& x, int bits);
/// An upper bound of sqrt(x^2 + y^2), equal to it when y = 0.
Rational modulus_bound(const Rational& x, const Rational& y);
/// B x for a real vector x, or for the real and the imaginary half of a complex one.
RationalVector image_of(const RationalMatrix& b, const RationalVector& x);
/// length e_k in R^n.
RationalVector unit_vector(int n, int k, const Rational& length);
/// x - sum of terms; a complex vector when a term or a vector is complex.
RationalVector remainder(RationalVector x, const SparseCombination& combination, const std::vector<RationalVector>& vectors);
/// sum |c_j| + ||x - sum of terms||_1 / unit.
Rational combination_norm(const RationalVector& x, const SparseCombination& combination, const std::vector<RationalVector>& vectors,
                          const Rational& unit);

}  // namespace limes
