#include "proofs/uniform/contraction_prover.hpp"

#include "algebra/error.hpp"
#include "analysis/spectral_radius/leading_words.hpp"
#include "analysis/uniform/section_hull.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

constexpr double enough = 1 - 1e-10;
/// What is nearer to 1 counts as 1.
constexpr double least_gap = 1e-9;

double approx_radius(const MatrixFamily& family, const Stop& stop) {
  return approx_leading_words(family, {10, 40}, 1e-9, stop).front().radius;
}

Box point_box(const std::vector<Rational>& point) {
  Box box;
  for (const Rational& x : point) box.push_back(Interval::point(x));
  return box;
}

}  // namespace

ContractionProver::Attempt ContractionProver::attempt(const Box& box) const {
  std::optional<int> level = 1;
  std::vector<std::vector<Rational>> resisting;
  for (const std::vector<Rational>& point : sample_points(box)) {
    const std::optional<int> own = approx_level(point);
    level = own && level ? std::optional(std::max(*level, *own)) : std::nullopt;
    if (own) continue;
    resisting.push_back(point);
    const std::optional<MatrixFamily> sections = section_hull(b_, denominator_, arity_, point_box(point));
    if (sections && approx_radius(*sections, stop_) >= enough) {
      return {{}, fmt::format("no norm ||S_b^l|| with l <= {} seems to be below 1", limits_.contractivity.max_level), point};
    }
  }
  const bool cheap = level && is_cheap(*level, box);
  if (cheap && proves_norm(*level, box)) return {ContractionWitness{*level}, {}, {}};
  if (std::optional<PolytopeWitness> polytope = find_polytope_on(box)) return {std::move(*polytope), {}, {}};
  if (level && !cheap && proves_norm(*level, box)) return {ContractionWitness{*level}, {}, {}};
  for (const std::vector<Rational>& point : resisting) {
    if (is_point(box) || !has_polytope_at(point)) {
      return {{}, fmt::format("no norm ||S_b^l|| with l <= {} and no polytope with at most {} vectors is found to show a contraction",
                              limits_.contractivity.max_level, limits_.polytope.max_vectors), point};
    }
  }
  return {{}, level ? fmt::format("the bound of ||S_b^{}|| is not below 1", *level) : "no polytope is found", {}};
}

std::optional<ContractionProver::Gaps> ContractionProver::approx_gaps(const Box& box) const {
  int axis = -1;
  for (std::size_t k = 0; k < box.size(); ++k) {
    if (box[k].is_point()) continue;
    if (axis >= 0) return std::nullopt;
    axis = static_cast<int>(k);
  }
  if (axis < 0) return std::nullopt;
  const auto gap = [&](const Rational& end) -> std::optional<double> {
    std::vector<Rational> point = midpoint(box);
    point[static_cast<std::size_t>(axis)] = end;
    const std::optional<MatrixFamily> sections = section_hull(b_, denominator_, arity_, point_box(point));
    if (!sections || sections->front().rows() > limits_.max_polytope_dimension) return std::nullopt;
    return 1 - approx_radius(*sections, stop_);
  };
  const std::optional<double> lower = gap(box[static_cast<std::size_t>(axis)].lower);
  const std::optional<double> upper = gap(box[static_cast<std::size_t>(axis)].upper);
  if (!lower || !upper) return std::nullopt;
  return Gaps{*lower, *upper};
}

Rational ContractionProver::cut(const Box& box, int axis) const {
  const Interval& interval = box[static_cast<std::size_t>(axis)];
  const std::optional<Gaps> gaps = approx_gaps(box);
  if (!gaps || gaps->lower <= least_gap || gaps->upper <= least_gap) return interval.midpoint();
  // If the gap is affine, it is the geometric mean of those at the ends here.
  const double fraction = std::sqrt(gaps->lower) / (std::sqrt(gaps->lower) + std::sqrt(gaps->upper));
  const double slack = std::min(fraction, 1 - fraction) / 8;
  if (!(slack > 1e-6)) return interval.midpoint();
  return simplest_between(interval.lower + Rational(fraction - slack) * interval.width(),
                          interval.lower + Rational(fraction + slack) * interval.width());
}

std::optional<int> ContractionProver::approx_level(const std::vector<Rational>& point) const {
  const auto place = levels_.find(point);
  return place != levels_.end() ? place->second : levels_.emplace(point, new_approx_level(point)).first->second;
}

bool ContractionProver::has_polytope_at(const std::vector<Rational>& point) const {
  const auto place = has_polytope_.find(point);
  return place != has_polytope_.end() ? place->second : has_polytope_.emplace(point, find_polytope_on(point_box(point)).has_value()).first->second;
}

std::optional<int> ContractionProver::new_approx_level(const std::vector<Rational>& point) const {
  const std::vector<double> norms = approx_contractivity_norms(b_, arity_, point, limits_.contractivity.max_level, enough);
  if (norms.back() >= enough) return std::nullopt;
  return static_cast<int>(norms.size());
}

bool ContractionProver::is_cheap(int level, const Box& box) const {
  // Multiplications of level l: coefficients in z, those of the parameters, length of b.
  double work = std::pow(arity_, level) * b_.length() * b_.length();
  for (const Interval& interval : box) work *= interval.is_point() ? 1 : level + 1;
  return work <= 1e6;
}

bool ContractionProver::proves_norm(int level, const Box& box) const {
  try {
    return ContractivityBound(b_, denominator_, arity_, box).proves_contraction(level, limits_.contractivity, stop_);
  } catch (const LimitError&) {
    return false;
  }
}

std::optional<PolytopeWitness> ContractionProver::find_polytope_on(const Box& box) const {
  const std::optional<MatrixFamily> sections = section_hull(b_, denominator_, arity_, box);
  if (!sections || sections->front().rows() > limits_.max_polytope_dimension) return std::nullopt;
  const double gap = 1 - approx_radius(*sections, stop_);
  PolytopeLimits limits = limits_.polytope;
  limits.real_room = 0.05;
  int bits = 20;
  if (gap <= std::ldexp(1, 1 - bits)) {
    bits = 27;
    limits.precision = std::max(limits.precision, 60);
  }
  if (gap <= std::ldexp(1, -bits)) return std::nullopt;
  const Rational bound = 1 - power(Rational(2), -bits);
  if (const std::optional<Gaps> gaps = approx_gaps(box)) {
    if (static_cast<int>(sections->size()) == 2 * arity_) {
      // A fixed polytope where it has few vectors: moving ones cost more, and where the gap varies much they fail late.
      constexpr std::size_t very_few_vectors = 64;
      PolytopeLimits quick = limits;
      quick.max_vectors = std::min(limits.max_vectors, very_few_vectors);
      if (std::optional<PolytopeNorm> norm = find_polytope(*sections, bound, quick, stop_)) return PolytopeWitness{std::move(*norm)};
      if (std::optional<MovingNorm> norm = find_moving_polytope(*sections, bound, limits, stop_)) return PolytopeWitness{std::move(*norm)};
    }
    // The more the gap varies, the more vectors are needed, each dearer than the one before: smaller boxes cost less.
    constexpr double greatest_quotient = 1.5;
    constexpr std::size_t few_vectors = 250;
    if (std::max(gaps->lower, gaps->upper) > greatest_quotient * std::min(gaps->lower, gaps->upper)) {
      limits.max_vectors = std::min(limits.max_vectors, few_vectors);
    }
  }
  std::optional<PolytopeNorm> norm = find_polytope(*sections, bound, limits, stop_);
  if (!norm) return std::nullopt;
  return PolytopeWitness{std::move(*norm)};
}

}  // namespace limes
