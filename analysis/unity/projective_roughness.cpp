#include "analysis/unity/projective_roughness.hpp"

#include "algebra/matrix/exact_solve.hpp"
#include "analysis/eigen_impl.hpp"

#include <Eigen/LU>

#include <cmath>

namespace limes {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

std::vector<Matrix> approx_sections(const std::vector<Rational>& mask) {
  std::vector<Matrix> sections;
  for (const int e : {0, 1}) sections.push_back(approx_matrix(mask_section(mask, e)));
  return sections;
}

Matrix approx_word_product(const std::vector<Matrix>& sections, const std::vector<int>& word) {
  Matrix product = Matrix::Identity(sections[0].rows(), sections[0].cols());
  for (const int e : word) product = sections[e] * product;
  return product;
}

std::vector<int> letters(unsigned bits, int length) {
  std::vector<int> word;
  for (int k = length; k-- > 0;) word.push_back(static_cast<int>(bits >> k & 1));
  return word;
}

/// Whether the word is the least of its rotations and no power.
bool is_primitive_necklace(const std::vector<int>& word) {
  std::vector<int> rotated = word;
  for (std::size_t k = 1; k < word.size(); ++k) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    if (rotated <= word) return false;
  }
  return true;
}

Vector normalised(Vector v) {
  Eigen::Index greatest = 0;
  v.cwiseAbs().maxCoeff(&greatest);
  return v / v(greatest);
}

struct Candidate {
  double ratio = 0;
  std::vector<int> word;
  double dominant = 0, second = 0;
  Vector dominant_vector, second_vector;
};

/// The word's real eigenvalues with 2^-k < |lambda / lambda_1| < 1, simple by a margin.
void append_candidates(const std::vector<Matrix>& sections, const std::vector<int>& word, std::vector<Candidate>& candidates) {
  const auto [values, vectors] = approx_eigenpairs(approx_word_product(sections, word));
  std::vector<Eigen::Index> order(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::abs(values(a)) > std::abs(values(b)); });
  const double first = values(order[0]).real(), length = static_cast<double>(word.size());
  if (values(order[0]).imag() != 0 || first <= 0) return;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const auto value = values(order[k]);
    const double ratio = std::pow(std::abs(value) / first, 1 / length);
    if (ratio < 0.5 * (1 + 1e-8)) return;
    if (value.imag() != 0 || std::abs(value) > first * (1 - 1e-6)) continue;
    bool simple = true;
    for (std::size_t j = 0; j < order.size(); ++j) simple = simple && (j == k || std::abs(values(order[j]) - value) > 1e-6 * first);
    if (!simple) continue;
    candidates.push_back({ratio, word, first, value.real(), normalised(vectors.col(order[0]).real()),
                          normalised(vectors.col(order[k]).real())});
  }
}

/// A window of up to max_length letters in which the limit of x / y keeps away from zero, the one with the best margin of the
/// shortest length that has one.
std::optional<std::vector<int>> approx_visible_window(const std::vector<Matrix>& sections, const Candidate& candidate,
                                                      const ProjectiveContraction& contraction, int max_length, const Stop& stop) {
  const double reach = approx_double(contraction.norm / (2 * (1 - contraction.factor)));
  for (int length = 0; length <= max_length; length += contraction.level) {
    double best = 1.001;
    std::optional<std::vector<int>> window;
    for (unsigned bits = 0; bits < 1u << length; ++bits) {
      if (bits % 256 == 0) stop.check();
      const std::vector<int> word = letters(bits, length);
      Vector x = candidate.second_vector, y = candidate.dominant_vector;
      for (const int e : word) {
        x = sections[e] * x;
        y = sections[e] * y;
      }
      const Vector points = x.cwiseQuotient(y);
      const double least = points.minCoeff(), greatest = points.maxCoeff();
      const double spread = reach * (greatest - least), middle = std::abs(least + greatest) / 2;
      if (const double margin = middle / (spread + 1e-300); margin > best) {
        best = margin;
        window = word;
      }
    }
    if (window) return window;
  }
  return std::nullopt;
}

/// x rounded to a multiple of 10^-30.
Rational rounded(const Rational& x) {
  const Integer unit = numerator(power(Rational(10), 30));
  return Rational(Integer(numerator(x) * unit / denominator(x))) / Rational(unit);
}

