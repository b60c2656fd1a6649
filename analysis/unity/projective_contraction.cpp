#include "analysis/unity/projective_contraction.hpp"

#include <cmath>

namespace limes {
namespace {

/// A multiple of 2^-24 near x.
Rational dyadic(double x) { return Rational(std::round(std::ldexp(x, 24))) / power(Rational(2), 24); }

/// Shares are integers times this: short numbers in long sums.
const Integer share_unit = Integer(1) << 64;

/// The greatest integer not above x share_unit.
Integer rounded_down(const Rational& x) {
  Integer quotient = numerator(x) * share_unit / denominator(x);
  if (x < 0 && quotient * denominator(x) != numerator(x) * share_unit) --quotient;
  return quotient;
}

/// The numbers times a common factor that makes them integers: neither cone nor points change when masks or boxes are scaled.
void scale_to_integers(std::span<std::vector<Rational>* const> lists) {
  Integer common = 1;
  for (const auto* list : lists) {
    for (const Rational& x : *list) common = lcm(common, denominator(x));
  }
  for (auto* list : lists) {
    for (Rational& x : *list) x *= Rational(common);
  }
}

/// Checks the products of all words of one length.
class ContractionTest {
 public:
  ContractionTest(std::vector<Rational> mask, const WeightCone& cone, int level, const Stop& stop)
      : n_(static_cast<int>(mask.size()) - 1), cone_(cone), level_(level), stop_(stop) {
    std::vector<Rational>* const whole_mask[] = {&mask};
    scale_to_integers(whole_mask);
    std::vector<Rational>* const whole_cone[] = {&cone_.lower, &cone_.upper};
    scale_to_integers(whole_cone);
    for (const int e : {0, 1}) sections_[e] = mask_section(mask, e);
  }

  bool run(const RationalMatrix& product, int length) {
    stop_.check();
    if (!keeps_weights_positive(product)) return false;
    if (length == level_) return maps_cone_inside(product) && contracts(product);
    return run(sections_[0] * product, length + 1) && run(sections_[1] * product, length + 1);
  }

  Rational factor() const { return 1 - Rational(least_overlap_) / Rational(share_unit); }
  Rational norm() const { return 1 + 2 * Rational(most_negative_) / Rational(share_unit); }

 private:
  const Rational& worst(const Rational& coefficient, int k) const { return coefficient > 0 ? cone_.lower[k] : cone_.upper[k]; }

  bool keeps_weights_positive(const RationalMatrix& m) const {
    for (int i = 0; i < n_; ++i) {
      Rational least;
      for (int k = 0; k < n_; ++k) least += m(i, k) * worst(m(i, k), k);
      if (least <= 0) return false;
    }
    return true;
  }

  /// lower_j (m z)_i < upper_i (m z)_j for all z of the box.
  bool maps_cone_inside(const RationalMatrix& m) const {
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) {
        Rational least;
        for (int k = 0; k < n_ && i != j; ++k) {
          const Rational g = cone_.upper[i] * m(j, k) - cone_.lower[j] * m(i, k);
          least += g * worst(g, k);
        }
        if (i != j && least <= 0) return false;
      }
    }
    return true;
  }

  /// A lower bound of m_ij z_j / (m z)_i on the box, on which (m z)_i > 0.
  Rational least_share(const RationalMatrix& m, int i, int j) const {
    const Rational& entry = m(i, j);
    if (entry == 0) return 0;
    Rational rest;  // of (m z)_i without the j-th term: great for a positive entry, small for a negative one
    for (int k = 0; k < n_; ++k) {
      if (k == j) continue;
      const bool upper = (m(i, k) > 0) == (entry > 0);
      rest += m(i, k) * (upper ? cone_.upper[k] : cone_.lower[k]);
    }
    const Rational at_lower = entry * cone_.lower[j], at_upper = entry * cone_.upper[j];
    return std::min(at_lower / (at_lower + rest), at_upper / (at_upper + rest));
  }

  bool contracts(const RationalMatrix& m) {
    std::vector<std::vector<Integer>> share(n_, std::vector<Integer>(n_));
    for (int i = 0; i < n_; ++i) {
      Integer negative = 0;
      for (int j = 0; j < n_; ++j) {
        share[i][j] = rounded_down(least_share(m, i, j));
        if (share[i][j] < 0) negative -= share[i][j];
      }
      most_negative_ = std::max(most_negative_, negative);
    }
    for (int i = 0; i < n_; ++i) {
      for (int other = 0; other < i; ++other) {
        Integer overlap = 0;
        for (int j = 0; j < n_; ++j) overlap += std::min(share[i][j], share[other][j]);
        if (overlap <= 0) return false;
        least_overlap_ = std::min(least_overlap_, overlap);
      }
    }
    return true;
  }

