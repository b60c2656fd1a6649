#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/laurent_polynomial.hpp"
#include "algebra/stop.hpp"

#include <optional>
#include <vector>

namespace limes {

/// What a contractivity computation may cost.
struct ContractivityLimits {
  /// Highest level l that is tried.
  int max_level = 18;
  /// Memory for one level's coefficients; limes-check, which stores them less densely, refuses much more.
  double max_bytes = 1e8;
};

/// ||S_b^l||_inf = max_{0 <= i < p^l} sum_j |b^{[l]}_{i - p^l j}|, exactly.
/// \param b a symbol without parameters. \pre level >= 1, arity >= 2
/// \throws LimitError when the computation would exceed `max_bytes`; Interrupted.
Rational exact_contractivity_norm(const LaurentPolynomial& b, int arity, int level, const Stop& stop = {},
                                  double max_bytes = 4e9);

/// Floating hints for ||S_b^l||_inf at a parameter value, l = 1 .. max_level or fewer when that gets long; element l - 1 belongs
/// to level l. Ends with the first value below `enough`.
std::vector<double> approx_contractivity_norms(const LaurentPolynomial& b, int arity, std::span<const Rational> point,
                                               int max_level, double enough);

/// The symbol b on a box, prepared for bounds of many levels: coefficients in Bernstein form over a common denominator.
class ContractivityBound {
 public:
  /// \param denominator D, a common denominator of the coefficients of b
  /// \pre every parameter has an interval in `box`
  ContractivityBound(const LaurentPolynomial& b, const MultivariatePolynomial& denominator, int arity, const Box& box);

  /// Whether ||S_b^level|| < 1 is proved at every point of the box: with b = B / D, the polynomial D^l - sum_j |B^{[l]}_j| has, for each residue, only
  /// positive Bernstein coefficients, where |B_j| is bounded by its Bernstein coefficients' moduli (exact for B_j of constant sign), after dividing out
  /// powers of the distance to *open* ends of the box. False is no statement.
  /// \throws LimitError when a level needs more than limits.max_bytes; Interrupted.
  bool proves_contraction(int level, const ContractivityLimits& limits, const Stop& stop) const;

 private:
  int arity_;
  std::vector<int> degrees_;                         // of the parameters that are no points
  std::vector<bool> lower_open_;
  std::vector<bool> upper_open_;
  bool denominator_is_signed_ = false;
  std::vector<Integer> denominator_;                 // scaled Bernstein coefficients, >= 0
  std::vector<std::vector<Integer>> numerators_;     // of B_0 .. B_N, same scale
};

}  // namespace limes
