#include "algebra/polynomial/laurent_polynomial.hpp"

#include "algebra/error.hpp"

#include <algorithm>

namespace limes {

namespace {

void require_same(int a, int b) {
  if (a != b) throw DomainError("Laurent polynomials in different numbers of parameters do not mix");
}

}  // namespace

LaurentPolynomial::LaurentPolynomial(int variables, int lowest, std::vector<RationalFunction> coefficients)
    : variables_(variables), lowest_(lowest), coefficients_(std::move(coefficients)) {
  for (const RationalFunction& c : coefficients_) require_same(c.variables(), variables);
  trim();
}

LaurentPolynomial LaurentPolynomial::from_rationals(int lowest, const std::vector<Rational>& coefficients) {
  std::vector<RationalFunction> constants;
  constants.reserve(coefficients.size());
  for (const Rational& c : coefficients) constants.push_back(RationalFunction::constant(0, c));
  return {0, lowest, std::move(constants)};
}

void LaurentPolynomial::trim() {
  const auto occurs = [](const RationalFunction& c) { return !c.is_zero(); };
  coefficients_.erase(std::find_if(coefficients_.rbegin(), coefficients_.rend(), occurs).base(), coefficients_.end());
  const auto first = std::find_if(coefficients_.begin(), coefficients_.end(), occurs);
  lowest_ = coefficients_.empty() ? 0 : lowest_ + static_cast<int>(first - coefficients_.begin());
  coefficients_.erase(coefficients_.begin(), first);
}

int LaurentPolynomial::lowest() const {
  if (is_zero()) throw DomainError("the lowest exponent of the zero Laurent polynomial");
  return lowest_;
}

int LaurentPolynomial::highest() const {
  if (is_zero()) throw DomainError("the highest exponent of the zero Laurent polynomial");
  return lowest_ + length() - 1;
}

RationalFunction LaurentPolynomial::coefficient(int i) const {
  if (is_zero() || i < lowest_ || i > highest()) return RationalFunction(variables_);
  return coefficients_[static_cast<std::size_t>(i - lowest_)];
}

LaurentPolynomial LaurentPolynomial::operator-() const {
  LaurentPolynomial result = *this;
  for (RationalFunction& c : result.coefficients_) c = -c;
  return result;
}

LaurentPolynomial& LaurentPolynomial::operator+=(const LaurentPolynomial& other) {
  require_same(variables_, other.variables_);
  if (other.is_zero()) return *this;
  if (is_zero()) return *this = other;
  if (this == &other) return *this = *this + LaurentPolynomial(other);
  const int low = std::min(lowest_, other.lowest_), high = std::max(highest(), other.highest());
  const RationalFunction zero(variables_);
  coefficients_.insert(coefficients_.begin(), static_cast<std::size_t>(lowest_ - low), zero);
  coefficients_.resize(static_cast<std::size_t>(high - low + 1), zero);
  lowest_ = low;
  const auto offset = static_cast<std::size_t>(other.lowest_ - low);
  for (std::size_t k = 0; k < other.coefficients_.size(); ++k) coefficients_[offset + k] += other.coefficients_[k];
  trim();
  return *this;
}

LaurentPolynomial& LaurentPolynomial::operator-=(const LaurentPolynomial& other) { return *this += -other; }

LaurentPolynomial operator*(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  require_same(a.variables_, b.variables_);
  LaurentPolynomial result(a.variables_);
  if (a.is_zero() || b.is_zero()) return result;
  result.lowest_ = a.lowest_ + b.lowest_;
  result.coefficients_.assign(a.coefficients_.size() + b.coefficients_.size() - 1, RationalFunction(a.variables_));
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
    if (a.coefficients_[i].is_zero()) continue;
    for (std::size_t j = 0; j < b.coefficients_.size(); ++j) {
      if (!b.coefficients_[j].is_zero()) result.coefficients_[i + j] += a.coefficients_[i] * b.coefficients_[j];
    }
  }
  result.trim();
  return result;
}

LaurentPolynomial operator*(const RationalFunction& c, const LaurentPolynomial& a) {
  require_same(c.variables(), a.variables_);
  LaurentPolynomial result = a;
  for (RationalFunction& coefficient : result.coefficients_) coefficient *= c;
  result.trim();
  return result;
}

bool operator==(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  require_same(a.variables_, b.variables_);
  return a.lowest_ == b.lowest_ && a.coefficients_ == b.coefficients_;
}

LaurentPolynomial LaurentPolynomial::shifted(int k) const {
  LaurentPolynomial result = *this;
  if (!is_zero()) result.lowest_ += k;
  return result;
}

LaurentPolynomial LaurentPolynomial::dilated(int k) const {
  if (k < 1) throw DomainError("a(z^k) with k = " + std::to_string(k));
  if (is_zero()) return *this;
  const auto step = static_cast<std::size_t>(k);
  std::vector<RationalFunction> spread((coefficients_.size() - 1) * step + 1, RationalFunction(variables_));
  for (std::size_t i = 0; i < coefficients_.size(); ++i) spread[i * step] = coefficients_[i];
  return {variables_, lowest_ * k, std::move(spread)};
}

