// The only place where Rational meets Arb. Included by sources, never by public headers.
#pragma once

#include "algebra/number/rational.hpp"

#include <arb.h>

namespace limes {

/// The exact ends of a finite ball. \throws DomainError for a ball that is not finite.
Rational lower_end(const arb_t x);
Rational upper_end(const arb_t x);

}  // namespace limes
