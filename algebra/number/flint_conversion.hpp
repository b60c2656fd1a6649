// The only place where Rational meets FLINT. Included by sources, never by public headers.
#pragma once

#include "algebra/number/rational.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz.h>

namespace limes {

void to_fmpq(fmpq_t out, const Rational& x);
void to_fmpz(fmpz_t out, const Integer& x);
Rational from_fmpq(const fmpq_t x);
Integer from_fmpz(const fmpz_t x);

}  // namespace limes
