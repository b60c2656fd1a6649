// The only place where Rational meets MPFR. Included by sources, never by public headers.
#pragma once

#include "algebra/number/rational.hpp"

#include <mpfr.h>

namespace limes {

/// Rounds x to the precision of `out`; returns MPFR's ternary value (0: exact).
int to_mpfr(mpfr_t out, const Rational& x, mpfr_rnd_t rounding);

/// The exact value of a finite number. \throws DomainError for NaN and infinities.
Rational from_mpfr(const mpfr_t x);

}  // namespace limes
