#include "schemes/surface/ring_rule.hpp"

#include "algebra/error.hpp"
#include "schemes/surface/ring_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace limes {
namespace {

/// The indices j with a_{i - 2j} != 0.
struct Footprint {
  int first = 0, last = 0;
};

Footprint footprint(const LaurentPolynomial& mask, int i) {
  // ceil and floor of a half
  Footprint f{(i - mask.highest() + 1) >> 1, (i - mask.lowest()) >> 1};
  while (f.first < f.last && mask.coefficient(i - 2 * f.first).is_zero()) ++f.first;
  while (f.first < f.last && mask.coefficient(i - 2 * f.last).is_zero()) --f.last;
  return f;
}

/// The point (a, b) as it is called in its own sector.
std::pair<RingPoint, int> unfolded(bool dual, int a, int b) {
  if (dual) {
    if (b < 0) return {{-1 - b, a}, -1};
    if (a < 0) return {{b, -1 - a}, 1};
    return {{a, b}, 0};
  }
  if (a == 0 && b == 0) return {{0, 0}, 0};
  if (b < 0) return {{-b, a}, -1};
  if (a > 0) return {{a, b}, 0};
  return b == 0 ? std::pair{RingPoint{-a, 0}, 2} : std::pair{RingPoint{b, -a}, 1};
}

RationalFunction in_mu_and_n(const RationalFunction& c) {
  static constexpr int place[] = {0};
  return c.mapped(2, std::span(place).first(std::size_t(c.variables())));
}

RingTerm term(int a, int b, int sector, RationalFunction weight) { return {{a, b}, sector, -1, std::move(weight)}; }
RingTerm mean(int a, int b, RationalFunction weight) { return {{a, b}, 0, 0, std::move(weight)}; }

}  // namespace

std::vector<RingTerm> RingRule::at(RingPoint point) const {
  if (const auto found = given.find(point); found != given.end()) return found->second;
  const LaurentPolynomial& mask = curve.symbol;
  const Footprint x = footprint(mask, point.a), y = footprint(mask, point.b);
  const bool beyond = x.first < 0 && y.first < 0;
  const bool through = !dual && ((x.first < 0 && y.first == 0 && y.last == 0) || (y.first < 0 && x.first == 0 && x.last == 0));
  if (beyond || through) {
    throw InputError(fmt::format("the new point {} needs a rule of its own: the tensor product takes points beyond the extraordinary {}",
                                 to_string(point), dual ? "face" : "vertex"));
  }
  std::vector<RingTerm> terms;
  for (int j = x.first; j <= x.last; ++j) {
    for (int k = y.first; k <= y.last; ++k) {
      RationalFunction weight = mask.coefficient(point.a - 2 * j) * mask.coefficient(point.b - 2 * k);
      if (weight.is_zero()) continue;
      const auto [old, sector] = unfolded(dual, j, k);
      terms.push_back({old, sector, -1, std::move(weight)});
    }
  }
  return terms;
}

int RingRule::invariant_rings(int least) const {
  constexpr int most = 20;
  int needed = std::max(least, 1);
  for (int ring = 0; ring <= needed; ++ring) {
    std::vector<RingPoint> points;
    for (const RingPoint& point : sector_points(dual, ring)) {
      if (ring_of(dual, point) == ring) points.push_back(point);
    }
    if (!dual && ring == 0) points = {{0, 0}};
    for (const RingPoint& point : points) {
      for (const RingTerm& t : at(point)) needed = std::max(needed, ring_of(dual, t.point));
    }
    if (needed > most) throw InputError(fmt::format("new points of no number of rings up to {} depend on these rings only", most));
  }
  return needed;
}

int ring_of(bool dual, RingPoint point) { return std::max(point.a, point.b) + (dual ? 1 : 0); }

std::vector<RingPoint> sector_points(bool dual, int rings) {
  std::vector<RingPoint> points;
  for (int r = 1; r <= rings; ++r) {
    const int m = dual ? r - 1 : r;
    for (int a = dual ? 0 : 1; a <= m; ++a) {
      for (int b = a == m ? 0 : m; b <= m; ++b) points.push_back({a, b});
    }
  }
  return points;
}

