// Real numbers of a chosen precision, on MPFR, beside double. Included by sources only.
#pragma once

#include "algebra/number/mpfr_conversion.hpp"

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <mutex>

namespace limes {

using Mpfr = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

/// The working precision of Mpfr, in decimal digits, while it lives; Boost has one for all threads, so one scope lives at a time.
class PrecisionScope {
 public:
  explicit PrecisionScope(int digits) : lock_(mutex()), before_(Mpfr::default_precision()) {
    Mpfr::default_precision(static_cast<unsigned>(digits));
  }
  ~PrecisionScope() { Mpfr::default_precision(before_); }
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  std::scoped_lock<std::mutex> lock_;
  unsigned before_;
};

/// The nearest number. Real is double or Mpfr.
template <class Real>
Real from_rational(const Rational& x) {
  if constexpr (std::is_same_v<Real, double>) {
    return approx_double(x);
  } else {
    Mpfr result;
    to_mpfr(result.backend().data(), x, MPFR_RNDN);
    return result;
  }
}

inline Rational exact_rational(const Mpfr& x) { return from_mpfr(x.backend().data()); }

}  // namespace limes
