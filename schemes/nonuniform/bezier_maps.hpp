// Linear maps between Bezier coefficients with rational entries: all of the vocabulary that does not look at the knots.
#pragma once

#include "algebra/matrix/rational_matrix.hpp"

namespace limes {

/// n! / (k! (n-k)!), 0 unless 0 <= k <= n.
Rational binomial(int n, int k);

/// The weights of the coefficients 0..degree in the value at u.
std::vector<Rational> bernstein_values(int degree, const Rational& u);

/// Degree raising, (to+1) x (from+1). \pre from <= to
RationalMatrix degree_raising(int from, int to);

/// The r-jet at 0 of a segment of degree `from` as coefficients 0..r of degree `to`: (r+1) x (from+1)
/// [Karciauskas & Peters 2013, eq. (7)]. At 1: both ways from the right. \pre r <= to
RationalMatrix jet_in_degree(int from, int to, int r);

/// The coefficients, piece by piece, of the C^r segment that consists of `pieces` polynomials of degree r+1 over equal
/// parts and has the r-jets at 0 and 1 of a segment of the given degree: pieces*(r+2) x (degree+1). No row when there
/// is none, which cannot happen for pieces = r+1. \pre 0 <= r, 1 <= pieces <= r+1
RationalMatrix split_in_pieces(int degree, int r, int pieces);

}  // namespace limes
