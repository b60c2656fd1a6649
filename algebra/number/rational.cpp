#include "algebra/number/rational.hpp"

#include "algebra/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace limes {

namespace {

std::string to_text(const mpz_t x) {
  std::string text(mpz_sizeinbase(x, 10) + 2, '\0');
  mpz_get_str(text.data(), 10, x);
  text.resize(text.find('\0'));
  return text;
}

Integer numerator_of(const Rational& x) {
  Integer n;
  mpz_set(n.backend().data(), mpq_numref(x.backend().data()));
  return n;
}

Integer denominator_of(const Rational& x) {
  Integer d;
  mpz_set(d.backend().data(), mpq_denref(x.backend().data()));
  return d;
}

Integer ten_to_the(unsigned long exponent) {
  Integer result;
  mpz_ui_pow_ui(result.backend().data(), 10, exponent);
  return result;
}

/// The fraction n 10^shift / d, as a pair of positive integers.
void scale_by_ten(Integer& n, Integer& d, long shift) {
  (shift >= 0 ? n : d) *= ten_to_the(static_cast<unsigned long>(std::labs(shift)));
}

/// floor(log10(n/d)) for positive n, d.
long decimal_exponent(const Integer& n, const Integer& d) {
  const double bits = static_cast<double>(mpz_sizeinbase(n.backend().data(), 2)) -
                      static_cast<double>(mpz_sizeinbase(d.backend().data(), 2));
  long e = static_cast<long>(std::floor(bits * 0.30102999566398119521));
  // The guess is off by one at most; both tests are exact.
  const auto at_least_power = [&](long exponent) {
    Integer left = n, right = d;
    scale_by_ten(left, right, -exponent);
    return left >= right;
  };
  while (!at_least_power(e)) --e;
  while (at_least_power(e + 1)) ++e;
  return e;
}

/// Digits d_0 d_1 d_2 .. with value d_0.d_1d_2.. 10^exponent as decimal text, plain when that is short.
std::string place_point(std::string digits, long exponent, long precision) {
  constexpr long least_plain = -7, greatest_plain = 16;
  if (exponent < least_plain || exponent >= std::max(greatest_plain, precision)) {
    if (digits.size() > 1) digits.insert(1, ".");
    return digits + "e" + std::to_string(exponent);
  }
  if (exponent < 0) return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() < whole) digits.append(whole - digits.size(), '0');
  if (digits.size() > whole) digits.insert(whole, ".");
  return digits;
}

}  // namespace

std::string to_string(const Integer& x) { return to_text(x.backend().data()); }

std::string to_string(const Rational& x) {
  std::string text = to_text(mpq_numref(x.backend().data()));
  const auto& denominator = mpq_denref(x.backend().data());
  return mpz_cmp_ui(denominator, 1) == 0 ? text : text + "/" + to_text(denominator);
}

Rational exact_rational(double x) {
  if (!std::isfinite(x)) throw DomainError("exact_rational: not a finite number");
  return Rational(x);
}

double approx_double(const Rational& x) {
  const auto& n = mpq_numref(x.backend().data());
  const auto& d = mpq_denref(x.backend().data());
  if (mpz_sizeinbase(n, 2) <= 53 && mpz_sizeinbase(d, 2) <= 53) return mpz_get_d(n) / mpz_get_d(d);
  const double towards_zero = mpq_get_d(x.backend().data());
  if (std::isinf(towards_zero)) return towards_zero;
  const double away = std::nextafter(towards_zero, mpz_sgn(n) * std::numeric_limits<double>::infinity());
  if (std::isinf(away)) return towards_zero;
  Rational twice_middle, exact_away;
  mpq_set_d(twice_middle.backend().data(), towards_zero);
  mpq_set_d(exact_away.backend().data(), away);
  twice_middle += exact_away;
  const int beyond_middle = (x * 2).compare(twice_middle) * mpz_sgn(n);
  return beyond_middle > 0 ? away : towards_zero;
}

std::string to_decimal(const Rational& x, int digits, Rounding rounding) {
  if (digits < 1 || digits > 1000) {
    throw DomainError("to_decimal: between 1 and 1000 digits, not " + std::to_string(digits));
  }
  const int sign = x.sign();
  if (sign == 0) return "0";
  Integer n = numerator_of(x), d = denominator_of(x);
  if (sign < 0) n = -n;
  long exponent = decimal_exponent(n, d);
  scale_by_ten(n, d, digits - 1 - exponent);
  Integer quotient, remainder;
  mpz_fdiv_qr(quotient.backend().data(), remainder.backend().data(), n.backend().data(), d.backend().data());
  const bool exact = remainder.is_zero();
  const bool away = rounding == Rounding::nearest ? 2 * remainder >= d : (rounding == Rounding::up) == (sign > 0);
  if (!exact && away) ++quotient;
  std::string text = to_string(quotient);
  if (text.size() > static_cast<std::size_t>(digits)) {  // 99.9 became 100
    text.pop_back();
    ++exponent;
  }
  if (exact) text.erase(text.find_last_not_of('0') + 1);
  return (sign < 0 ? "-" : "") + place_point(std::move(text), exponent, digits);
}

Rational power(const Rational& base, int exponent) {
  if (exponent < 0 && base.is_zero()) throw DomainError("0 to a negative power");
  const auto e = static_cast<unsigned long>(std::labs(exponent));
  Rational result;
  auto& q = result.backend().data();
  mpz_pow_ui(mpq_numref(q), mpq_numref(base.backend().data()), e);
  mpz_pow_ui(mpq_denref(q), mpq_denref(base.backend().data()), e);
  if (exponent < 0) mpq_inv(q, q);
  return result;
}

Rational simplest_between(const Rational& lower, const Rational& upper) {
  if (lower > upper) throw DomainError("simplest_between: the lower end exceeds the upper one");
  if (lower.sign() <= 0 && upper.sign() >= 0) return 0;
  if (upper.sign() < 0) return -simplest_between(-upper, -lower);
  // The common start of both continued fractions, then the least integer in what is left.
  std::vector<Integer> quotients;
  Rational low = lower, high = upper;
  while (true) {
    Integer ceiling;
    mpz_cdiv_q(ceiling.backend().data(), mpq_numref(low.backend().data()), mpq_denref(low.backend().data()));
    if (Rational(ceiling) <= high) {
      quotients.push_back(ceiling);
      break;
    }
    --ceiling;  // low is no integer, so this is the floor of both ends
    quotients.push_back(ceiling);
    Rational next_low = 1 / (high - Rational(ceiling));
    high = 1 / (low - Rational(ceiling));
    low = std::move(next_low);
  }
  Rational result(quotients.back());
  for (std::size_t i = quotients.size() - 1; i-- > 0;) result = Rational(quotients[i]) + 1 / result;
  return result;
}

}  // namespace limes
