#include "analysis/nonstationary/asymptotic_bound.hpp"

#include "algebra/number/elementary.hpp"
#include "algebra/polynomial/bernstein_form.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

/// c_i(mu) - c_i(1) = (mu - 1)^r h_i / D for the coefficients c_i = A_i / D of a symbol, by index.
struct Differences {
  int lowest = 0;
  int r = 0;
  std::vector<MultivariatePolynomial> h;
  MultivariatePolynomial denominator;
};

MultivariatePolynomial mu_minus_one() {
  return MultivariatePolynomial::variable(1, 0) - MultivariatePolynomial::constant(1, 1);
}

/// \param enough the r to take when no coefficient depends on mu
Differences differences(const LaurentPolynomial& symbol, int enough) {
  const CommonDenominator common = over_common_denominator(symbol);
  const std::array<Rational, 1> one{1};
  const Rational d = common.denominator(one);
  Differences result{symbol.lowest(), 0, {}, common.denominator};
  bool all_zero = true;
  for (const MultivariatePolynomial& a : common.numerators) {
    result.h.push_back(a - (a(one) / d) * common.denominator);
    all_zero = all_zero && result.h.back().is_zero();
  }
  for (const MultivariatePolynomial factor = mu_minus_one(); all_zero ? result.r < enough : true; ++result.r) {
    std::vector<MultivariatePolynomial> quotients;
    for (const MultivariatePolynomial& h : result.h) {
      const auto quotient = exact_quotient(h, factor);
      if (!quotient) return result;
      quotients.push_back(*quotient);
    }
    result.h = std::move(quotients);
  }
  return result;
}

/// The greatest sum of |h_i| / D over a residue class of i, bounded on an interval of mu by quotients of Bernstein coefficients.
/// Nothing when D has a coefficient that is not positive.
std::optional<Rational> row_bound(const Differences& differences, int arity, const Interval& mu) {
  int degree = differences.denominator.degree(0);
  for (const MultivariatePolynomial& h : differences.h) degree = std::max(degree, h.degree(0));
  const std::vector<int> degrees{std::max(degree, 0)};
  const BernsteinForm denominator(differences.denominator, {mu}, degrees);
  if (denominator.strict_sign() <= 0) return std::nullopt;
  const std::size_t size = denominator.coefficients().size();
  std::vector<std::vector<Rational>> sums(static_cast<std::size_t>(arity), std::vector<Rational>(size));
  for (std::size_t i = 0; i < differences.h.size(); ++i) {
    const BernsteinForm h(differences.h[i], {mu}, degrees);
    std::vector<Rational>& sum = sums[i % static_cast<std::size_t>(arity)];
    for (std::size_t k = 0; k < size; ++k) sum[k] += abs(h.coefficients()[k]);
  }
  Rational bound = 0;
  for (const std::vector<Rational>& sum : sums) {
    for (std::size_t k = 0; k < size; ++k) bound = std::max(bound, sum[k] / denominator.coefficients()[k]);
  }
  return bound;
}

/// The least decimal with six digits above a bound and a little more: the checker's intervals are not ours.
Rational rounded_up(const Rational& bound) {
  const Rational scale(1000000);
  const Rational larger = bound * scale * (scale + 1) / scale;
  return (Rational(numerator(larger) / denominator(larger)) + 1) / scale;
}

}  // namespace

AsymptoticAttempt bound_difference_to_limit(const MaskSequence& sequence, AngleType type, const Interval& angles,
                                            int smoothness) {
  AsymptoticAttempt attempt;
  const std::optional<int> first = uniform_level(sequence, type, angles);
  if (!first) {
    attempt.reason = "a mask may have a pole at some angle";
    return attempt;
  }
  const int arity = sequence.mask.arity;
  LaurentPolynomial c = sequence.mask.symbol;
  for (int j = 0; j <= smoothness; ++j) {
    const Differences difference = differences(c, smoothness - j + 1);
    if (2 * difference.r > smoothness - j) {
      // Near the first level the bound may be large where a denominator is small: later levels serve as well.
      constexpr int max_later = 8;
      std::optional<AsymptoticBound> best;
      for (int k = *first; k <= *first + max_later; ++k) {
        const Interval mu = tail_range(arity, type, angles, k);
        const std::optional<Rational> rows = row_bound(difference, arity, mu);
        if (!rows) continue;
        const Rational growth = type == AngleType::hyperbolic ? mu.upper : Rational(1);
        const Rational constant = rounded_up(*rows * power(growth / 2, difference.r));
        if (best && constant * 2 > best->constant) break;
        best = AsymptoticBound{k, j, 2 * difference.r, constant};
      }
      attempt.bound = best;
      if (!best) attempt.reason = "the difference of the masks from their limit is not bounded";
      return attempt;
    }
    attempt.reason =
        fmt::format("the masks tend to their limit like x^{}{}, too slowly for C{}", 2 * difference.r,
                    j == 0 ? "" : fmt::format(" after division by {} factors of smoothing", j), smoothness);
    auto [quotient, remainder] = divide(c, sigma(1, arity));
    if (!remainder.is_zero()) return attempt;
    c = RationalFunction::constant(1, arity) * quotient;
  }
  return attempt;
}

}  // namespace limes
