#pragma once

#include "schemes/nonuniform/insertion_rule.hpp"

namespace limes {

/// The text of a rule in the form in which a certificate states it: `points` is 2n, every number is written out as a
/// quotient of polynomials in lowest terms with rational coefficients (there are no decimals, no defined numbers, no
/// divisors that cancel), and only segments and points are defined. It means the same rule: InsertionRule(normalized)
/// has the same stencils.
InsertionRuleText normalized_text(const InsertionRule& rule);

}  // namespace limes
