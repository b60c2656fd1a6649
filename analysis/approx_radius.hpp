#pragma once

#include "algebra/matrix/rational_matrix.hpp"

namespace limes {

/// Floating hints, good to about 12 digits when the greatest eigenvalue (root) is not multiple. They tell a search where to look.

/// The spectral radius of a square matrix.
double approx_spectral_radius(const RationalMatrix& a);
/// The greatest modulus of a root; 0 for constants. \pre a != 0
double approx_greatest_root(const Polynomial& a);

}  // namespace limes
