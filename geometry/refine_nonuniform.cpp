#include "geometry/strip_impl.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace limes {
namespace {

using geometry_impl::Strip;
using geometry_impl::Support;

/// The first level's intervals between knots, continued periodically or by the end intervals. At level k the interval
/// from t_i to t_{i+1} is one of them divided by 2^k; so all ratios are those of first intervals.
class Intervals {
 public:
  explicit Intervals(const Polygon& polygon) : closed_(polygon.closed()) {
    const std::vector<double>& knots = polygon.knots();
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) lengths_.push_back(knots[i + 1] - knots[i]);
  }
  double operator()(std::int64_t i, int level) const {
    const auto n = static_cast<std::int64_t>(lengths_.size());
    std::int64_t j = i >> level;
    j = closed_ ? ((j % n) + n) % n : std::clamp<std::int64_t>(j, 0, n - 1);
    return lengths_[static_cast<std::size_t>(j)];
  }

 private:
  bool closed_;
  std::vector<double> lengths_;
};

/// Asks the rule once for each pattern of intervals: nearly all windows are equally spaced, and around a knot the same
/// patterns come again at each level.
class Stencils {
 public:
  Stencils(const NonuniformRule& rule, const Stop& stop) : rule_(rule), stop_(stop) {}

  /// For the window of 2n - 1 intervals of which the one in the middle, i, is halved.
  const std::vector<double>& at(const Intervals& intervals, std::int64_t i, int level) {
    const int n = rule_.points / 2;
    window_.clear();
    const double middle = intervals(i, level);
    for (std::int64_t j = i - n + 1; j <= i + n - 1; ++j) window_.push_back(intervals(j, level) / middle);
    if (known_.size() >= max_known) known_.clear();
    const auto [place, is_new] = known_.try_emplace(window_);
    if (is_new) place->second = computed();
    return place->second;
  }

 private:
  std::vector<double> computed() const {
    stop_.check();
    std::vector<double> knots{0};
    for (const double length : window_) knots.push_back(knots.back() + length);
    for (std::size_t k = 1; k < knots.size(); ++k) {
      if (!std::isfinite(knots[k]) || !(knots[k - 1] < knots[k])) {
        throw InputError("neighbouring knot intervals differ too much in length for double precision");
      }
    }
    std::vector<double> stencil = rule_.stencil(knots);
    if (stencil.size() != static_cast<std::size_t>(rule_.points)) {
      throw InternalError(fmt::format("a stencil of {} weights where {} are expected", stencil.size(), rule_.points));
    }
    for (const double weight : stencil) {
      if (!std::isfinite(weight)) throw DomainError("the stencil is not finite at these knots");
    }
    return stencil;
  }

  /// Keeps memory bounded for very many points; polygons of ten thousand stay below it.
  static constexpr std::size_t max_known = std::size_t{1} << 18;

  const NonuniformRule& rule_;
  const Stop& stop_;
  std::vector<double> window_;
  std::map<std::vector<double>, std::vector<double>> known_;
};

}  // namespace

NonuniformRule approx_nonuniform_rule(const InsertionRule& rule, std::span<const Rational> parameter_values) {
  std::vector<double> parameters;
  for (const Rational& value : parameter_values) parameters.push_back(approx_double(value));
  return {rule.points(),
          [rule, parameters](std::span<const double> knots) { return rule.approx_stencil(knots, parameters); }};
}

Polygon refine_polygon(const Polygon& polygon, const NonuniformRule& rule, const Refinement& refinement,
                       const Stop& stop) {
  if (rule.points < 2 || rule.points % 2 != 0) throw DomainError("an insertion rule has an even number of points");
  if (polygon.knots().empty()) throw DomainError("a non-uniform scheme needs a polygon with knots");
  const int n = rule.points / 2;
  const Intervals intervals(polygon);
  Stencils stencils(rule, stop);
  if (refinement.ends == EndRule::exact) throw DomainError("only nonstationary schemes have exact ends");
  const Support support{2, 1 - 2 * n, 2 * n - 1, 0, rule.points, true, {}};
  Strip strip =
      geometry_impl::refined_strip(polygon, support, refinement, stop, [&](const Strip& from, Strip& to, int level) {
        const std::size_t d = to.dimension;
        for (std::int64_t i = to.first, last = to.last(); i <= last; ++i) {
          const std::int64_t old = i >> 1;
          if (i % 2 == 0) {
            std::copy_n(from[old], d, to[i]);
            continue;
          }
          const double* source = from[old - n + 1];
          for (const double weight : stencils.at(intervals, old, level - 1)) {
            for (std::size_t k = 0; k < d; ++k) to[i][k] += weight * source[k];
            source += d;
          }
        }
      });

  std::vector<double> knots;
  const std::vector<double>& first = polygon.knots();
  const std::int64_t last = strip.last() + (polygon.closed() ? 1 : 0);
  for (std::int64_t i = strip.first; i <= last; ++i) {
    const auto j = static_cast<std::size_t>(i >> refinement.levels);
    const double part =
        std::ldexp(static_cast<double>(i & ((std::int64_t{1} << refinement.levels) - 1)), -refinement.levels);
    knots.push_back(part == 0 ? first[j] : first[j] + part * (first[j + 1] - first[j]));
  }
  return {polygon.dimension(), std::move(strip.coordinates), polygon.closed(), std::move(knots)};
}

}  // namespace limes
