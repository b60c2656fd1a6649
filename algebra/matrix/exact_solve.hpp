#pragma once

#include "algebra/matrix/rational_matrix.hpp"

#include <optional>

namespace limes {

/// The matrix x with a x = b, exactly; nothing when a is singular. \pre a is square
/// \throws DomainError when the shapes do not match.
std::optional<RationalMatrix> exact_solve(const RationalMatrix& a, const RationalMatrix& b);

}  // namespace limes
