#pragma once

#include "schemes/surface/ring_rule.hpp"

#include <string>
#include <string_view>

namespace limes {

/// A linear combination of at(a,b), at(a,b,sector), mean(a,b) and harmonic(k,a,b), the terms of a ring rule, with coefficients that are
/// expressions in the level parameter and n: "1/4*at(0,0) + 3/4*mean(0,0) + 1/2*harmonic(1,0,0)". One term for each combination, in the order of
/// the text. \throws InputError with the column
std::vector<RingTerm> read_ring_expression(std::string_view text, bool dual, const std::string& level_parameter);
/// A point "1,0" of sector 0. \throws InputError
RingPoint read_ring_point(std::string_view text, bool dual);

/// Readable by read_ring_expression.
std::string to_string(const std::vector<RingTerm>& terms, const std::string& level_parameter);
std::string to_string(RingPoint point);

}  // namespace limes
