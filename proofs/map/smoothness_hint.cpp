#include "proofs/map/smoothness_hint.hpp"

#include "algebra/error.hpp"
#include "analysis/approx_radius.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/expanding_word.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <cmath>
#include <limits>

namespace limes {
namespace {

constexpr int max_word_length = 10;
constexpr std::size_t max_words = 1000;
constexpr std::size_t worst_count = 6;

std::vector<Rational> sample_ratios() {
  std::vector<Rational> ratios;
  for (int k = 1; k <= 16; ++k) ratios.push_back(Rational(k) / 16);
  for (int k = 5; k <= 24; k += k < 12 ? 1 : 4) ratios.push_back(power(Rational(2), -k));
  return ratios;
}

/// The factors as gamma tends to 0, without those roots +-rho that they have there for all parameter values: how such roots move for
/// small gamma the ratios above show.
std::vector<LambdaPolynomial> limits_at_zero(const SplitCharacteristicPolynomial& split) {
  std::vector<LambdaPolynomial> limits;
  const Rational rho = power(Rational(2), -split.smoothness);
  for (const auto* factors : {&split.ell, &split.r}) {
    for (const CharacteristicFactor& factor : *factors) {
      const int variables = factor.polynomial.variables();
      LambdaPolynomial limit = factor.polynomial.substitute(variables - 1, 0);
      if (limit.degree() < factor.polynomial.degree()) continue;
      const auto one = MultivariatePolynomial::constant(variables, 1);
      for (const Rational& root : {rho, Rational(-rho)}) {
        while (const auto quotient = exact_quotient(limit, LambdaPolynomial::linear(one, root * one))) limit = *quotient;
      }
      if (limit.degree() > 0) limits.push_back(std::move(limit));
    }
  }
  return limits;
}

}  // namespace

SmoothnessHint::SmoothnessHint(const Scheme& scheme, int m, const Stop& stop) : mask_(scheme.mask), m_(m), stop_(stop) {
  if (const std::optional<LaurentPolynomial> b = difference_symbol(mask_, m + 1); b && !b->is_zero()) sections_.emplace(*b, mask_.arity);
  if (!scheme.insertion_rule) return;
  split_ = split_characteristic_polynomial(SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*scheme.insertion_rule, {})), m,
                                           stop);
  limits_at_zero_ = limits_at_zero(*split_);
}

double SmoothnessHint::approx_growth(const std::vector<Rational>& point) const {
  return std::max(growth_along(worst_words(point), point), growth_at_ratios(point));
}

double SmoothnessHint::approx_crossing(const std::vector<Rational>& from, const std::vector<Rational>& to) const {
  Words words = worst_words(from);
  for (auto& word : worst_words(to)) words.push_back(std::move(word));
  const auto growth = [&](const Rational& t) {
    std::vector<Rational> point;
    for (std::size_t k = 0; k < from.size(); ++k) point.push_back(from[k] + t * (to[k] - from[k]));
    return std::max(growth_along(words, point), growth_at_ratios(point));
  };
  const bool rough_from = growth(0) > 1;
  Rational low = 0;
  Rational high = 1;
  for (int k = 0; k < 46; ++k) {
    stop_.check();
    const Rational middle = (low + high) / 2;
    ((growth(middle) > 1) == rough_from ? low : high) = middle;
  }
  return approx_double((low + high) / 2);
}

std::vector<Rational> SmoothnessHint::isolated_values(const Box& region) const {
  std::vector<MultivariatePolynomial> remainder;
  const LaurentPolynomial all = sum_rule_remainder(restricted(mask_, region).mask, m_ + 1);
  for (const RationalFunction& c : all.coefficients()) {
    if (!c.is_zero()) remainder.push_back(c.numerator());
  }
  return remainder.empty() ? std::vector<Rational>{} : common_rational_zeros(remainder, region);
}

SmoothnessHint::Words SmoothnessHint::worst_words(const std::vector<Rational>& point) const {
  Words words;
  try {
    std::optional<FiniteSections> own;
    if (!sections_) {
      const std::optional<LaurentPolynomial> b = difference_symbol(at(mask_, point), m_ + 1);
      if (!b || b->is_zero()) return words;
      own.emplace(*b, mask_.arity);
    }
    std::vector<WordHint> hints = own ? approx_expanding_words(*own, {}, max_word_length, 0.5, max_words, stop_)
                                      : approx_expanding_words(*sections_, point, max_word_length, 0.5, max_words, stop_);
    std::stable_sort(hints.begin(), hints.end(), [](const WordHint& a, const WordHint& b) { return a.radius > b.radius; });
    for (std::size_t k = 0; k < std::min(hints.size(), worst_count); ++k) words.push_back(std::move(hints[k].word));
  } catch (const DomainError&) {  // a pole: growth_along() says so
  }
  return words;
}

double SmoothnessHint::growth_along(const Words& words, const std::vector<Rational>& point) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  try {
    std::optional<FiniteSections> own;
    if (!sections_) {
      const Mask mask = at(mask_, point);
      const std::optional<LaurentPolynomial> b = difference_symbol(mask, m_ + 1);
      if (!b) return infinite;
      if (!b->is_zero()) own.emplace(*b, mask_.arity);
    }
    double growth = 0;
    for (const std::vector<int>& word : words) {
      const RationalMatrix product = own ? own->product(word, {}) : sections_->product(word, point);
      growth = std::max(growth, std::pow(approx_spectral_radius(product), 1.0 / static_cast<double>(word.size())));
    }
    return growth;
  } catch (const DomainError&) {
    return infinite;
  }
}

double SmoothnessHint::growth_at_ratios(const std::vector<Rational>& point) const {
  static const std::vector<Rational> ratios = sample_ratios();
  if (!split_ || split_->missing_eigenvalue) return 0;
  double growth = 0;
  std::vector<Rational> with_ratio = point;
  with_ratio.emplace_back();
  for (const auto* factors : {&split_->ell, &split_->r}) {
    for (const CharacteristicFactor& factor : *factors) {
      for (const Rational& gamma : ratios) {
        with_ratio.back() = gamma;
        const Polynomial f = factor.polynomial.at(with_ratio);
        if (!f.is_zero()) growth = std::max(growth, approx_greatest_root(f));
      }
    }
  }
  with_ratio.back() = 0;
  for (const LambdaPolynomial& limit : limits_at_zero_) {
    const Polynomial f = limit.at(with_ratio);
    if (f.degree() == limit.degree()) growth = std::max(growth, approx_greatest_root(f));
  }
  return std::ldexp(growth, m_);
}

}  // namespace limes
