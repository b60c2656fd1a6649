#pragma once

#include "schemes/uniform/mask.hpp"

#include <optional>

namespace limes {

/// Why the integer shifts of the limit function are stable.
enum class Stability {
  /// a_{p i} = delta_{i,0} up to a shift, identically in the parameters: the shifts are cardinal.
  interpolatory,
  /// Binary, without parameters, a(1) = 2: a(z) and a(-z) have no common zero in C \ {0}, and for no odd k >= 3 a primitive 2k-th
  /// root of unity is a zero of a; then the shifts are linearly independent. [Jia & Wang 1993]
  linear_independence,
};

/// Proves stability by one of the two criteria; nothing when neither applies (which does not disprove stability).
std::optional<Stability> prove_stability(const Mask& mask);

}  // namespace limes
