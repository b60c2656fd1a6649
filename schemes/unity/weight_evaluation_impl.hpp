#pragma once

#include "algebra/error.hpp"
#include "schemes/unity/weight_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace limes {

/// Evaluates a weight function in floating point. `Convert` takes a Rational to a Real.
template <class Real, class Convert>
class WeightEvaluator {
 public:
  WeightEvaluator(const WeightFunction& weight, Convert convert)
      : weight_(weight), convert_(convert), centre_(convert(weight.centre)), pi_(acos(Real(-1))) {
    if (const auto* cinpact = std::get_if<CinpactWeight>(&weight.shape)) {
      radius_ = convert(cinpact->radius);
      sigma_ = convert(cinpact->sigma);
      return;
    }
    const auto* exact = std::get_if<PiecewisePolynomial>(&weight.shape);
    for (const Rational& b : exact ? exact->breaks : std::get<PiecewiseExpression>(weight.shape).breaks) breaks_.push_back(convert(b));
    if (!exact) return;
    for (const Polynomial& p : exact->pieces) {
      pieces_.emplace_back();
      for (const Rational& c : p.coefficients()) pieces_.back().push_back(convert(c));
    }
  }

  /// \throws InputError when the value is not finite
  Real operator()(const Real& u) const {
    using std::isfinite;
    const Real x = u - centre_;
    const Real value = std::holds_alternative<CinpactWeight>(weight_.shape) ? cinpact(x) : piecewise(x);
    if (!isfinite(value)) throw InputError(fmt::format("the weight function is not finite at u = {}", static_cast<double>(u)));
    return value;
  }

 private:
  Real cinpact(const Real& x) const {
    using std::exp, std::sin;
    const Real gap = (radius_ - x) * (radius_ + x);
    if (!(gap > 0)) return 0;
    Real value = exp(-sigma_ * x * x / gap);
    if (std::get<CinpactWeight>(weight_.shape).interpolating && x != 0) value *= sin(pi_ * x) / (pi_ * x);
    return value;
  }

  Real piecewise(const Real& x) const {
    const auto* exact = std::get_if<PiecewisePolynomial>(&weight_.shape);
    const bool everywhere = exact && exact->global;
    if (!everywhere && (x < breaks_.front() || x > breaks_.back())) return 0;
    const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
    const std::size_t piece = everywhere ? 0 : static_cast<std::size_t>(after - breaks_.begin()) - 1;
    if (!exact) return evaluate(std::get<PiecewiseExpression>(weight_.shape).pieces[piece], x);
    const Real t = x - breaks_[piece];
    Real value = 0;
    for (auto c = pieces_[piece].rbegin(); c != pieces_[piece].rend(); ++c) value = value * t + *c;
    return value;
  }

  Real evaluate(const Expression& expression, const Real& u) const {
    using std::exp, std::log, std::sin, std::cos, std::sqrt, std::abs, std::pow;
    if (const auto* number = std::get_if<Expression::Number>(&expression.node)) return convert_(number->value);
    if (const auto* name = std::get_if<Expression::Name>(&expression.node)) return name->name == "pi" ? pi_ : u;
    if (const auto* power = std::get_if<Expression::Power>(&expression.node)) return pow(evaluate(power->base[0], u), power->exponent);
    if (const auto* operation = std::get_if<Expression::Operation>(&expression.node)) {
      const Real a = evaluate(operation->operands.front(), u);
      if (operation->op == '~') return -a;
      const Real b = evaluate(operation->operands.back(), u);
      return operation->op == '+' ? Real(a + b) : operation->op == '-' ? Real(a - b) : operation->op == '*' ? Real(a * b) : Real(a / b);
    }
    const auto& call = std::get<Expression::Call>(expression.node);
    const Real a = evaluate(call.arguments[0], u);
    if (call.function == "exp") return exp(a);
    if (call.function == "log") return log(a);
    if (call.function == "sin") return sin(a);
    if (call.function == "cos") return cos(a);
    return call.function == "sqrt" ? Real(sqrt(a)) : Real(abs(a));
  }

  const WeightFunction& weight_;
  Convert convert_;
  Real centre_;
  Real pi_;
  Real radius_;
  Real sigma_;
  std::vector<Real> breaks_;
  std::vector<std::vector<Real>> pieces_;
};

}  // namespace limes
