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

/// FLINT pools its big integers per thread. Called where FLINT objects are made, this frees the pool when the thread ends;
/// integers that live on in other threads stay valid.
void clean_up_flint_at_thread_exit();

/// An fmpq_t or fmpz_t that clears itself.
struct FlintRational {
  FlintRational() { fmpq_init(data); }
  explicit FlintRational(const Rational& x) : FlintRational() { to_fmpq(data, x); }
  ~FlintRational() { fmpq_clear(data); }
  FlintRational(const FlintRational&) = delete;
  FlintRational& operator=(const FlintRational&) = delete;
  fmpq_t data;
};

struct FlintInteger {
  FlintInteger() { fmpz_init(data); }
  explicit FlintInteger(const Integer& x) : FlintInteger() { to_fmpz(data, x); }
  ~FlintInteger() { fmpz_clear(data); }
  FlintInteger(const FlintInteger&) = delete;
  FlintInteger& operator=(const FlintInteger&) = delete;
  fmpz_t data;
};

}  // namespace limes