RingRule tensor_rule(const Mask& curve) {
  const LaurentPolynomial& mask = curve.symbol;
  if (curve.arity != 2) throw InputError("a surface scheme needs a binary curve scheme");
  if (mask.is_zero() || mask.variables() > 1) throw InputError("a surface scheme needs a curve scheme without parameters but the level's");
  const int ends = mask.lowest() + mask.highest();
  const bool dual = ends % 2 != 0;
  std::vector<RationalFunction> coefficients;
  for (const RationalFunction& c : mask.coefficients()) coefficients.push_back(in_mu_and_n(c));
  const std::size_t length = coefficients.size();
  for (std::size_t i = 0; 2 * i < length; ++i) {
    if (!(coefficients[i] == coefficients[length - 1 - i])) throw InputError("a surface scheme needs a curve scheme with a symmetric mask");
  }
  const int lowest = mask.lowest() - (dual ? (ends - 1) / 2 : ends / 2);
  return {dual, {2, LaurentPolynomial(2, lowest, std::move(coefficients))}, {}};
}

RingRule virtual_point_rule(const Mask& curve) {
  RingRule rule = tensor_rule(curve);
  const LaurentPolynomial& mask = rule.curve.symbol;
  const RationalFunction one = RationalFunction::constant(2, 1);
  if (mask.lowest() != -3 || mask.length() != 7 || !mask.coefficient(2).is_zero() || !(mask.coefficient(0) == one) || mask.coefficient(1).is_zero())
    throw InputError("virtual points belong to symmetric interpolatory four-point schemes");
  const RationalFunction alpha = mask.coefficient(3), beta = mask.coefficient(1), two = one + one;
  const RationalFunction diagonal = -alpha * alpha / beta;  // alpha kappa
  const RationalFunction four = two + two;
  // X = alpha (H + V) + beta (L + P)
  const std::vector<RingTerm> edge = {term(0, 0, 0, beta),          term(1, 0, 0, beta - alpha), term(1, 0, -1, -alpha),
                                      term(1, 0, 1, -alpha),        term(2, 0, 0, alpha),        mean(1, 0, four * alpha),
                                      term(1, 1, -2, diagonal),     term(1, 1, -1, diagonal),    term(1, 1, 0, diagonal),
                                      term(1, 1, 1, diagonal),      mean(1, 1, -four * diagonal)};
  // The face point: the curve rule in the direction of spoke 1, on the edge points next to spoke 0 and in the rows -1, 1, 2; row -1 is a
  // line through the regular vertex L_{-1}.
  std::vector<RingTerm> face;
  for (RingTerm t : edge) {
    t.weight *= beta;
    face.push_back(std::move(t));
  }
  const auto row = [&](const RationalFunction& weight, const std::array<std::pair<RingPoint, int>, 4>& points) {
    for (std::size_t k = 0; k < 4; ++k) {
      const RationalFunction w = weight * (k == 0 || k == 3 ? alpha : beta);
      face.push_back(term(points[k].first.a, points[k].first.b, points[k].second, w));
    }
  };
  using P = RingPoint;
  row(alpha, {std::pair{P{1, 1}, -2}, {P{1, 0}, -1}, {P{1, 1}, -1}, {P{1, 2}, -1}});
  row(beta, {std::pair{P{1, 1}, 1}, {P{1, 0}, 1}, {P{1, 1}, 0}, {P{2, 1}, 0}});
  row(alpha, {std::pair{P{2, 1}, 1}, {P{2, 0}, 1}, {P{1, 2}, 0}, {P{2, 2}, 0}});
  rule.given[{0, 0}] = {term(0, 0, 0, one)};
  rule.given[{1, 0}] = edge;
  // one term for each point
  std::vector<RingTerm>& merged = rule.given[{1, 1}];
  for (RingTerm& t : face) {
    const auto same = std::find_if(merged.begin(), merged.end(), [&](const RingTerm& other) {
      return other.point == t.point && other.sector == t.sector && other.harmonic == t.harmonic;
    });
    if (same == merged.end()) merged.push_back(std::move(t));
    else same->weight += t.weight;
  }
  std::erase_if(merged, [](const RingTerm& t) { return t.weight.is_zero(); });
  return rule;
}

}  // namespace limes
