// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/enclosure.hpp"

#include <cstdint>
#include <functional>

namespace limes::checker {

/// a_{first + k} = numerators[k] / denominator.
struct IntegerMask {
  int first = 0;
  std::vector<mpz_class> numerators;
  mpz_class denominator = 1;
  int last() const { return first + static_cast<int>(numerators.size()) - 1; }
};

/// A bound of sup_x sum_i |phi(x - i)| for the limits phi(. - i) of unit data, which shows that the scheme converges, too.
/// \throws Rejected at "map" when no power up to the 10th of the difference scheme contracts
mpq_class lebesgue_bound(const IntegerMask& mask, Budget& budget);

/// The closed interval [lower, upper] 2^-40.
struct Range {
  std::int64_t lower = 0, upper = 0;
};

/// Ranges at the places (a, b), first_a <= a < first_a + columns, likewise b.
struct Grid {
  int first_a = 0, first_b = 0, columns = 0, rows = 0;
  std::vector<Range> data;

  Grid() = default;
  Grid(int from_a, int to_a, int from_b, int to_b)
      : first_a(from_a), first_b(from_b), columns(to_a - from_a + 1), rows(to_b - from_b + 1),
        data(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
  int last_a() const { return first_a + columns - 1; }
  int last_b() const { return first_b + rows - 1; }
  Range& at(int a, int b) { return data[static_cast<std::size_t>((a - first_a) * rows + b - first_b)]; }
  const Range& at(int a, int b) const { return data[static_cast<std::size_t>((a - first_a) * rows + b - first_b)]; }
};

/// Whether x y > z w for all numbers of these ranges.
bool product_exceeds(const Range& x, const Range& y, const Range& z, const Range& w);

/// The tensor product of a symmetric curve scheme, proved to be C^1, on the grid of a half-plane a >= 0.
class CurveLimits {
 public:
  /// \param mask a_i, i from -last (dual: 1 - last) on  \throws Rejected at "map", "limits"
  CurveLimits(const std::vector<mpq_class>& mask, bool dual, Budget& budget);

  /// From a = reach() on the limit depends on the columns a >= 0 only, and so does every step of its subdivision.
  int reach() const { return last_ - 1; }
  /// The greatest coordinate of data for the limit on the cells a, b < 2 reach(); the least b is 1 - last.
  int outermost() const { return 2 * reach() - 1 + last_ - (dual_ ? 1 : 0); }
  /// For every cell [a, a+1] x [b, b+1], 0 <= b <= a, of 2^-level times the grid in reach <= a 2^-level < 2 reach: what contains the limit of
  /// the data or, up to a positive factor, its derivative by a or b.
  enum class Part { value, by_a, by_b };
  Grid on_annulus(const std::function<Enclosure(int, int)>& data_or_differences, Part part, int level) const;
  /// An estimate for on_annulus() in nanoseconds.
  double cost(int level) const;

 private:
  struct Direction;
  Direction direction(bool derived) const;
  bool dual_;
  int last_;
  IntegerMask mask_, derived_;  ///< the latter for the differences p_{j+1} - p_j, times 2
  mpq_class mask_bound_, derived_bound_;
};

}  // namespace limes::checker
