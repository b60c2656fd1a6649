#include "algebra/polynomial/polynomial.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"
#include "algebra/polynomial/polynomial_impl.hpp"

#include <flint/fmpz_poly.h>

namespace limes {

Polynomial::Polynomial() : impl_(std::make_unique<Impl>()) {}

Polynomial::Polynomial(const std::vector<Rational>& coefficients) : Polynomial() {
  // One common denominator first: setting fractions one by one would rescale the whole polynomial each time.
  FlintInteger common;
  fmpz_one(common.data);
  std::vector<FlintRational> values(coefficients.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    to_fmpq(values[i].data, coefficients[i]);
    fmpz_lcm(common.data, common.data, fmpq_denref(values[i].data));
  }
  const auto length = static_cast<slong>(coefficients.size());
  auto& p = impl_->poly;
  fmpq_poly_fit_length(p, length);
  for (slong i = 0; i < length; ++i) {
    const auto& value = values[static_cast<std::size_t>(i)].data;
    fmpz* target = fmpq_poly_numref(p) + i;
    fmpz_divexact(target, common.data, fmpq_denref(value));
    fmpz_mul(target, target, fmpq_numref(value));
  }
  fmpz_set(fmpq_poly_denref(p), common.data);
  _fmpq_poly_set_length(p, length);
  fmpq_poly_canonicalise(p);
}

Polynomial Polynomial::constant(const Rational& c) { return monomial(c, 0); }

Polynomial Polynomial::monomial(const Rational& c, int degree) {
  if (degree < 0) throw DomainError("a monomial of negative degree");
  Polynomial result;
  const FlintRational value(c);
  fmpq_poly_set_coeff_fmpq(result.impl_->poly, degree, value.data);
  return result;
}

Polynomial::Polynomial(const Polynomial& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Polynomial::Polynomial(Polynomial&&) noexcept = default;
Polynomial::~Polynomial() = default;
Polynomial& Polynomial::operator=(Polynomial&&) noexcept = default;

Polynomial& Polynomial::operator=(const Polynomial& other) {
  if (impl_) {
    *impl_ = *other.impl_;
  } else {  // moved from
    impl_ = std::make_unique<Impl>(*other.impl_);
  }
  return *this;
}

int Polynomial::degree() const { return static_cast<int>(fmpq_poly_degree(impl_->poly)); }

Rational Polynomial::coefficient(int i) const {
  if (i < 0) throw DomainError("a coefficient of negative index");
  FlintRational value;
  fmpq_poly_get_coeff_fmpq(value.data, impl_->poly, i);
  return from_fmpq(value.data);
}

Rational Polynomial::leading_coefficient() const { return is_zero() ? Rational(0) : coefficient(degree()); }

std::vector<Rational> Polynomial::coefficients() const {
  std::vector<Rational> result;
  result.reserve(static_cast<std::size_t>(degree() + 1));
  for (int i = 0; i <= degree(); ++i) result.push_back(coefficient(i));
  return result;
}

Rational Polynomial::operator()(const Rational& x) const {
  const FlintRational at(x);
  FlintRational value;
  fmpq_poly_evaluate_fmpq(value.data, impl_->poly, at.data);
  return from_fmpq(value.data);
}

Polynomial Polynomial::operator-() const {
  Polynomial result;
  fmpq_poly_neg(result.impl_->poly, impl_->poly);
  return result;
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  fmpq_poly_add(impl_->poly, impl_->poly, other.impl_->poly);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  fmpq_poly_sub(impl_->poly, impl_->poly, other.impl_->poly);
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& other) {
  fmpq_poly_mul(impl_->poly, impl_->poly, other.impl_->poly);
  return *this;
}

Polynomial& Polynomial::operator*=(const Rational& c) {
  const FlintRational factor(c);
  fmpq_poly_scalar_mul_fmpq(impl_->poly, impl_->poly, factor.data);
  return *this;
}

bool operator==(const Polynomial& a, const Polynomial& b) { return fmpq_poly_equal(a.impl_->poly, b.impl_->poly) != 0; }

std::pair<Polynomial, Polynomial> divide(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw DomainError("division by the zero polynomial");
  std::pair<Polynomial, Polynomial> result;
  fmpq_poly_divrem(result.first.impl().poly, result.second.impl().poly, a.impl().poly, b.impl().poly);
  return result;
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  fmpq_poly_gcd(result.impl().poly, a.impl().poly, b.impl().poly);
  return result;
}

Polynomial derivative(const Polynomial& a) {
  Polynomial result;
  fmpq_poly_derivative(result.impl().poly, a.impl().poly);
  return result;
}

Polynomial compose(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  fmpq_poly_compose(result.impl().poly, a.impl().poly, b.impl().poly);
  return result;
}

Polynomial power(const Polynomial& a, int exponent) {
  if (exponent < 0) throw DomainError("a polynomial to a negative power");
  Polynomial result;
  fmpq_poly_pow(result.impl().poly, a.impl().poly, static_cast<ulong>(exponent));
  return result;
}

Polynomial reversed(const Polynomial& a) {
  Polynomial result;
  fmpq_poly_reverse(result.impl().poly, a.impl().poly, fmpq_poly_length(a.impl().poly));
  return result;
}

namespace {

Polynomial monic(const Polynomial& a) {
  Polynomial result;
  fmpq_poly_make_monic(result.impl().poly, a.impl().poly);
  return result;
}

}  // namespace

Polynomial square_free_part(const Polynomial& a) {
  if (a.is_zero()) throw DomainError("the square-free part of the zero polynomial");
  return monic(divide(a, gcd(a, derivative(a))).first);
}

std::vector<std::pair<Polynomial, int>> square_free_factorisation(const Polynomial& a) {
  if (a.is_zero()) throw DomainError("the square-free factorisation of the zero polynomial");
  // Yun's algorithm: b holds the product of the factors of multiplicity >= i, d = c - b'.
  std::vector<std::pair<Polynomial, int>> result;
  const Polynomial slope = derivative(a), repeated = gcd(a, slope);
  Polynomial b = divide(a, repeated).first;
  Polynomial d = divide(slope, repeated).first - derivative(b);
  for (int i = 1; b.degree() > 0; ++i) {
    const Polynomial factor = gcd(b, d);
    if (factor.degree() > 0) result.emplace_back(factor, i);
    b = divide(b, factor).first;
    d = divide(d, factor).first - derivative(b);
  }
  return result;
}

Polynomial cyclotomic(int n) {
  if (n < 1) throw DomainError("cyclotomic polynomials are numbered from 1");
  fmpz_poly_t integral;
  fmpz_poly_init(integral);
  fmpz_poly_cyclotomic(integral, static_cast<ulong>(n));
  Polynomial result;
  fmpq_poly_set_fmpz_poly(result.impl().poly, integral);
  fmpz_poly_clear(integral);
  return result;
}

std::string to_string(const Polynomial& a, std::string_view variable) {
  return to_string(MultivariatePolynomial::from_univariate(1, 0, a), {std::string(variable)});
}

}  // namespace limes
