#pragma once

#include "algebra/number/rational.hpp"

#include <vector>

namespace limes {

/// The four filters of a banded binary multiresolution [MoltajiRunionsSamavati2017, section 5.2], of one even length K:
///
///     P, Q: column j is p, q, beginning at row 2j;      A, B: row i is a, b, beginning at column 2i + shift.
///
/// Coarse points and details of fine points f are c = A f and d = B f, and f = P c + Q d. p is the mask of the scheme,
/// zeros appended: one when its length is odd, then `extension` of them.
struct FilterBank {
  std::vector<Rational> p, a, b, q;
  /// Even.
  int shift = 0;
  /// l, even.
  int extension = 0;

  int length() const { return static_cast<int>(p.size()); }
};

/// b_i = (-1)^i p_{K+1-i} and a_i = (-1)^{i+1} q_{K+1-i}, i = 1..K (eqs. 35 and 44): then BP = 0 and AQ = 0, and AP = I
/// is the same as BQ = I. \pre p and q have one even length
FilterBank alternated_bank(std::vector<Rational> p, std::vector<Rational> q, int shift, int extension);

/// sum_i x_{i + shift + 2 lag} y_i, entries outside being zero: the entry of A P (x = p, y = a) in row r, column r - lag.
Rational correlation(const std::vector<Rational>& x, const std::vector<Rational>& y, int shift, int lag);

/// The greatest |entry| of AP - I, AQ, BP and BQ - I, on the integers. It is 0 exactly when the four identities of eq. 34
/// hold as identities of Laurent polynomials: then they, and PA + QB = I, hold for circulant matrices of every size.
Rational exact_biorthogonality_defect(const FilterBank& bank);

/// ||P^T q||_2^2, the square of the orthogonality error: the soft constraints of eq. 41.
Rational exact_squared_orthogonality_error(const FilterBank& bank);

/// sum_i b_i, which is p(-1) or -p(-1): every entry of B 1. When it is not 0 (the scheme violates the sum rules), details
/// change with a translation of the data.
Rational exact_detail_of_constants(const FilterBank& bank);

}  // namespace limes
