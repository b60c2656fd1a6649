#pragma once

#include "algebra/number/rational.hpp"

#include <optional>

namespace limes {

/// The sign of x^b - p^a, by powers with directed rounding: nothing when the two are equal to about `bits` bits and too long to be formed
/// exactly. \pre x > 0, b >= 0, p >= 2
std::optional<int> compare_powers(const Rational& x, const Integer& b, int p, const Integer& a, int bits = 512);

/// The greatest a / 10^digits <= log_p x, or the least one >= log_p x: x^(10^digits) is compared with powers of p, no logarithm decides. When
/// x^b = p^a for small a, b, log_p x itself. \pre x > 0, p >= 2, 0 <= digits <= 100
Rational logarithm_below(const Rational& x, int p, int digits);
Rational logarithm_above(const Rational& x, int p, int digits);

}  // namespace limes
