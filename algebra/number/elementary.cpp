#include "algebra/number/elementary.hpp"

#include "algebra/error.hpp"
#include "algebra/number/arb_conversion.hpp"
#include "algebra/number/flint_conversion.hpp"

namespace limes {
namespace {

Rational exact(const arf_t x) {
  FlintRational result;
  arf_get_fmpq(result.data, x);
  return from_fmpq(result.data);
}

/// The ends of a ball, rounded outward to `bits` bits so that they stay short.
Interval ends(const RealBall& ball, int bits) {
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  arb_get_lbound_arf(lower, ball.data, bits);
  arb_get_ubound_arf(upper, ball.data, bits);
  const bool finite = arf_is_finite(lower) && arf_is_finite(upper);
  const Interval result = finite ? Interval{exact(lower), exact(upper)} : Interval{};
  arf_clear(lower);
  arf_clear(upper);
  if (!finite) throw InternalError("an elementary function without finite enclosure");
  return result;
}

template <class Function>
Interval enclosure_of(const Rational& x, int bits, Function function) {
  clean_up_flint_at_thread_exit();
  if (bits < 16 || bits > 10000 || abs(x) > 1000) throw DomainError("enclosure: precision or argument out of range");
  const FlintRational argument(x);
  RealBall ball, value;
  // Near a zero of the cosine relative accuracy takes more bits; a rational is no zero.
  for (int precision = bits + 64;; precision *= 2) {
    arb_set_fmpq(ball.data, argument.data, precision);
    function(value.data, ball.data, precision);
    if (arb_rel_accuracy_bits(value.data) >= bits) return ends(value, bits + 8);
    if (precision > 1000000) throw InternalError("an elementary function without accurate enclosure");
  }
}

}  // namespace

Interval pi_enclosure(int bits) {
  return enclosure_of(Rational(0), bits,
                   [](arb_t value, const arb_t, slong precision) { arb_const_pi(value, precision); });
}

Interval cos_enclosure(const Rational& x, int bits) {
  if (x == 0) return Interval::point(1);
  return enclosure_of(x, bits, [](arb_t value, const arb_t y, slong precision) { arb_cos(value, y, precision); });
}

Interval cosh_enclosure(const Rational& x, int bits) {
  if (x == 0) return Interval::point(1);
  return enclosure_of(x, bits, [](arb_t value, const arb_t y, slong precision) { arb_cosh(value, y, precision); });
}

}  // namespace limes
