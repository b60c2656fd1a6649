#include "algebra/number/arb_conversion.hpp"

#include "algebra/error.hpp"
#include "algebra/number/flint_conversion.hpp"

namespace limes {
namespace {

Rational end_of(const arb_t x, void (*bound)(arf_t, const arb_t, slong)) {
  if (!arb_is_finite(x)) throw DomainError("the ends of a ball that is not finite");
  arf_t end;
  arf_init(end);
  bound(end, x, ARF_PREC_EXACT);
  FlintRational value;
  arf_get_fmpq(value.data, end);
  arf_clear(end);
  return from_fmpq(value.data);
}

}  // namespace

Rational lower_end(const arb_t x) { return end_of(x, arb_get_lbound_arf); }
Rational upper_end(const arb_t x) { return end_of(x, arb_get_ubound_arf); }
Interval enclosure(const arb_t x) { return {lower_end(x), upper_end(x)}; }

}  // namespace limes
