#pragma once

#include "algebra/expression/expression.hpp"
#include "schemes/uniform/mask.hpp"

namespace limes {

/// The mask of the binary interpolatory scheme whose new point between p_i and p_{i+1} is given by a rule over equally
/// spaced knots: the vocabulary of InsertionRule with all ratios 1 and as many points as the rule needs, for instance
///
/// - f(k,j), the polynomial of degree k that interpolates p_{i+j-floor(k/2)+s} at the knot i+j-floor(k/2)+s, s = 0..k;
/// - at(S, u), the value of S at i + u.
///
/// Example: "2*at(f(11,0),1/2) - at(f(9,0),1/2)" is the 12-point scheme of Karciauskas & Peters 2013, eq. (25).
///
/// \throws InputError with column: unknown function, wrong number or kind of arguments, a rule that is no point, ...
Mask mask_from_rule(const Expression& rule, const VariableNames& parameters);

}  // namespace limes
