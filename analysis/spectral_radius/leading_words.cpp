#include "analysis/spectral_radius/leading_words.hpp"

#include "analysis/eigen_impl.hpp"

#include <cmath>

namespace limes {
namespace {

/// A prefix with its product divided by radius^length for the best radius known when it was made.
struct Prefix {
  Word word;
  Eigen::MatrixXd product;
  double norm = 0;
};

/// rho(a) <= ||a^8||^{1/8}: a few products cost much less than eigenvalues.
bool is_surely_less(const Eigen::MatrixXd& a, double bound) {
  constexpr int squarings = 3;
  Eigen::MatrixXd power = a / bound;
  for (int k = 0; k < squarings; ++k) {
    if (power.squaredNorm() < 1) return true;
    power *= power;
  }
  return power.squaredNorm() < 1;
}

/// The shortest w with word = w w ... w, in its least rotation.
Word primitive_root(const Word& word) {
  const std::size_t k = word.size();
  std::size_t period = 1;
  const auto repeats = [&](std::size_t p) {
    for (std::size_t i = 0; i < k; ++i) {
      if (word[i] != word[i % p]) return false;
    }
    return true;
  };
  while (k % period != 0 || !repeats(period)) ++period;
  Word best(word.begin(), word.begin() + std::ptrdiff_t(period)), rotated = best;
  for (std::size_t shift = 1; shift < period; ++shift) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    best = std::min(best, rotated);
  }
  return best;
}

}  // namespace

std::vector<LeadingWord> approx_leading_words(const MatrixFamily& family, const LeadingWordLimits& limits, double tolerance,
                                              const Stop& stop) {
  const int n = family_size(family);
  std::vector<Eigen::MatrixXd> matrices;
  for (const RationalMatrix& b : family) matrices.push_back(approx_matrix(b));

  std::map<Word, double> found;  // by primitive root: rotations and powers have the same averaged radius
  double best = 0;
  // Norms are compared at unit scale; with all norms tiny or huge the products would leave the range of double.
  double scale = 0;
  for (const Eigen::MatrixXd& b : matrices) scale = std::max(scale, b.norm());
  if (scale == 0 || !std::isfinite(scale)) return {{{0}, 0}};
  for (Eigen::MatrixXd& b : matrices) b /= scale;

  std::vector<Prefix> prefixes{{{}, Eigen::MatrixXd::Identity(n, n), 1}};
  for (int length = 1; length <= limits.max_length && !prefixes.empty(); ++length) {
    stop.check();
    std::vector<Prefix> next;
    for (const Prefix& prefix : prefixes) {
      for (std::size_t e = 0; e < matrices.size(); ++e) {
        Prefix longer{prefix.word, prefix.product * matrices[e], 0};
        longer.word.push_back(int(e));
        longer.norm = longer.product.norm();
        if (std::pow(longer.norm, 1.0 / length) < best * (1 - tolerance)) continue;
        // What is surely less than the best so far stays out of the map: the tests are not worth remembering.
        if (best == 0 || !is_surely_less(longer.product, std::pow(best * (1 - tolerance), length))) {
          const auto [entry, is_new] = found.try_emplace(primitive_root(longer.word), 0);
          if (is_new && longer.product.allFinite()) entry->second = std::pow(approx_spectral_radius(longer.product), 1.0 / length);
          best = std::max(best, entry->second);
        }
        next.push_back(std::move(longer));
      }
    }
    std::stable_sort(next.begin(), next.end(), [](const Prefix& a, const Prefix& b) { return a.norm > b.norm; });
    if (next.size() > std::size_t(limits.width)) next.resize(std::size_t(limits.width));
    prefixes = std::move(next);
  }
  std::vector<LeadingWord> result;
  for (const auto& [word, radius] : found) {
    if (radius > 0 && radius >= best * (1 - tolerance)) result.push_back({word, radius * scale});
  }
  if (result.empty()) return {{{0}, 0}};
  // Rounding errors do not choose between equal radii: among those within the tolerance the shortest is first.
  std::stable_sort(result.begin(), result.end(),
                   [](const LeadingWord& a, const LeadingWord& b) { return a.word.size() < b.word.size(); });
  return result;
}

}  // namespace limes
