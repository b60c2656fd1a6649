// The FLINT inside of Polynomial. Included by sources only.
#pragma once

#include "algebra/number/flint_conversion.hpp"
#include "algebra/polynomial/polynomial.hpp"

#include <flint/fmpq_poly.h>

namespace limes {

struct Polynomial::Impl {
  Impl() {
    clean_up_flint_at_thread_exit();
    fmpq_poly_init(poly);
  }
  Impl(const Impl& other) : Impl() { fmpq_poly_set(poly, other.poly); }
  Impl& operator=(const Impl& other) {
    fmpq_poly_set(poly, other.poly);
    return *this;
  }
  ~Impl() { fmpq_poly_clear(poly); }
  fmpq_poly_t poly;
};

}  // namespace limes