LaurentPolynomial LaurentPolynomial::alternated() const {
  LaurentPolynomial result = *this;
  for (int k = 0; k < length(); ++k) {
    RationalFunction& c = result.coefficients_[static_cast<std::size_t>(k)];
    if ((lowest_ + k) % 2 != 0) c = -c;
  }
  return result;
}

LaurentPolynomial LaurentPolynomial::differentiated() const {
  LaurentPolynomial result = *this;
  for (int k = 0; k < length(); ++k) {
    result.coefficients_[static_cast<std::size_t>(k)] *= RationalFunction::constant(variables_, lowest_ + k);
  }
  --result.lowest_;
  result.trim();
  return result;
}

RationalFunction LaurentPolynomial::operator()(const Rational& z) const {
  if (z.is_zero()) throw DomainError("a Laurent polynomial at 0");
  RationalFunction value(variables_);
  const RationalFunction argument = RationalFunction::constant(variables_, z);
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) {
    if (z != 1) value *= argument;
    value += *c;
  }
  return z == 1 ? value : value * RationalFunction::constant(variables_, power(z, lowest_));
}

LaurentPolynomial LaurentPolynomial::at(std::span<const Rational> point) const {
  std::vector<Rational> values;
  values.reserve(coefficients_.size());
  for (const RationalFunction& c : coefficients_) values.push_back(c(point));
  return from_rationals(lowest_, values);
}

LaurentPolynomial LaurentPolynomial::substitute(int index, const Rational& value) const {
  LaurentPolynomial result = *this;
  for (RationalFunction& c : result.coefficients_) c = c.substitute(index, value);
  result.trim();
  return result;
}

std::vector<Rational> LaurentPolynomial::rational_coefficients() const {
  std::vector<Rational> result;
  result.reserve(coefficients_.size());
  for (const RationalFunction& c : coefficients_) result.push_back(c.constant_value());
  return result;
}

std::pair<LaurentPolynomial, LaurentPolynomial> divide(const LaurentPolynomial& a, const LaurentPolynomial& d) {
  require_same(a.variables(), d.variables());
  if (d.is_zero()) throw DomainError("division by the zero Laurent polynomial");
  if (d.lowest() != 0) throw DomainError("the divisor of a Laurent polynomial starts at z^0");
  const Rational leading = d.coefficients().back().constant_value();
  if (a.is_zero()) return {a, a};
  const auto steps = static_cast<std::size_t>(std::max(0, a.length() - d.length() + 1));
  const auto degree = static_cast<std::size_t>(d.length() - 1);
  const RationalFunction inverse = RationalFunction::constant(a.variables(), 1 / leading);
  std::vector<RationalFunction> remainder = a.coefficients();
  std::vector<RationalFunction> quotient(steps, RationalFunction(a.variables()));
  for (std::size_t k = steps; k-- > 0;) {
    quotient[k] = remainder[k + degree] * inverse;
    if (quotient[k].is_zero()) continue;
    for (std::size_t j = 0; j < degree; ++j) remainder[k + j] -= quotient[k] * d.coefficients()[j];
  }
  if (steps > 0) remainder.resize(degree, RationalFunction(a.variables()));
  return {LaurentPolynomial(a.variables(), a.lowest(), std::move(quotient)),
          LaurentPolynomial(a.variables(), a.lowest(), std::move(remainder))};
}

LaurentPolynomial sigma(int variables, int arity) {
  if (arity < 1) throw DomainError("sigma of arity " + std::to_string(arity));
  return {variables, 0,
          std::vector<RationalFunction>(static_cast<std::size_t>(arity), RationalFunction::constant(variables, 1))};
}

LaurentPolynomial power(const LaurentPolynomial& a, int exponent) {
  if (exponent < 0) throw DomainError("a Laurent polynomial to a negative power");
  LaurentPolynomial result = sigma(a.variables(), 1), square = a;
  for (int e = exponent; e > 0; e /= 2) {
    if (e % 2 == 1) result = result * square;
    if (e > 1) square = square * square;
  }
  return result;
}

MultivariatePolynomial common_denominator(const LaurentPolynomial& a) {
  MultivariatePolynomial result = MultivariatePolynomial::constant(a.variables(), 1);
  for (const RationalFunction& c : a.coefficients()) {
    if (!c.is_polynomial()) result *= *exact_quotient(c.denominator(), gcd(result, c.denominator()));
  }
  return result;
}

std::vector<MultivariatePolynomial> numerators_over(const LaurentPolynomial& a, const MultivariatePolynomial& denominator) {
  std::vector<MultivariatePolynomial> result;
  for (const RationalFunction& c : a.coefficients()) {
    const std::optional<MultivariatePolynomial> factor = exact_quotient(denominator, c.denominator());
    if (!factor) throw DomainError("numerators_over: not a common denominator");
    result.push_back(c.numerator() * *factor);
  }
  return result;
}

}  // namespace limes
