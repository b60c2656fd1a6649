#include "algebra/number/mpfr_conversion.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

class MpfrConversion : public testing::Test {
 protected:
  MpfrConversion() { mpfr_init2(x_, 100); }
  ~MpfrConversion() override { mpfr_clear(x_); }
  mpfr_t x_;
};

TEST_F(MpfrConversion, DyadicNumbersAreExact) {
  for (const Rational& value : {Rational(0), Rational(-3), Rational(5) / 1024, Rational(-7) / 8}) {
    EXPECT_EQ(to_mpfr(x_, value, MPFR_RNDN), 0);
    EXPECT_EQ(from_mpfr(x_), value);
  }
}

TEST_F(MpfrConversion, DirectedRoundingEncloses) {
  for (int n = 1; n < 200; n += 2) {
    const Rational value = Rational(n - 100) / 97;
    to_mpfr(x_, value, MPFR_RNDD);
    const Rational lower = from_mpfr(x_);
    to_mpfr(x_, value, MPFR_RNDU);
    const Rational upper = from_mpfr(x_);
    EXPECT_LE(lower, value);
    EXPECT_LE(value, upper);
    EXPECT_LE(upper - lower, abs(value) * power(Rational(2), -98));
    EXPECT_EQ(lower == upper, denominator(value) == 1);
  }
}

TEST_F(MpfrConversion, NotANumberIsAnError) {
  mpfr_set_nan(x_);
  EXPECT_THROW(from_mpfr(x_), DomainError);
  mpfr_set_inf(x_, -1);
  EXPECT_THROW(from_mpfr(x_), DomainError);
}

}  // namespace
}  // namespace limes
