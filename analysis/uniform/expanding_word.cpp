#include "analysis/uniform/expanding_word.hpp"

#include "algebra/polynomial/schur_cohn.hpp"
#include "analysis/nonuniform/dominance_test.hpp"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

using DoubleMatrix = std::vector<double>;

DoubleMatrix product(const DoubleMatrix& a, const DoubleMatrix& b, int n) {
  DoubleMatrix c(a.size(), 0);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double x = a[i * n + k];
      if (x == 0) continue;
      for (int j = 0; j < n; ++j) c[i * n + j] += x * b[k * n + j];
    }
  }
  return c;
}

/// ||M^{2^12}||^{2^-12} by repeated squaring with scaling.
double approx_spectral_radius(DoubleMatrix m, int n) {
  double log_scale = 0;
  double weight = 1;
  for (int squaring = 0;; ++squaring) {
    double norm = 0;
    for (const double x : m) norm = std::max(norm, std::abs(x));
    if (norm == 0 || !std::isfinite(norm)) return norm;
    log_scale += weight * std::log(norm);
    if (squaring == 12) return std::exp(log_scale);
    for (double& x : m) x /= norm;
    m = product(m, m, n);
    weight /= 2;
  }
}

/// Whether the word is the least of its rotations and no power of a shorter word (a Lyndon word).
bool is_lyndon(const std::vector<int>& word) {
  for (std::size_t shift = 1; shift < word.size(); ++shift) {
    for (std::size_t k = 0;; ++k) {
      if (k == word.size()) return false;
      const int rotated = word[(k + shift) % word.size()];
      if (rotated == word[k]) continue;
      if (rotated < word[k]) return false;
      break;
    }
  }
  return true;
}

bool next_word(std::vector<int>& word, int letters) {
  for (std::size_t k = word.size(); k-- > 0;) {
    if (++word[k] < letters) return true;
    word[k] = 0;
  }
  return false;
}

}  // namespace

std::vector<WordHint> approx_expanding_words(const FiniteSections& sections, std::span<const Rational> point, int max_length,
                                             double threshold, std::size_t max_words, const Stop& stop) {
  const int n = sections.size();
  std::vector<DoubleMatrix> matrices;
  for (int e = 0; e < sections.arity(); ++e) {
    const RationalMatrix exact = sections.product({e}, point);
    DoubleMatrix m;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) m.push_back(approx_double(exact(i, j)));
    }
    matrices.push_back(std::move(m));
  }
  std::vector<WordHint> hints;
  std::size_t formed = 0;
  for (int length = 1; length <= max_length; ++length) {
    const std::size_t first = hints.size();
    std::vector<int> word(length, 0);
    do {
      if (!is_lyndon(word)) continue;
      if (++formed > max_words) break;
      if (formed % 64 == 0) stop.check();
      DoubleMatrix m = matrices[word[0]];
      for (int k = 1; k < length; ++k) m = product(m, matrices[word[k]], n);
      const double radius = std::pow(approx_spectral_radius(std::move(m), n), 1.0 / length);
      if (radius >= threshold) hints.push_back({word, radius});
    } while (next_word(word, sections.arity()));
    std::stable_sort(hints.begin() + first, hints.end(), [](const WordHint& a, const WordHint& b) { return a.radius > b.radius; });
    if (formed > max_words) break;
  }
  return hints;
}

bool exact_expands(const FiniteSections& sections, const std::vector<int>& word, std::span<const Rational> point) {
  return !roots_inside_circle(characteristic_polynomial(sections.product(word, point)), 1);
}

namespace {

/// The coefficients of chi(lambda) = det(lambda D^k I - numerators of the word's product), n + 1 of them.
std::vector<MultivariatePolynomial> scaled_characteristic_polynomial(const FiniteSections& sections, const std::vector<int>& word, const Stop& stop) {
  const int variables = sections.denominator().variables();
  PolynomialMatrix matrix = PolynomialMatrix::identity(variables, sections.size());
  for (const int e : word) matrix = matrix * sections.numerators(e);
  std::vector<MultivariatePolynomial> chi = characteristic_polynomial(matrix, stop);
  const MultivariatePolynomial d = power(sections.denominator(), static_cast<int>(word.size()));
  MultivariatePolynomial d_power = MultivariatePolynomial::constant(variables, 1);
  for (MultivariatePolynomial& c : chi) {
    c *= d_power;
    d_power *= d;
  }
  return chi;
}

}  // namespace

ExpansionSigns expansion_signs(const FiniteSections& sections, const std::vector<int>& word, const Stop& stop) {
  const int variables = sections.denominator().variables();
  const std::vector<MultivariatePolynomial> chi = scaled_characteristic_polynomial(sections, word, stop);
  ExpansionSigns signs{MultivariatePolynomial(variables), MultivariatePolynomial(variables)};
  for (int k = 0; k <= sections.size(); ++k) {
    signs.at_one += chi[k];
    // (-1)^n (-1)^k: the leading coefficient counts positively.
    if ((sections.size() - k) % 2 == 0) {
      signs.at_minus_one += chi[k];
    } else {
      signs.at_minus_one -= chi[k];
    }
  }
  return signs;
}

MultivariatePolynomial expansion_determinant(const FiniteSections& sections, const std::vector<int>& word, const Stop& stop) {
  return boundary_determinant({sections.denominator().variables(), scaled_characteristic_polynomial(sections, word, stop)}, 1, stop);
}

}  // namespace limes
