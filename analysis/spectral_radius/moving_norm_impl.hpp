// The norms by which moving polytopes are found and proved. Included by sources only.
#pragma once

#include "analysis/spectral_radius/exact_vectors_impl.hpp"
#include "analysis/spectral_radius/moving_polytope.hpp"

namespace limes {

/// The Bernstein coefficients, in degree 3, of the quadratic with Bernstein coefficients s.
template <class T>
std::array<T, 4> elevated(const std::array<T, 3>& s) {
  return {s[0], (s[0] + 2 * s[1]) / 3, (2 * s[1] + s[2]) / 3, s[2]};
}

/// The greatest Bernstein coefficient of sum |c_j| + ||r||_1 / unit for one image.
Rational exact_moving_norm(const MovingCombination& combination, const std::array<const RationalMatrix*, 2>& b,
                           const std::array<RationalVector, 2>& x, const std::vector<std::array<RationalVector, 2>>& vectors,
                           const Rational& unit);

}  // namespace limes
