#include "analysis/unity/filter_norms.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/polynomial.hpp"
#include "algebra/polynomial/real_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes {
namespace {

/// Below x by at most 2^-bits |x|, with a short denominator.
Rational rounded_down(const Rational& x, int bits) {
  if (x == 0) return 0;
  const int exponent = bits + int(msb(denominator(x))) - int(msb(Integer(abs(numerator(x)))));
  const Rational scaled = x * power(Rational(2), exponent);
  Integer quotient = numerator(scaled) / denominator(scaled);
  if (Rational(quotient) > scaled) --quotient;
  return Rational(quotient) * power(Rational(2), -exponent);
}

Rational rounded_up(const Rational& x, int bits) { return -rounded_down(-x, bits); }

/// G(x) = c_0 + sum_d c_d T_d(x) on [-1, 1] with short coefficients, which differ from the true G by at most `error`.
class Symbol {
 public:
  explicit Symbol(const std::vector<Rational>& filter) {
    std::vector<Rational> exact;
    for (std::size_t lag = 0; 2 * lag < filter.size(); ++lag) {
      Rational sum = 0;
      for (std::size_t i = 0; i + 2 * lag < filter.size(); ++i) sum += filter[i] * filter[i + 2 * lag];
      exact.push_back(lag == 0 ? sum : 2 * sum);
    }
    if (exact.empty() || exact[0] == 0) throw DomainError("a filter that is 0 has no singular values");
    const Rational unit = exact[0] * power(Rational(2), -160);
    error_ = 0;
    for (const Rational& c : exact) {
      coefficients_.push_back(c == 0 || abs(c) <= unit ? Rational(0) : rounded_down(c, 160));
      error_ += abs(c - coefficients_.back());
      approx_.push_back(approx_double(c));
    }
    error_ = rounded_up(error_, 8);
    Polynomial before, current = Polynomial::constant(1);
    const Polynomial x = Polynomial::monomial(1, 1);
    for (std::size_t d = 0; d < coefficients_.size(); ++d) {
      polynomial_ += coefficients_[d] * current;
      Polynomial next = Rational(d == 0 ? 1 : 2) * (x * current) - before;
      before = std::move(current);
      current = std::move(next);
    }
  }

  ExtremeValue extreme(int sign) const {
    const double omega = approx_extreme_frequency(sign);
    const Rational witness = std::clamp(Rational(std::cos(omega)), Rational(-1), Rational(1));
    const Rational value = polynomial_(witness);
    Rational gap = std::max(abs(value) * power(Rational(2), -44), 4 * error_);
    for (int attempt = 0; attempt < 40; ++attempt, gap *= 8) {
      const Rational outer = sign > 0 ? rounded_up(value + gap, 60) : rounded_down(value - gap, 60);
      const Polynomial difference =
          Rational(sign) * (Polynomial::constant(outer) - polynomial_) - Polynomial::constant(error_);
      if (difference(-1) <= 0 || difference(1) <= 0 || count_real_roots(difference, -1, 1) != 0) continue;
      if (sign > 0) return {{rounded_down(value - error_, 60), outer}, witness};
      return {{outer, rounded_up(value + error_, 60)}, witness};
    }
    throw InternalError("a trigonometric polynomial without bounds");
  }

 private:
  double approx_value(double omega) const {
    double sum = 0;
    for (std::size_t d = 0; d < approx_.size(); ++d) sum += approx_[d] * std::cos(static_cast<double>(d) * omega);
    return sum;
  }

  /// The best of a fine grid, refined by golden sections.
  double approx_extreme_frequency(int sign) const {
    const int samples = 64 * static_cast<int>(approx_.size());
    const double step = std::numbers::pi / samples;
    int best = 0;
    for (int i = 1; i <= samples; ++i) {
      if (sign * approx_value(i * step) > sign * approx_value(best * step)) best = i;
    }
    double low = std::max(0.0, (best - 1) * step), high = std::min(std::numbers::pi, (best + 1) * step);
    constexpr double ratio = 0.6180339887498949;
    for (int i = 0; i < 60; ++i) {
      const double left = high - ratio * (high - low), right = low + ratio * (high - low);
      (sign * approx_value(left) > sign * approx_value(right) ? high : low) =
          sign * approx_value(left) > sign * approx_value(right) ? right : left;
    }
    const double inside = (low + high) / 2;
    return sign * approx_value(inside) > sign * approx_value(best * step) ? inside : best * step;
  }

  std::vector<Rational> coefficients_;
  std::vector<double> approx_;
  Rational error_;
  Polynomial polynomial_;
};

}  // namespace

SquaredSingularValues squared_singular_values(const std::vector<Rational>& filter) {
  const Symbol symbol(filter);
  return {symbol.extreme(-1), symbol.extreme(1)};
}

RationalBounds sqrt_bounds(const Rational& x) {
  if (x < 0) throw DomainError("the square root of a negative number");
  if (x == 0) return {0, 0};
  // floor(sqrt(x 4^k)) has more than 62 bits.
  const int k = std::max(0, 64 + (int(msb(denominator(x))) - int(msb(numerator(x)))) / 2);
  const Rational scaled = x * power(Rational(4), k);
  const Integer root = sqrt(Integer(numerator(scaled) / denominator(scaled)));
  const Rational unit = power(Rational(2), -k);
  return {Rational(root) * unit, Rational(root * root) == scaled ? Rational(root) * unit : Rational(root + 1) * unit};
}

RationalBounds sqrt_bounds(const RationalBounds& x) { return {sqrt_bounds(x.lower).lower, sqrt_bounds(x.upper).upper}; }

}  // namespace limes
