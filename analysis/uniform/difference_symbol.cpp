#include "analysis/uniform/difference_symbol.hpp"

#include "algebra/error.hpp"

namespace limes {

LaurentPolynomial sum_rule_remainder(const Mask& mask, int k) {
  const LaurentPolynomial& a = mask.symbol;
  if (a.is_zero()) return a;
  return divide(a.shifted(-a.lowest()), power(sigma(a.variables(), mask.arity), k)).second;
}

std::optional<LaurentPolynomial> difference_symbol(const Mask& mask, int k) {
  const int variables = mask.symbol.variables();
  const auto [quotient, remainder] = divide(mask.symbol, power(sigma(variables, mask.arity), k));
  if (!remainder.is_zero()) return std::nullopt;
  return RationalFunction::constant(variables, power(Rational(mask.arity), k - 1)) * quotient;
}

int sum_rule_order(const Mask& mask) {
  if (mask.symbol.is_zero()) throw DomainError("sum_rule_order: the mask is zero");
  const LaurentPolynomial factor = sigma(mask.symbol.variables(), mask.arity);
  LaurentPolynomial rest = mask.symbol;
  for (int order = 0;; ++order) {
    auto [quotient, remainder] = divide(rest, factor);
    if (!remainder.is_zero()) return order;
    rest = std::move(quotient);
  }
}

PolynomialDegrees polynomial_degrees(const Mask& mask) {
  const int variables = mask.symbol.variables();
  const RationalFunction arity = RationalFunction::constant(variables, mask.arity);
  PolynomialDegrees degrees;
  if (!(mask.symbol(1) == arity)) return degrees;
  degrees.generation = sum_rule_order(mask) - 1;
  // a^{(d)}(1) = p tau (tau - 1) .. (tau - d + 1) with tau = a'(1) / p.
  LaurentPolynomial derivative = mask.symbol.differentiated();
  const RationalFunction tau = derivative(1) / arity;
  RationalFunction expected = arity;
  for (int d = 0; d <= degrees.generation; ++d) {
    if (d > 0) {
      expected *= tau - RationalFunction::constant(variables, d - 1);
      if (!(derivative(1) == expected)) break;
      derivative = derivative.differentiated();
    }
    degrees.reproduction = d;
  }
  degrees.parameter_shift = tau / RationalFunction::constant(variables, mask.arity - 1);
  return degrees;
}

}  // namespace limes
