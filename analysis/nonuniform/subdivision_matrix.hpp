#pragma once

#include "algebra/matrix/rational_matrix.hpp"
#include "algebra/polynomial/rational_function.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"

#include <span>
#include <vector>

namespace limes {

/// The (4n-1) x (4n-1) matrix L of one refinement step of a 2n-point scheme about an isolated knot ratio gamma: knots
/// t_j = j for j <= 0 and t_j = gamma j for j >= 0, |j| <= 2n-1. Row and column j + 2n - 1 (from 0) belong to t_j in
/// the paper's order: left to right, the extraordinary knot in the middle. [Karciauskas & Peters 2013, eq. (14)]
///
/// Row 2i (new point on an old one) is a unit vector; row of an odd index 2i+1 is the rule's stencil on the knots
/// t_{i-n+1} .. t_{i+n}. Rows sum to 1 when the rule reproduces constants. Variables: the scheme's parameters, then
/// gamma.
class SubdivisionMatrix {
 public:
  explicit SubdivisionMatrix(const InsertionRule& rule);
  /// From the stencils E_0, E_1, .., E_{2n-2} of eq. (14): E_0 for equal intervals, E_k for ratios 1 but number 2n-1-k
  /// (from 1, left to right), which is gamma. \throws DomainError when they are not 2n-1 stencils of 2n functions
  static SubdivisionMatrix from_stencils(std::vector<std::vector<RationalFunction>> stencils);

  /// 2n
  int points() const { return points_; }
  /// 4n - 1
  int size() const { return 2 * points_ - 1; }
  /// Number of parameters + 1.
  int variables() const { return variables_; }
  /// The index of gamma among the variables: the last.
  int gamma() const { return variables_ - 1; }
  /// The entry in the row of t_row and the column of t_column. \pre |row|, |column| <= 2n-1
  RationalFunction entry(int row, int column) const;
  /// A common denominator of the row of t_row, leading coefficient 1, and the entry times it.
  MultivariatePolynomial row_denominator(int row) const;
  MultivariatePolynomial row_numerator(int row, int column) const;
  /// L at a point. \throws DomainError at a pole.
  RationalMatrix at(std::span<const Rational> point) const;
  /// t_j as a polynomial in gamma.
  MultivariatePolynomial knot(int j) const;
  /// The entries of L v_k - 2^{-k} v_k that are not zero, times their rows' denominators, v_k being the k-th powers of the knots.
  std::vector<MultivariatePolynomial> power_defects(int k) const;
  /// The greatest m <= limit with L v_k = 2^{-k} v_k for k = 0..m, where v_k are the k-th powers of the knots, as
  /// identities in all variables; -1 when constants are not reproduced.
  int reproduced_degree(int limit) const;

 private:
  SubdivisionMatrix() = default;
  struct Stencil {
    MultivariatePolynomial denominator;
    std::vector<MultivariatePolynomial> numerators;
  };
  /// The stencil of an odd row, and the index of the knot of its first weight.
  const Stencil& stencil(int row) const;
  int first_knot(int row) const;

  int points_ = 0;
  int variables_ = 0;
  std::vector<Stencil> stencils_;  // E_0 .. E_{2n-2}
};

}  // namespace limes
