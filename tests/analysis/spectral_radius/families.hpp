// Families of matrices that tests speak of.
#pragma once

#include "analysis/spectral_radius/matrix_family.hpp"

#include <vector>

namespace limes::test {

inline RationalMatrix matrix(const std::vector<std::vector<Rational>>& rows) {
  RationalMatrix result(int(rows.size()), int(rows.front().size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) result(int(i), int(j)) = rows[i][j];
  }
  return result;
}

/// The joint spectral radius is the golden ratio.
inline MatrixFamily golden() { return {matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})}; }

/// Gripenberg 1996: the joint spectral radius lies in [0.6596789, 0.6596924].
inline MatrixFamily gripenberg() {
  const Rational fifth(1, 5);
  return {matrix({{3 * fifth, 0}, {fifth, 3 * fifth}}), matrix({{3 * fifth, -3 * fifth}, {0, -fifth}})};
}

}  // namespace limes::test
