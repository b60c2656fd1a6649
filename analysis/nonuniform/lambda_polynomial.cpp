#include "analysis/nonuniform/lambda_polynomial.hpp"

#include "algebra/error.hpp"

#include <numeric>

namespace limes {

LambdaPolynomial::LambdaPolynomial(int variables, std::vector<MultivariatePolynomial> coefficients)
    : variables_(variables), coefficients_(std::move(coefficients)) {
  for (const auto& d : coefficients_) {
    if (d.variables() != variables) throw DomainError("a coefficient in another number of variables");
  }
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

LambdaPolynomial LambdaPolynomial::from_expanded(const MultivariatePolynomial& p) {
  const int variables = p.variables() - 1;
  // lambda, which no longer occurs, has no image.
  std::vector<int> map(static_cast<std::size_t>(variables) + 1, -1);
  std::iota(map.begin() + 1, map.end(), 0);
  std::vector<MultivariatePolynomial> coefficients;
  for (const auto& d : p.coefficients(0)) coefficients.push_back(d.mapped(variables, map));
  return {variables, std::move(coefficients)};
}

LambdaPolynomial LambdaPolynomial::linear(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
  return {a.variables(), {-b, a}};
}

std::vector<int> LambdaPolynomial::degrees() const {
  std::vector<int> result(static_cast<std::size_t>(variables_), 0);
  for (const auto& d : coefficients_) {
    const std::vector<int> own = d.degrees();
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::max(result[i], own[i]);
  }
  return result;
}

MultivariatePolynomial LambdaPolynomial::expanded() const {
  std::vector<MultivariatePolynomial::Term> terms;
  for (std::size_t s = 0; s < coefficients_.size(); ++s) {
    for (auto& term : coefficients_[s].terms()) {
      term.exponents.insert(term.exponents.begin(), static_cast<int>(s));
      terms.push_back(std::move(term));
    }
  }
  return MultivariatePolynomial::from_terms(variables_ + 1, terms);
}

Polynomial LambdaPolynomial::at(std::span<const Rational> point) const {
  std::vector<Rational> values;
  for (const auto& d : coefficients_) values.push_back(d(point));
  return Polynomial(values);
}

LambdaPolynomial LambdaPolynomial::substitute(int index, const Rational& value) const {
  std::vector<MultivariatePolynomial> result;
  for (const auto& d : coefficients_) result.push_back(d.substitute(index, value));
  return {variables_, std::move(result)};
}

LambdaPolynomial operator*(const LambdaPolynomial& a, const LambdaPolynomial& b) {
  if (a.variables() != b.variables()) throw DomainError("polynomials in different numbers of variables do not mix");
  if (a.degree() < 0 || b.degree() < 0) return LambdaPolynomial(a.variables());
  std::vector<MultivariatePolynomial> result(static_cast<std::size_t>(a.degree() + b.degree()) + 1,
                                             MultivariatePolynomial(a.variables()));
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
    for (std::size_t j = 0; j < b.coefficients_.size(); ++j) result[i + j] += a.coefficients_[i] * b.coefficients_[j];
  }
  return {a.variables(), std::move(result)};
}

bool operator==(const LambdaPolynomial& a, const LambdaPolynomial& b) {
  return a.variables_ == b.variables_ && a.coefficients_ == b.coefficients_;
}

std::optional<LambdaPolynomial> exact_quotient(const LambdaPolynomial& a, const LambdaPolynomial& b) {
  const auto quotient = exact_quotient(a.expanded(), b.expanded());
  if (!quotient) return std::nullopt;
  return LambdaPolynomial::from_expanded(*quotient);
}

PrimitivePart primitive_part(const LambdaPolynomial& a) {
  if (a.degree() < 0) throw DomainError("the content of the zero polynomial");
  // Short coefficients first: the divisor is soon small.
  std::vector<const MultivariatePolynomial*> order;
  for (const auto& d : a.coefficients()) order.push_back(&d);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* left, const auto* right) { return left->term_count() < right->term_count(); });
  MultivariatePolynomial divisor(a.variables());
  for (const auto* d : order) {
    if (!divisor.is_zero() && divisor.is_constant()) break;
    divisor = gcd(divisor, *d);
  }
  std::vector<MultivariatePolynomial> part;
  Integer denominators = 1;
  Integer numerators = 0;
  for (const auto& d : a.coefficients()) {
    part.push_back(divisor.is_constant() ? d : *exact_quotient(d, divisor));
    for (const auto& term : part.back().terms()) {
      denominators = lcm(denominators, denominator(term.coefficient));
    }
  }
  if (divisor.is_constant()) divisor = MultivariatePolynomial::constant(a.variables(), 1);
  for (const auto& d : part) {
    for (const auto& term : d.terms()) {
      numerators =
          gcd(numerators, Integer(numerator(term.coefficient) * (denominators / denominator(term.coefficient))));
    }
  }
  Rational factor(denominators, numerators);
  if (part.back().terms().front().coefficient < 0) factor = -factor;
  for (auto& d : part) d *= factor;
  divisor *= 1 / factor;
  return {std::move(divisor), LambdaPolynomial(a.variables(), std::move(part))};
}

std::string to_string(const LambdaPolynomial& a, const VariableNames& names) {
  VariableNames all{"lambda"};
  all.insert(all.end(), names.begin(), names.end());
  return to_string(a.expanded(), all);
}

}  // namespace limes
