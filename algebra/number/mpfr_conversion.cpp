#include "algebra/number/mpfr_conversion.hpp"

#include "algebra/error.hpp"

namespace limes {

int to_mpfr(mpfr_t out, const Rational& x, mpfr_rnd_t rounding) { return mpfr_set_q(out, x.backend().data(), rounding); }

Rational from_mpfr(const mpfr_t x) {
  if (!mpfr_number_p(x)) throw DomainError("from_mpfr: not a finite number");
  Rational result;
  mpfr_get_q(result.backend().data(), x);
  return result;
}

}  // namespace limes
