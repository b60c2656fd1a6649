#pragma once

#include "schemes/unity/refinement_equation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes {

/// What a mask must satisfy exactly.
struct MaskConstraints {
  /// sum_k c_k = 2 and sum_k (-1)^k k^j c_k = 0 for j < sum_rules: (1+z)^sum_rules divides the symbol; 0: nothing, not even the sum.
  int sum_rules = 0;
  /// c = 0 at the even shifts but the shift 0 (the centre stays free). [MoltajiRunionsSamavati2016, section 6.4]
  bool interpolation = false;
  /// c_k = c_{count-1-k}.
  bool symmetry = false;
};

/// Reads 'sum-rules=4', 'interpolation' or 'symmetry' into the constraints. \throws InputError
void read_constraint(const std::string& text, MaskConstraints& constraints);

/// All solutions c = particular + basis y of linear equations, y free: y_k = c_{free[k]}.
struct AffineSolutions {
  std::vector<Rational> particular;
  RationalMatrix basis;
  std::vector<int> free;
};

/// \throws InputError when the constraints contradict each other or do not fit the shifts
AffineSolutions solve_constraints(const MaskConstraints& constraints, const RefinementEquation& equation);

struct DerivedMask {
  RefinementEquation equation;
  LeastSquares system;
  AffineSolutions solutions;
  /// c_k belongs to w(2u - s_k); satisfies the constraints exactly.
  std::vector<Rational> mask;
  /// Whether `mask` is the exact minimiser of the system, not rounded.
  bool exact = false;
  /// E = ||w - sum c_k w(2 . - s_k)|| / ||w|| of `mask`, and of the unrounded minimiser. [MoltajiRunionsSamavati2016, eq. 22]
  double error = 0;
  double least_error = 0;
  /// sigma_max / sigma_min of the dilates on the constraints' null space, and the numerical rank there: of `unknowns`.
  double condition = 1;
  int rank = 0;
  int unknowns = 0;

  /// E of any mask for the same equation, from the exact Gram matrix.
  double error_of(const std::vector<Rational>& coefficients) const;
};

/// Minimises ||w - sum_k c_k w(2 . - s_k)|| under the constraints by the null-space method, exactly over Q on the system's Gram matrix, then rounds
/// the free coefficients to `decimals` decimals (nothing: keeps an exact minimiser, else 15 or what the precision allows) and computes the others from the
/// constraints. An equation that holds (E < 1e-10) gets the simplest rationals near, when they satisfy it as well.
/// \throws InputError for contradicting constraints or a rank-deficient system
DerivedMask derive_mask(const RefinementEquation& equation, LeastSquares system, const MaskConstraints& constraints,
                        const std::optional<int>& decimals = std::nullopt);

/// Each coefficient rounded to the nearest float32, as the tables of Moltaji et al. 2016 were.
std::vector<Rational> rounded_to_float(const std::vector<Rational>& mask);
/// Each coefficient rounded to `digits` significant decimal digits.
std::vector<Rational> rounded_to_digits(const std::vector<Rational>& mask, int digits);

}  // namespace limes
