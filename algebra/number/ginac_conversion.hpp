// The only place where Rational meets CLN and GiNaC. Included by sources, never by public headers.
#pragma once

#include "algebra/number/rational.hpp"

#include <cln/rational.h>
#include <ginac/ginac.h>

namespace limes {

cln::cl_RA to_cln(const Rational& x);
Rational from_cln(const cln::cl_RA& x);
GiNaC::numeric to_ginac(const Rational& x);

}  // namespace limes
