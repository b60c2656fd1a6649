#pragma once

#include "analysis/spectral_radius/matrix_family.hpp"

#include <optional>

namespace limes {

/// A basis of a proper subspace W, 0 < dim W < n, with B_e W in W for all e: the columns of the result, in reduced column
/// echelon form. Found by spinning vectors of kernels of small algebra elements, as in Norton's test [Holt, Eick & O'Brien 2005,
/// section 7.4]; nothing means that none was found, which is a proof of irreducibility over Q only where Norton's test applies.
std::optional<RationalMatrix> find_invariant_subspace(const MatrixFamily& family);

/// T^{-1} B_e T, block upper triangular with square diagonal blocks of the given sizes, for all e. The joint spectral radius of
/// the family is the greatest of those of the families of diagonal blocks.
struct BlockTriangularForm {
  RationalMatrix basis;         // T
  RationalMatrix inverse;       // T^{-1}
  std::vector<int> sizes;       // of the diagonal blocks, first to last
  MatrixFamily matrices;        // T^{-1} B_e T

  /// The family of block number k on the diagonal.
  MatrixFamily diagonal_block(std::size_t k) const;
};

/// Splits as long as find_invariant_subspace finds something; a family for which it finds nothing has one block and T = I.
BlockTriangularForm block_triangular_form(const MatrixFamily& family);

}  // namespace limes
