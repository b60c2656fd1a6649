#pragma once

#include "algebra/polynomial/polynomial.hpp"

#include <vector>

namespace limes {

/// A closed rational interval that contains exactly one real root of a square-free polynomial; lower == upper when the root is
/// that rational.
struct RootInterval {
  Rational lower;
  Rational upper;
  int multiplicity = 1;
};

/// Number of distinct real roots in the half-open interval (lower, upper], by Sturm's theorem, exactly. \pre a != 0, lower <= upper
int count_real_roots(const Polynomial& a, const Rational& lower, const Rational& upper);
/// Number of distinct real roots. \pre a != 0
int count_real_roots(const Polynomial& a);
/// All distinct real roots, ascending, in pairwise disjoint intervals of width <= `width`, with their multiplicities.
/// \pre a != 0, width > 0
std::vector<RootInterval> isolate_real_roots(const Polynomial& a, const Rational& width);

}  // namespace limes
