// The only place where Rational meets Arb. Included by sources, never by public headers.
#pragma once

#include "algebra/polynomial/box.hpp"

#include <acb.h>

namespace limes {

/// A ball that clears itself.
struct RealBall {
  RealBall() { arb_init(data); }
  ~RealBall() { arb_clear(data); }
  RealBall(const RealBall&) = delete;
  RealBall& operator=(const RealBall&) = delete;
  arb_t data;
};

/// Complex ones, likewise.
class Balls {
 public:
  explicit Balls(std::size_t count) : data_(_acb_vec_init(slong(count))), count_(slong(count)) {}
  ~Balls() { _acb_vec_clear(data_, count_); }
  Balls(const Balls&) = delete;
  Balls& operator=(const Balls&) = delete;
  acb_ptr operator[](std::size_t i) const { return data_ + i; }
  acb_ptr data() const { return data_; }
  std::size_t count() const { return std::size_t(count_); }

 private:
  acb_ptr data_;
  slong count_;
};

/// The exact ends of a finite ball. \throws DomainError for a ball that is not finite.
Rational lower_end(const arb_t x);
Rational upper_end(const arb_t x);
Interval enclosure(const arb_t x);

}  // namespace limes
