// Hexadecimal text is exact and linear in the size, unlike decimal text.
#include "algebra/number/ginac_conversion.hpp"

#include <cln/integer.h>
#include <cln/integer_io.h>

#include <sstream>
#include <vector>

namespace limes {

namespace {

cln::cl_I to_cln_integer(const Integer& x) {
  if (mpz_fits_slong_p(x.backend().data())) return cln::cl_I(mpz_get_si(x.backend().data()));
  // "#x" is CLN's prefix for base 16.
  std::vector<char> digits(mpz_sizeinbase(x.backend().data(), 16) + 2);
  mpz_get_str(digits.data(), 16, x.backend().data());
  const bool negative = digits.front() == '-';
  const cln::cl_I modulus((std::string("#x") + (digits.data() + negative)).c_str());
  return negative ? -modulus : modulus;
}

Integer from_cln_integer(const cln::cl_I& x) {
  std::ostringstream digits;
  cln::fprinthexadecimal(digits, x);
  Integer result;
  mpz_set_str(result.backend().data(), digits.str().c_str(), 16);
  return result;
}

}  // namespace

cln::cl_RA to_cln(const Rational& x) { return to_cln_integer(numerator(x)) / to_cln_integer(denominator(x)); }

Rational from_cln(const cln::cl_RA& x) {
  return Rational(from_cln_integer(cln::numerator(x)), from_cln_integer(cln::denominator(x)));
}

GiNaC::numeric to_ginac(const Rational& x) { return GiNaC::numeric(to_cln(x)); }

}  // namespace limes
