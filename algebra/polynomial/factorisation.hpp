#pragma once

#include "algebra/polynomial/polynomial.hpp"

#include <utility>
#include <vector>

namespace limes {

/// {(f_i, m_i)}: distinct monic polynomials, irreducible over Q, with a = c prod f_i^{m_i}; by rising degree. \pre a != 0
std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& a);

}  // namespace limes
