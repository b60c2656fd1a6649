// Theorem U2 on a region: a missing factor or an expanding word on every leaf.

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"
#include "algebra/polynomial/real_roots.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/expanding_word.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <fmt/format.h>

#include <map>

namespace limes {
namespace {

/// Words below this floating radius are not tested exactly; the margin covers the hint's error at radius 1.
constexpr double hint_threshold = 0.995;

/// At one parameter value (or for a scheme without parameters).
ProofAttempt prove_at_point(const Mask& mask, int m, const Box& region, const ProofLimits& limits, const Stop& stop) {
  ProofAttempt attempt;
  const std::vector<Rational> point = midpoint(region);
  const Mask scheme = at(mask, point);
  attempt.stability = prove_stability(scheme);
  if (!attempt.stability) {
    attempt.reason = "the stability of the integer shifts is not proved";
    return attempt;
  }
  const std::optional<LaurentPolynomial> b = difference_symbol(scheme, m + 1);
  if (!b) {
    attempt.leaves.push_back({region, MissingFactorWitness{}});
    attempt.proved = true;
    return attempt;
  }
  const FiniteSections sections(*b, scheme.arity);
  int tested = 0;
  for (const WordHint& hint : approx_expanding_words(sections, {}, limits.max_word_length, hint_threshold, limits.max_words, stop)) {
    if (++tested > limits.max_exact_words) break;
    stop.check();
    if (!exact_expands(sections, hint.word, {})) continue;
    attempt.leaves.push_back({region, WordWitness{hint.word}});
    attempt.proved = true;
    return attempt;
  }
  attempt.reason = fmt::format("no word of difference sections of length <= {} is proved to have spectral radius >= 1",
                               limits.max_word_length);
  attempt.failing_point = point;
  return attempt;
}

class RegionProver {
 public:
  RegionProver(const Mask& mask, int m, const Box& region, const ProofLimits& limits, const Stop& stop)
      : mask_(mask), m_(m), region_(region), limits_(limits), stop_(stop) {}

  ProofAttempt prove() {
    const auto [scheme, denominator] = restricted(mask_, region_);
    denominator_ = denominator;
    attempt_.stability = prove_stability(scheme);
    if (attempt_.stability != Stability::interpolatory) {
      attempt_.reason = "the stability of the integer shifts is not proved for the whole region";
      return attempt_;
    }
    const LaurentPolynomial remainder = sum_rule_remainder(scheme, m_ + 1);
    for (const RationalFunction& c : remainder.coefficients()) {
      if (!c.is_zero()) remainder_.push_back(c.numerator());
    }
    if (const std::optional<LaurentPolynomial> b = difference_symbol(scheme, m_ + 1)) {
      sections_.emplace(*b, denominator, scheme.arity);
    }
    std::vector<Box> pieces = remainder_.empty() ? std::vector<Box>{region_}
                                                 : cut_at_zeros();
    std::reverse(pieces.begin(), pieces.end());
    for (Box& piece : pieces) tasks_.push_back({std::move(piece), 0});
    while (!tasks_.empty()) {
      stop_.check();
      Task task = std::move(tasks_.back());
      tasks_.pop_back();
      if (!settle(task)) return attempt_;
    }
    attempt_.proved = true;
    return attempt_;
  }

 private:
  struct Task {
    Box box;
    int depth;
  };

  std::vector<Box> cut_at_zeros() const {
    const std::vector<Rational> zeros = common_rational_zeros(remainder_, region_);
    return zeros.empty() ? std::vector<Box>{region_} : cut_at(region_, zeros);
  }

  bool settle(Task& task) {
    if (is_point(task.box)) {
      const ProofAttempt at_point = prove_at_point(mask_, m_, task.box, limits_, stop_);
      if (at_point.proved && at_point.stability == attempt_.stability) {
        attempt_.leaves.push_back(at_point.leaves.front());
        return true;
      }
      return fail(at_point.reason, midpoint(task.box));
    }
    const std::vector<Rational> center = midpoint(task.box);
    denominator_sign_ = BernsteinForm(denominator_, task.box).strict_sign_off_open_faces();
    if (denominator_sign_ != 0 && !remainder_.empty()) {
      if (factor_is_missing(task.box)) {
        attempt_.leaves.push_back({task.box, MissingFactorWitness{}});
        return true;
      }
    } else if (denominator_sign_ != 0) {
      const std::optional<std::vector<int>> word = expanding_word(task.box, center);
      if (word) {
        attempt_.leaves.push_back({task.box, WordWitness{*word}});
        return true;
      }
      if (!any_hint_) {
        return fail(fmt::format("no word of difference sections of length <= {} seems to have spectral radius >= 1",
                                limits_.max_word_length), center);
      }
    }
    const int axis = widest_axis(task.box, region_);
    if (axis < 0 || task.depth == limits_.max_depth ||
        static_cast<int>(attempt_.leaves.size() + tasks_.size()) >= limits_.max_leaves) {
      return fail("the signs are not decided by bisection", center);
    }
    auto [lower, upper] = bisect(task.box, axis);
    tasks_.push_back({std::move(upper), task.depth + 1});
    tasks_.push_back({std::move(lower), task.depth + 1});
    return true;
  }

  bool fail(std::string reason, std::vector<Rational> point) {
    attempt_.reason = std::move(reason);
    attempt_.failing_point = std::move(point);
    return false;
  }

