#pragma once

#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "analysis/uniform/finite_sections.hpp"
#include "schemes/scheme.hpp"

#include <optional>

namespace limes {

/// Floating hints where a scheme is C^m: they choose which proofs are tried and where boxes are cut, and decide nothing.
class SmoothnessHint {
 public:
  SmoothnessHint(const Scheme& scheme, int m, const Stop& stop);

  /// Below 1 where the scheme seems to be C^m, above where not, and 1 (up to rounding) between: the growth of the differences along
  /// the worst short word of sections, for a non-uniform scheme also the greatest eigenvalue at an isolated knot ratio (or in the limit
  /// of small ones) that should be below 2^{-m}, times 2^m; infinite where a factor of the symbol is missing.
  double approx_growth(const std::vector<Rational>& point) const;

  /// A parameter value between two points at which approx_growth() crosses 1, on the line between them, to about 1e-14 of it: the
  /// fraction of the way. \pre the hints at the two points lie on different sides of 1
  double approx_crossing(const std::vector<Rational>& from, const std::vector<Rational>& to) const;

  /// The values of the one free parameter in the region at which a factor of the symbol appears that is missing elsewhere.
  std::vector<Rational> isolated_values(const Box& region) const;

 private:
  using Words = std::vector<std::vector<int>>;
  Words worst_words(const std::vector<Rational>& point) const;
  double growth_along(const Words& words, const std::vector<Rational>& point) const;
  double growth_at_ratios(const std::vector<Rational>& point) const;

  Mask mask_;
  int m_;
  const Stop& stop_;
  std::optional<FiniteSections> sections_;
  std::optional<SplitCharacteristicPolynomial> split_;
  std::vector<LambdaPolynomial> limits_at_zero_;
};

}  // namespace limes
