#pragma once

#include "algebra/matrix/rational_matrix.hpp"

#include <vector>

namespace limes {

/// Finitely many square matrices B_0 .. B_{m-1} of one size over Q. Their joint spectral radius is
/// JSR = lim_k max over words of length k of ||B_{w_1} ... B_{w_k}||^{1/k}; a word is a list of indices.
using MatrixFamily = std::vector<RationalMatrix>;
using Word = std::vector<int>;

/// The common size. \throws DomainError when the family is empty or its matrices are not square of one size >= 1.
int family_size(const MatrixFamily& family);
/// B_{w_1} ... B_{w_k}; the identity for the empty word. \pre the letters are indices of the family
RationalMatrix product(const MatrixFamily& family, const Word& word);
/// c B_0 .. c B_{m-1}.
MatrixFamily scaled(const MatrixFamily& family, const Rational& c);
/// The transposed matrices, which have the same joint spectral radius.
MatrixFamily transposed(const MatrixFamily& family);

}  // namespace limes
