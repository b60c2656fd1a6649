// SPDX-License-Identifier: MIT
//
// Linear maps between Bezier coefficients that do not look at the knots, row by row.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace limes::checker {

using Vector = std::vector<mpq_class>;
using Rows = std::vector<Vector>;

mpq_class binomial(int n, int k);
mpq_class power(const mpq_class& x, int n);

/// The coefficients 0..r in degree `to` of the r-jet at 0 of a segment (Karciauskas & Peters 2013, eq. 7); degree
/// raising for r = to.
Rows jet_rows(int from, int to, int r);

/// The C^r segment in `pieces` equal pieces of degree r+1 with the r-jets of a segment S; no rows when there is none.
Rows split_rows(int degree, int r, int pieces);

}  // namespace limes::checker