/// Newton's method for A v = lambda v with one component of v fixed to 1; nothing when it does not settle.
std::optional<ApproxEigenpair> refined_eigenpair(const RationalMatrix& matrix, double value, const Vector& vector) {
  const int n = matrix.rows();
  ApproxEigenpair pair{exact_rational(value), {}};
  int fixed = 0;
  for (int i = 0; i < n; ++i) {
    pair.vector.push_back(exact_rational(vector(i)));
    if (vector(i) == 1) fixed = i;
  }
  for (int step = 0; step < 4; ++step) {
    RationalMatrix jacobian = matrix, residual(n, 1);
    const std::vector<Rational> image = matrix * pair.vector;
    for (int i = 0; i < n; ++i) {
      residual(i, 0) = image[i] - pair.value * pair.vector[i];
      jacobian(i, i) -= pair.value;
      jacobian(i, fixed) = -pair.vector[i];
    }
    const auto correction = exact_solve(jacobian, residual);
    if (!correction) return std::nullopt;
    for (int i = 0; i < n; ++i) {
      Rational& unknown = i == fixed ? pair.value : pair.vector[i];
      unknown = rounded(unknown - (*correction)(i, 0));
    }
  }
  return pair;
}

bool changes_sign_at(const Polynomial& chi, const Rational& value) {
  const Rational radius = power(Rational(10), -20);
  return chi(value - radius) * chi(value + radius) < 0;
}

}  // namespace

std::optional<ProjectiveRoughness> find_projective_roughness(const std::vector<Rational>& mask, const ProjectiveContraction& contraction,
                                                             int max_length, int max_level, const Stop& stop) {
  constexpr std::size_t max_candidates = 24;
  constexpr int window_letters = 12;
  const std::vector<Matrix> sections = approx_sections(mask);
  std::vector<Candidate> candidates;
  for (int length = 1; length <= max_length; ++length) {
    stop.check();
    for (unsigned bits = 0; bits < 1u << length; ++bits) {
      const std::vector<int> word = letters(bits, length);
      if (is_primitive_necklace(word)) append_candidates(sections, word, candidates);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.ratio > b.ratio; });
  if (candidates.size() > max_candidates) candidates.resize(max_candidates);
  // A longer level contracts more, so that the limit is better known from the points of a window.
  std::optional<ProjectiveContraction> stronger = contraction;
  while (stronger) {
    for (const Candidate& candidate : candidates) {
      const auto window = approx_visible_window(sections, candidate, *stronger, window_letters, stop);
      if (!window) continue;
      const RationalMatrix product = word_product(mask, candidate.word);
      const auto dominant = refined_eigenpair(product, candidate.dominant, candidate.dominant_vector);
      const auto second = refined_eigenpair(product, candidate.second, candidate.second_vector);
      if (!dominant || !second) continue;
      const Rational scale = power(Rational(2), static_cast<int>(candidate.word.size()));
      if (abs(second->value) * scale <= dominant->value || abs(second->value) >= dominant->value) continue;
      const Polynomial chi = characteristic_polynomial(product);
      if (!changes_sign_at(chi, dominant->value) || !changes_sign_at(chi, second->value)) continue;
      return ProjectiveRoughness{*stronger, candidate.word, *dominant, *second, *window};
    }
    if (stronger->level >= max_level) break;
    stronger = find_projective_contraction(mask, stronger->level + 1, max_level, stop);
  }
  return std::nullopt;
}

std::optional<std::vector<int>> find_growing_word(const std::vector<Rational>& mask, int max_length, const Stop& stop) {
  const std::vector<Matrix> sections = approx_sections(mask);
  const Eigen::Index n = sections[0].rows();
  for (int length = 1; length <= max_length; ++length) {
    stop.check();
    for (unsigned bits = 0; bits < 1u << length; ++bits) {
      const std::vector<int> word = letters(bits, length);
      if (!is_primitive_necklace(word) || (Matrix::Identity(n, n) - approx_word_product(sections, word)).determinant() > 1e-12) continue;
      if (characteristic_polynomial(word_product(mask, word))(1) <= 0) return word;
    }
  }
  return std::nullopt;
}

}  // namespace limes
