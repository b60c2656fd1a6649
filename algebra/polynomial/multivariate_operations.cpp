// The free functions on multivariate polynomials: quotients, divisors, powers, factors, printing.
#include "algebra/error.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"
#include "algebra/polynomial/multivariate_polynomial_impl.hpp"

#include <flint/fmpq_mpoly_factor.h>

namespace limes {

namespace {

void require_same(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
  if (a.variables() != b.variables()) throw DomainError("polynomials in different numbers of variables do not mix");
}

}  // namespace

std::optional<MultivariatePolynomial> exact_quotient(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
  require_same(a, b);
  if (b.is_zero()) throw DomainError("division by the zero polynomial");
  MultivariatePolynomial result(a.variables());
  if (!fmpq_mpoly_divides(result.impl().poly, a.impl().poly, b.impl().poly, a.impl().context)) return std::nullopt;
  return result;
}

MultivariatePolynomial gcd(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
  require_same(a, b);
  MultivariatePolynomial result(a.variables());
  if (!fmpq_mpoly_gcd(result.impl().poly, a.impl().poly, b.impl().poly, a.impl().context)) {
    throw LimitError("the polynomials are too large for a common divisor");
  }
  return result;
}

MultivariatePolynomial power(const MultivariatePolynomial& a, int exponent) {
  if (exponent < 0) throw DomainError("a polynomial to a negative power");
  MultivariatePolynomial result(a.variables());
  if (!fmpq_mpoly_pow_ui(result.impl().poly, a.impl().poly, static_cast<ulong>(exponent), a.impl().context)) {
    throw LimitError("the polynomial is too large for the power " + std::to_string(exponent));
  }
  return result;
}

std::vector<std::pair<MultivariatePolynomial, int>> factorisation(const MultivariatePolynomial& a) {
  if (a.is_zero()) throw DomainError("the factorisation of the zero polynomial");
  const auto* context = a.impl().context;
  fmpq_mpoly_factor_t factors;
  fmpq_mpoly_factor_init(factors, context);
  const bool done =
      fmpq_mpoly_factor(factors, a.impl().poly, context) && fmpq_mpoly_factor_make_monic(factors, context);
  std::vector<std::pair<MultivariatePolynomial, int>> result;
  if (done) {
    fmpq_mpoly_factor_sort(factors, context);
    for (slong i = 0; i < fmpq_mpoly_factor_length(factors, context); ++i) {
      result.emplace_back(a.variables(), static_cast<int>(fmpq_mpoly_factor_get_exp_si(factors, i, context)));
      fmpq_mpoly_factor_swap_base(result.back().first.impl().poly, factors, i, context);
    }
  }
  fmpq_mpoly_factor_clear(factors, context);
  if (!done) throw LimitError("the polynomial is too large for factorisation");
  return result;
}

std::string to_string(const MultivariatePolynomial& a, const VariableNames& names) {
  if (names.size() != static_cast<std::size_t>(a.variables())) {
    throw DomainError("a polynomial in " + std::to_string(a.variables()) + " variables printed with " +
                      std::to_string(names.size()) + " names");
  }
  std::string text;
  for (const auto& [exponents, coefficient] : a.terms()) {
    const bool negative = coefficient.sign() < 0;
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    std::string monomial;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (exponents[i] == 0) continue;
      if (!monomial.empty()) monomial += '*';
      monomial += names[i];
      if (exponents[i] > 1) monomial += "^" + std::to_string(exponents[i]);
    }
    const Rational modulus = abs(coefficient);
    if (monomial.empty()) {
      text += to_string(modulus);
    } else {
      text += modulus == 1 ? monomial : to_string(modulus) + "*" + monomial;
    }
  }
  return text.empty() ? "0" : text;
}

}  // namespace limes