  bool factor_is_missing(const Box& box) const {
    return std::any_of(remainder_.begin(), remainder_.end(), [&](const MultivariatePolynomial& p) {
      return BernsteinForm(p, box).strict_sign_off_open_faces() != 0;
    });
  }

  /// A word whose product has, on the whole box, an eigenvalue >= 1 or <= -1, or a complex pair outside of the circle.
  std::optional<std::vector<int>> expanding_word(const Box& box, const std::vector<Rational>& center) {
    const std::vector<WordHint> hints =
        approx_expanding_words(*sections_, center, limits_.max_word_length, hint_threshold, limits_.max_words / 8, stop_);
    any_hint_ = !hints.empty();
    int tested = 0;
    for (const WordHint& hint : hints) {
      if (++tested > limits_.max_exact_words) break;
      if (!may_be_non_positive(hint.word, box)) continue;
      auto place = signs_.find(hint.word);
      if (place == signs_.end()) place = signs_.emplace(hint.word, expansion_signs(*sections_, hint.word, stop_)).first;
      if (is_non_positive(place->second.at_one, hint.word, box) || is_non_positive(place->second.at_minus_one, hint.word, box)) {
        return hint.word;
      }
    }
    constexpr int max_determinants = 2, max_letters = 40;
    int determinants = 0;
    for (const WordHint& hint : hints) {
      if (static_cast<int>(hint.word.size()) * sections_->size() > max_letters || !expands_at_samples(hint.word, box)) continue;
      if (++determinants > max_determinants) break;
      stop_.check();
      auto place = determinants_.find(hint.word);
      if (place == determinants_.end()) place = determinants_.emplace(hint.word, expansion_determinant(*sections_, hint.word, stop_)).first;
      if (BernsteinForm(place->second, box).upper() <= 0) return hint.word;
    }
    return std::nullopt;
  }

  bool expands_at_samples(const std::vector<int>& word, const Box& box) const {
    const std::vector<std::vector<Rational>> points = sample_points(box);
    return std::all_of(points.begin(), points.end(), [&](const auto& point) { return exact_expands(*sections_, word, point); });
  }

  /// Whether one of the signs is <= 0 at all sample points: numbers are cheaper than polynomials in the parameters.
  bool may_be_non_positive(const std::vector<int>& word, const Box& box) const {
    bool at_one = true;
    bool at_minus_one = true;
    for (const std::vector<Rational>& point : sample_points(box)) {
      const Polynomial chi = characteristic_polynomial(sections_->product(word, point));
      at_one = at_one && chi(1) <= 0;
      at_minus_one = at_minus_one && (chi.degree() % 2 ? -chi(-1) : chi(-1)) <= 0;
      if (!at_one && !at_minus_one) return false;
    }
    return true;
  }

  /// Whether one of expansion_signs() is <= 0 on the box once the denominator is made positive there.
  bool is_non_positive(const MultivariatePolynomial& sign, const std::vector<int>& word, const Box& box) const {
    const bool flipped = denominator_sign_ < 0 && word.size() % 2 == 1 && sections_->size() % 2 == 1;
    const BernsteinForm form(sign, box);
    return flipped ? form.lower() >= 0 : form.upper() <= 0;
  }

  const Mask& mask_;
  int m_;
  const Box& region_;
  const ProofLimits& limits_;
  const Stop& stop_;
  ProofAttempt attempt_;
  std::vector<Task> tasks_;
  std::vector<MultivariatePolynomial> remainder_;
  std::optional<FiniteSections> sections_;
  MultivariatePolynomial denominator_;
  /// On the leaf at hand.
  int denominator_sign_ = 1;
  std::map<std::vector<int>, ExpansionSigns> signs_;
  std::map<std::vector<int>, MultivariatePolynomial> determinants_;
  bool any_hint_ = false;
};

}  // namespace

std::vector<Rational> common_rational_zeros(const std::vector<MultivariatePolynomial>& polynomials, const Box& region) {
  int free_axis = -1;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (region[k].is_point()) continue;
    if (free_axis >= 0) return {};
    free_axis = static_cast<int>(k);
  }
  Polynomial common;
  for (const MultivariatePolynomial& p : polynomials) common = gcd(common, p.univariate(free_axis));
  if (common.degree() < 1) return {};
  std::vector<Rational> zeros;
  for (const RootInterval& root : isolate_real_roots(common, Rational(1) / 1000000)) {
    const Rational candidate = simplest_between(root.lower, root.upper);
    if (common(candidate) == 0 && region[free_axis].contains(candidate)) zeros.push_back(candidate);
  }
  return zeros;
}

std::vector<Box> cut_at(const Box& region, const std::vector<Rational>& values) {
  std::size_t axis = 0;
  while (axis < region.size() && region[axis].is_point()) ++axis;
  std::vector<Box> pieces;
  Interval rest = region[axis];
  const auto add = [&](const Interval& interval) {
    pieces.push_back(region);
    pieces.back()[axis] = interval;
  };
  bool rest_is_empty = false;
  for (const Rational& value : values) {
    if (value > rest.lower) add({rest.lower, value, rest.lower_open, true});
    add(Interval::point(value));
    rest_is_empty = value == rest.upper;
    rest.lower = value;
    rest.lower_open = true;
  }
  if (!rest_is_empty) add(rest);
  return pieces;
}

ProofAttempt prove_not_smooth(const Mask& mask, int m, const Box& region, const ProofLimits& limits, const Stop& stop) {
  if (is_point(region)) return prove_at_point(mask, m, region, limits, stop);
  return RegionProver(mask, m, region, limits, stop).prove();
}

}  // namespace limes
