#pragma once

#include "algebra/polynomial/rational_function.hpp"

#include <span>
#include <string>
#include <vector>

namespace limes {

/// The 2n - 2 ratios of adjacent knot intervals on which the rule of a 2n-point scheme depends, beta_{i-n+2} ..
/// beta_{i+n-1}, from left to right: beta_k = (t_{k+1} - t_k) / (t_k - t_{k-1}), k runs over the inner ones of the
/// knots t_{i-n+1} .. t_{i+n}. All of them are functions in one set of variables. Their names in scheme files are b1 ..
/// b{2n-2}.
class KnotRatios {
 public:
  /// \pre an even number of ratios, all in the same number of variables
  explicit KnotRatios(std::vector<RationalFunction> ratios) : ratios_(std::move(ratios)) {}
  /// All ratios 1. \pre points even, >= 2
  static KnotRatios uniform(int points, int variables);
  /// All ratios 1 but number `position` (0-based from the left), which is gamma. E_k of Karciauskas & Peters 2013, eq.
  /// (14), has position 2n - 2 - k.
  static KnotRatios isolated(int points, int position, const RationalFunction& gamma);
  /// Ratio number k is the variable first + k. \pre first + points - 2 <= variables
  static KnotRatios independent(int points, int variables, int first);

  int points() const { return static_cast<int>(ratios_.size()) + 2; }
  const RationalFunction& operator[](int k) const { return ratios_[static_cast<std::size_t>(k)]; }
  /// The knots with these ratios, t_{i-n+1} = 0 and the first interval 1: polynomials when the ratios are.
  std::vector<RationalFunction> knots(int variables) const;

 private:
  std::vector<RationalFunction> ratios_;
};

/// "b1", ..., "b{2n-2}".
VariableNames ratio_names(int points);

}  // namespace limes
