#include "algebra/polynomial/rational_function.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/multivariate_polynomial_impl.hpp"

#include <algorithm>
#include <limits>

namespace limes {

namespace {

/// Divides a and b by their greatest common divisor.
void divide_out_common(MultivariatePolynomial& a, MultivariatePolynomial& b) {
  if (a.is_constant() || b.is_constant()) return;
  MultivariatePolynomial common(a.variables()), first(a.variables()), second(a.variables());
  if (!fmpq_mpoly_gcd_cofactors(common.impl().poly, first.impl().poly, second.impl().poly, a.impl().poly, b.impl().poly,
                                a.impl().context)) {
    throw LimitError("the polynomials are too large for a common divisor");
  }
  if (common.is_constant()) return;
  a = std::move(first);
  b = std::move(second);
}

/// Brings coprime parts to the form with leading denominator coefficient 1.
void normalise(MultivariatePolynomial& numerator, MultivariatePolynomial& denominator) {
  if (denominator.is_zero()) throw DomainError("division by zero");
  if (numerator.is_zero()) {
    denominator = MultivariatePolynomial::constant(numerator.variables(), 1);
    return;
  }
  auto& d = denominator.impl();
  if (fmpq_mpoly_is_monic(d.poly, d.context)) return;
  FlintRational leading;
  fmpq_mpoly_get_term_coeff_fmpq(leading.data, d.poly, 0, d.context);
  fmpq_mpoly_scalar_div_fmpq(d.poly, d.poly, leading.data, d.context);
  auto& n = numerator.impl();
  fmpq_mpoly_scalar_div_fmpq(n.poly, n.poly, leading.data, n.context);
}

void require_same(int a, int b) {
  if (a != b) throw DomainError("rational functions in different numbers of variables do not mix");
}

}  // namespace

RationalFunction::RationalFunction(int variables)
    : numerator_(variables), denominator_(MultivariatePolynomial::constant(variables, 1)) {}

RationalFunction::RationalFunction(MultivariatePolynomial polynomial)
    : numerator_(std::move(polynomial)), denominator_(MultivariatePolynomial::constant(numerator_.variables(), 1)) {}

RationalFunction::RationalFunction(MultivariatePolynomial numerator, MultivariatePolynomial denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  require_same(numerator_.variables(), denominator_.variables());
  reduce();
}

RationalFunction RationalFunction::constant(int variables, const Rational& c) {
  return MultivariatePolynomial::constant(variables, c);
}

RationalFunction RationalFunction::variable(int variables, int index) {
  return MultivariatePolynomial::variable(variables, index);
}

void RationalFunction::reduce() {
  divide_out_common(numerator_, denominator_);
  normalise(numerator_, denominator_);
}

Rational RationalFunction::constant_value() const {
  if (!is_constant()) throw DomainError("the rational function is not constant");
  return numerator_.constant_value();
}

Rational RationalFunction::operator()(std::span<const Rational> point) const {
  if (is_polynomial()) return numerator_(point);
  const Rational divisor = denominator_(point);
  if (divisor.is_zero()) throw DomainError("a rational function at a pole");
  return numerator_(point) / divisor;
}

RationalFunction RationalFunction::substitute(int index, const Rational& value) const {
  if (is_polynomial()) return numerator_.substitute(index, value);
  return {numerator_.substitute(index, value), denominator_.substitute(index, value)};
}

RationalFunction RationalFunction::substitute(int index, const RationalFunction& value) const {
  require_same(variables(), value.variables());
  if (is_polynomial() && value.is_polynomial()) return numerator_.substitute(index, value.numerator_);
  // With value = p/q and n the greater degree, both parts times q^n are sum_k c_k p^k q^{n-k}.
  const auto above = numerator_.coefficients(index), below = denominator_.coefficients(index);
  const std::size_t n = std::max(above.size(), below.size());
  RationalFunction result(variables());
  result.denominator_ = MultivariatePolynomial(variables());
  MultivariatePolynomial q_power = MultivariatePolynomial::constant(variables(), 1);
  for (std::size_t k = n; k-- > 0;) {
    result.numerator_ *= value.numerator_;
    result.denominator_ *= value.numerator_;
    if (k < above.size()) result.numerator_ += above[k] * q_power;
    if (k < below.size()) result.denominator_ += below[k] * q_power;
    if (k > 0) q_power *= value.denominator_;
  }
  result.reduce();
  return result;
}

RationalFunction RationalFunction::mapped(int variables, std::span<const int> map) const {
  if (is_polynomial()) return numerator_.mapped(variables, map);
  return {numerator_.mapped(variables, map), denominator_.mapped(variables, map)};
}

RationalFunction RationalFunction::operator-() const {
  RationalFunction result = *this;
  result.numerator_ = -numerator_;
  return result;
}

RationalFunction& RationalFunction::operator+=(const RationalFunction& other) {
  if (is_polynomial() && other.is_polynomial()) {
    numerator_ += other.numerator_;
  } else if (denominator_ == other.denominator_) {
    numerator_ += other.numerator_;
    reduce();
  } else {
    // Only the common part of the denominators can cancel against the new numerator (Henrici 1956).
    MultivariatePolynomial mine = denominator_, theirs = other.denominator_;
    divide_out_common(mine, theirs);
    numerator_ = numerator_ * theirs + other.numerator_ * mine;
    if (mine == denominator_) {
      denominator_ *= theirs;
      normalise(numerator_, denominator_);
    } else {
      denominator_ *= theirs;
      reduce();
    }
  }
  return *this;
}

RationalFunction& RationalFunction::operator-=(const RationalFunction& other) { return *this += -other; }

RationalFunction& RationalFunction::operator*=(const RationalFunction& other) {
  if (is_polynomial() && other.is_polynomial()) {
    numerator_ *= other.numerator_;
    return *this;
  }
  require_same(variables(), other.variables());
  MultivariatePolynomial their_numerator = other.numerator_, their_denominator = other.denominator_;
  divide_out_common(numerator_, their_denominator);
  divide_out_common(their_numerator, denominator_);
  numerator_ *= their_numerator;
  denominator_ *= their_denominator;
  normalise(numerator_, denominator_);
  return *this;
}

RationalFunction& RationalFunction::operator/=(const RationalFunction& other) {
  if (other.is_zero()) throw DomainError("division by zero");
  RationalFunction inverse(other.variables());
  inverse.numerator_ = other.denominator_;
  inverse.denominator_ = other.numerator_;
  normalise(inverse.numerator_, inverse.denominator_);
  return *this *= inverse;
}

bool operator==(const RationalFunction& a, const RationalFunction& b) {
  return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
}

RationalFunction power(const RationalFunction& a, int exponent) {
  if (exponent < 0) {
    if (exponent == std::numeric_limits<int>::min()) throw LimitError("the power " + std::to_string(exponent));
    return power(RationalFunction::constant(a.variables(), 1) / a, -exponent);
  }
  if (a.is_polynomial()) return power(a.numerator(), exponent);
  return {power(a.numerator(), exponent), power(a.denominator(), exponent)};
}

std::string to_string(const RationalFunction& a, const VariableNames& names) {
  const std::string above = to_string(a.numerator(), names);
  if (a.is_polynomial()) return above;
  const std::string below = to_string(a.denominator(), names);
  // The numerator is safe before "/" as one term, the denominator after it as one power.
  const bool simple_above = a.numerator().term_count() == 1;
  const bool simple_below = below.find_first_of("+-*/ ") == std::string::npos;
  return (simple_above ? above : "(" + above + ")") + "/" + (simple_below ? below : "(" + below + ")");
}

}  // namespace limes
