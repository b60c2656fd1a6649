#include "schemes/unity/weight_function.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

constexpr int max_spline_degree = 30;
constexpr int max_polynomial_degree = 60;

Polynomial linear(const Rational& a, const Rational& b) { return Polynomial({a, b}); }

/// B_d on [k, k+1) as a polynomial in u - k, by B_d(u) = (u B_{d-1}(u) + (d + 1 - u) B_{d-1}(u - 1)) / d (Cox and de Boor).
PiecewisePolynomial cardinal_spline(int degree) {
  std::vector<Polynomial> pieces{Polynomial::constant(1)};
  for (int d = 1; d <= degree; ++d) {
    std::vector<Polynomial> next;
    for (int k = 0; k <= d; ++k) {
      Polynomial piece;
      if (k < d) piece += linear(k, 1) * pieces[k];
      if (k > 0) piece += linear(d + 1 - k, -1) * pieces[k - 1];
      next.push_back(Rational(1) / d * piece);
    }
    pieces = std::move(next);
  }
  PiecewisePolynomial spline{.breaks = {}, .pieces = std::move(pieces)};
  for (int k = 0; k <= degree + 1; ++k) spline.breaks.push_back(Rational(2 * k - degree - 1) / 2);
  return spline;
}

/// Whether f(s + t) = f(s - t), piece by piece.
bool is_mirrored(const PiecewisePolynomial& f) {
  const Rational ends = f.breaks.front() + f.breaks.back();
  const std::size_t n = f.pieces.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (f.breaks[k] + f.breaks[n - k] != ends) return false;
    const Rational length = f.breaks[k + 1] - f.breaks[k];
    if (f.pieces[k] != compose(f.pieces[n - 1 - k], linear(length, -1))) return false;
  }
  return true;
}

/// The number of derivatives, from order 0 on, that agree at every break (with zero outside), minus 1.
int matching_derivatives(const PiecewisePolynomial& f) {
  int smoothness = WeightFunction::infinitely_smooth;
  for (std::size_t k = 0; k <= f.pieces.size(); ++k) {
    Polynomial left = k > 0 ? compose(f.pieces[k - 1], linear(f.breaks[k] - f.breaks[k - 1], 1)) : Polynomial();
    if (k < f.pieces.size()) left -= f.pieces[k];
    for (int order = 0; order <= left.degree(); ++order) {
      if (left.coefficient(order) == 0) continue;
      smoothness = std::min(smoothness, order - 1);
      break;
    }
  }
  return smoothness;
}

}  // namespace

Interval WeightFunction::support() const {
  if (const auto* cinpact = std::get_if<CinpactWeight>(&shape)) return {centre - cinpact->radius, centre + cinpact->radius};
  const auto& breaks = std::holds_alternative<PiecewisePolynomial>(shape) ? std::get<PiecewisePolynomial>(shape).breaks
                                                                          : std::get<PiecewiseExpression>(shape).breaks;
  return {centre + breaks.front(), centre + breaks.back()};
}

std::optional<Rational> WeightFunction::axis() const {
  if (std::holds_alternative<CinpactWeight>(shape)) return centre;
  const auto* polynomial = std::get_if<PiecewisePolynomial>(&shape);
  if (polynomial && is_mirrored(*polynomial)) return support().midpoint();
  return std::nullopt;
}

std::optional<int> WeightFunction::smoothness() const {
  if (std::holds_alternative<CinpactWeight>(shape)) {
    // For sigma = 0 the exponential is the constant 1 on (-c, c).
    if (std::get<CinpactWeight>(shape).sigma == 0) return std::nullopt;
    return infinitely_smooth;
  }
  const auto* polynomial = std::get_if<PiecewisePolynomial>(&shape);
  if (!polynomial) return std::nullopt;
  return polynomial->global ? infinitely_smooth : matching_derivatives(*polynomial);
}

WeightFunction bspline_weight(int degree) {
  if (degree < 0 || degree > max_spline_degree) {
    throw InputError(fmt::format("the degree of a B-spline is from 0 to {}, not {}", max_spline_degree, degree));
  }
  return {cardinal_spline(degree), 0};
}

WeightFunction polynomial_weight(const Polynomial& polynomial, const Interval& domain, bool global) {
  if (domain.is_point()) throw InputError("the domain of a polynomial is an interval with interior points");
  if (polynomial.is_zero()) throw InputError("the weight function is zero");
  if (polynomial.degree() > max_polynomial_degree) {
    throw LimitError(fmt::format("a polynomial of degree {}, above {}", polynomial.degree(), max_polynomial_degree));
  }
  return {PiecewisePolynomial{.breaks = {domain.lower, domain.upper},
                              .pieces = {compose(polynomial, linear(domain.lower, 1))}, .global = global}, 0};
}

WeightFunction cinpact_weight(const Rational& radius, const Rational& sigma, bool interpolating) {
  if (radius <= 0 || radius > 64) throw InputError(fmt::format("the radius c of a CINPACT function is in (0, 64], not {}", to_string(radius)));
  if (sigma < 0 || sigma > 10000) throw InputError(fmt::format("sigma is in [0, 10000], not {}", to_string(sigma)));
  return {CinpactWeight{radius, sigma, interpolating}, 0};
}

}  // namespace limes
