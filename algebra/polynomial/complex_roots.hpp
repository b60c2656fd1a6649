#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/polynomial.hpp"

#include <vector>

namespace limes {

/// A rectangle that contains exactly one distinct root of a polynomial, and an enclosure of that root's modulus; intervals are
/// closed. A real root has im = {0}, and is rational and exact when re is a point.
struct ComplexRoot {
  Interval re, im;
  Interval modulus;
  int multiplicity = 1;
  bool is_real() const { return im.is_point() && im.lower == 0; }
};

/// All distinct roots with their multiplicities, by falling modulus; of moduli that are equal within the enclosures, real ones
/// first, then by falling real and imaginary part. Enclosures are about 2^-bits wide relative to the roots. Rational roots of
/// denominator below 2^(bits/2) are exact. Rigorous (Arb); pairs of conjugate roots have conjugate enclosures.
/// \pre a != 0, 16 <= bits <= 4096
std::vector<ComplexRoot> enclose_complex_roots(const Polynomial& a, int bits = 64);

}  // namespace limes
