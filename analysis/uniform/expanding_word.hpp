#pragma once

#include "algebra/stop.hpp"
#include "analysis/uniform/finite_sections.hpp"

#include <vector>

namespace limes {

/// A word whose product of sections may have spectral radius >= 1: a floating hint.
struct WordHint {
  std::vector<int> word;
  /// Approximately rho(product)^{1/length}.
  double radius = 0;
};

/// All words of length <= max_length up to rotation and powers whose product at the point seems to have spectral radius at
/// least about `threshold`, the shortest first, then by falling radius; at most `max_words` products are formed.
std::vector<WordHint> approx_expanding_words(const FiniteSections& sections, std::span<const Rational> point, int max_length,
                                             double threshold, std::size_t max_words, const Stop& stop);

/// Whether the product of the word at the point has spectral radius >= 1, decided exactly on its characteristic polynomial.
bool exact_expands(const FiniteSections& sections, const std::vector<int>& word, std::span<const Rational> point);

/// The values chi(1) and (-1)^n chi(-1) of chi(lambda) = det(lambda D^k I - numerators of the word's product), as polynomials in the
/// parameters. Where one of them is <= 0 (and D > 0), the word's product has spectral radius >= 1.
struct ExpansionSigns {
  MultivariatePolynomial at_one;
  MultivariatePolynomial at_minus_one;
};

ExpansionSigns expansion_signs(const FiniteSections& sections, const std::vector<int>& word, const Stop& stop = {});

/// The determinant of the boundary test of chi: where it is <= 0 (and D != 0), the word's product has spectral radius >= 1, as it is
/// D^{k n (n-1)} prod_{i<j} (1 - z_i z_j) for the eigenvalues z_i. It shows complex pairs of eigenvalues. Large: degree k n (n-1) in D.
MultivariatePolynomial expansion_determinant(const FiniteSections& sections, const std::vector<int>& word, const Stop& stop = {});

}  // namespace limes
