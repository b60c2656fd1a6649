#include "algebra/number/flint_conversion.hpp"

namespace limes {

void to_fmpq(fmpq_t out, const Rational& x) { fmpq_set_mpq(out, x.backend().data()); }

void to_fmpz(fmpz_t out, const Integer& x) { fmpz_set_mpz(out, x.backend().data()); }

Rational from_fmpq(const fmpq_t x) {
  Rational result;
  fmpq_get_mpq(result.backend().data(), x);
  return result;
}

Integer from_fmpz(const fmpz_t x) {
  Integer result;
  fmpz_get_mpz(result.backend().data(), x);
  return result;
}

void clean_up_flint_at_thread_exit() {
  struct Cleaner {
    ~Cleaner() { flint_cleanup(); }
  };
  static thread_local const Cleaner cleaner;
  static_cast<void>(cleaner);
}

}  // namespace limes
