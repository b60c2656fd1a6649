#pragma once

#include <boost/multiprecision/gmp.hpp>

#include <string>

namespace limes {

/// Exact integers and rationals on GMP, without expression templates (so that `auto` is safe). A Rational is always canonical:
/// coprime, positive denominator. Text becomes a Rational through read_rational() only.
/// \warning Boost 1.74 takes the denominator in Rational(1, -3) for unsigned and gives 1/18446744073709551613; a denominator 0
/// ends the program. Write Rational(n) / d, which is right for every d != 0 and throws std::overflow_error for 0.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// "p/q", or "p" when the denominator is 1.
std::string to_string(const Rational& x);
std::string to_string(const Integer& x);

/// Nearest double (round to nearest, ties unspecified); a floating hint, never a bound.
double approx_double(const Rational& x);

/// The number that the double is. \throws DomainError for NaN and the infinities, with which Boost's constructor ends the program
Rational exact_rational(double x);

enum class Rounding { down, up, nearest };

/// Decimal text of x with `digits` significant digits, rounded as asked (down = towards minus infinity). Exact values that fit
/// are printed without padding zeros. \pre 1 <= digits <= 1000
std::string to_decimal(const Rational& x, int digits, Rounding rounding);

/// base^exponent. \pre exponent >= 0 or base != 0. \throws DomainError for 0 to a negative power.
Rational power(const Rational& base, int exponent);

/// The rational with the least denominator in the closed interval [lower, upper] (Stern-Brocot). \pre lower <= upper
Rational simplest_between(const Rational& lower, const Rational& upper);

}  // namespace limes
