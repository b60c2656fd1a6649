#pragma once

#include "algebra/number/rational.hpp"

#include <string_view>

namespace limes {

/// Reads "-12", "3/4", "0.0141", ".5", "1e-3", "2.5e+2" exactly (a decimal is the rational that it spells; 0.1 = 1/10).
/// Surrounding blanks are allowed, nothing else. One sign at most, none in the denominator; a fraction has integer parts.
///
/// \throws InputError with the column of the first wrong character; "division by zero" for q = 0.
/// \throws LimitError above 10000 digits or a decimal exponent above 10000 in modulus.
Rational read_rational(std::string_view text);

}  // namespace limes