  int n_;
  WeightCone cone_;
  int level_;
  const Stop& stop_;
  RationalMatrix sections_[2];
  Integer least_overlap_ = share_unit, most_negative_ = 0;
};

using Doubles = std::vector<double>;

Doubles approx_image(const std::vector<double>& mask, int e, const Doubles& weights) {
  const int n = static_cast<int>(weights.size());
  Doubles image(weights.size());
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int k = e + 2 * j - i;
      if (k >= 0 && k <= n) image[i] += mask[k] * weights[j];
    }
    sum += image[i];
  }
  for (double& x : image) x *= n / sum;
  return image;
}

/// The least box that contains the windows of weights, scaled to mean 1, that the ones lead to in a few steps.
std::pair<Doubles, Doubles> approx_attractor(const Doubles& mask) {
  constexpr int steps = 9;
  const std::size_t n = mask.size() - 1;
  std::vector<Doubles> current{Doubles(n, 1.0)};
  Doubles lower(n, 1.0), upper(n, 1.0);
  for (int step = 0; step < steps; ++step) {
    std::vector<Doubles> next;
    for (const Doubles& weights : current) {
      for (const int e : {0, 1}) next.push_back(approx_image(mask, e, weights));
      for (auto image = next.end() - 2; image != next.end(); ++image) {
        for (std::size_t k = 0; k < n; ++k) {
          lower[k] = std::min(lower[k], (*image)[k]);
          upper[k] = std::max(upper[k], (*image)[k]);
        }
      }
    }
    current = std::move(next);
  }
  return {lower, upper};
}

}  // namespace

RationalMatrix mask_section(const std::vector<Rational>& mask, int e) {
  const int n = static_cast<int>(mask.size()) - 1;
  RationalMatrix section(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int k = e + 2 * j - i;
      if (k >= 0 && k <= n) section(i, j) = mask[k];
    }
  }
  return section;
}

RationalMatrix word_product(const std::vector<Rational>& mask, const std::vector<int>& word) {
  const RationalMatrix sections[2] = {mask_section(mask, 0), mask_section(mask, 1)};
  RationalMatrix product = RationalMatrix::identity(static_cast<int>(mask.size()) - 1);
  for (const int e : word) product = sections[e] * product;
  return product;
}

std::optional<ProjectiveContraction> exact_contraction(const std::vector<Rational>& mask, const WeightCone& cone, int level, const Stop& stop) {
  const Rational greatest_lower = *std::max_element(cone.lower.begin(), cone.lower.end());
  if (greatest_lower > *std::min_element(cone.upper.begin(), cone.upper.end())) return std::nullopt;
  for (std::size_t k = 0; k < cone.lower.size(); ++k) {
    if (cone.lower[k] <= 0 || cone.lower[k] >= cone.upper[k]) return std::nullopt;
  }
  ContractionTest test(mask, cone, level, stop);
  if (!test.run(RationalMatrix::identity(static_cast<int>(mask.size()) - 1), 0)) return std::nullopt;
  return ProjectiveContraction{cone, level, test.factor(), test.norm()};
}

std::optional<ProjectiveContraction> find_projective_contraction(const std::vector<Rational>& mask, int first_level, int max_level,
                                                                 const Stop& stop) {
  Doubles doubles;
  for (const Rational& a : mask) doubles.push_back(approx_double(a));
  const auto [lower, upper] = approx_attractor(doubles);
  for (std::size_t k = 0; k < lower.size(); ++k) {
    if (!(lower[k] > 0) || !std::isfinite(upper[k])) return std::nullopt;
  }
  for (int level = first_level; level <= max_level; ++level) {
    for (const double inflation : {0.02, 0.1, 0.3}) {
      WeightCone cone;
      for (std::size_t k = 0; k < lower.size(); ++k) {
        const double middle = std::sqrt(lower[k] * upper[k]);
        const double ratio = std::exp((std::log(upper[k] / lower[k]) / 2 + 1e-9) * (1 + inflation) + 0.01 * inflation);
        cone.lower.push_back(dyadic(middle / ratio));
        cone.upper.push_back(dyadic(middle * ratio));
      }
      if (auto found = exact_contraction(mask, cone, level, stop)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace limes
