#pragma once

#include "algebra/expression/expression.hpp"
#include "schemes/uniform/mask.hpp"

namespace limes {

/// The mask of the binary interpolatory scheme whose new point between p_i and p_{i+1} is given by a rule over equally spaced
/// knots. A rule is a linear combination, with coefficients rational in the parameters, of values at(f(k,j), u):
///
/// - f(k,j) is the polynomial of degree k that interpolates p_{i+j-floor(k/2)+s} at the knot i+j-floor(k/2)+s, s = 0..k;
/// - at(g, u) is the value of g at i + u.
///
/// Example: "2*at(f(11,0),1/2) - at(f(9,0),1/2)" is the 12-point scheme of Karciauskas & Peters 2013, eq. (25).
///
/// \pre 0 <= k <= 63, |j| <= 64, u rational. \throws InputError with column: unknown function, wrong number or kind of
/// arguments, a term that is no value of an interpolant, a division by an interpolant's value.
Mask mask_from_rule(const Expression& rule, const VariableNames& parameters);

}  // namespace limes
