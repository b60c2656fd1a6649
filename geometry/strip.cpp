#include "geometry/strip_impl.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

namespace limes::geometry_impl {
namespace {

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }
std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

/// What a level can compute from the points in a range.
Range determined(const Range& range, const Support& s) {
  return {s.arity * range.first + s.highest - s.arity + 1, s.arity * (range.last + 1) + s.lowest - 1};
}

/// The same the other way round: what the new points in a range depend on.
Range dependence(const Range& range, const Support& s) {
  return {ceil_div(range.first - s.highest, s.arity), floor_div(range.last - s.lowest, s.arity)};
}

/// Continues the known points first, .., last of a strip to all of it by a recurrence.
void continue_by(const std::vector<double>& weights, Strip& strip, std::int64_t first, std::int64_t last) {
  const auto fill = [&](std::int64_t i, std::int64_t inward) {
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const double* source = strip[i + inward * static_cast<std::int64_t>(j + 1)];
      for (std::size_t k = 0; k < strip.dimension; ++k) strip[i][k] += weights[j] * source[k];
    }
  };
  for (std::int64_t i = first - 1; i >= strip.first; --i) fill(i, 1);
  for (std::int64_t i = last + 1; i <= strip.last(); ++i) fill(i, -1);
}

/// The points of a range that contains 0, .., size-1: periodic when closed, else on the lines through the end edges, or by the
/// weights of a recurrence.
Strip continued(const Polygon& polygon, const Range& range, const std::vector<double>& weights = {}) {
  const auto n = static_cast<std::int64_t>(polygon.size());
  const auto d = static_cast<std::size_t>(polygon.dimension());
  Strip strip{range.first, d, std::vector<double>(static_cast<std::size_t>(range.size()) * d)};
  if (!polygon.closed() && !weights.empty()) {
    std::copy(polygon.coordinates().begin(), polygon.coordinates().end(), strip[0]);
    continue_by(weights, strip, 0, n - 1);
    return strip;
  }
  for (std::int64_t i = range.first; i <= range.last; ++i) {
    std::int64_t base = polygon.closed() ? ((i % n) + n) % n : std::clamp<std::int64_t>(i, 0, n - 1);
    const auto steps = static_cast<double>(polygon.closed() ? 0 : i - base);
    const auto at = [&](std::int64_t j) { return polygon[static_cast<std::size_t>(j)]; };
    for (std::size_t k = 0; k < d; ++k) {
      double x = at(base)[k];
      if (steps < 0) x += steps * (at(1)[k] - at(0)[k]);
      if (steps > 0) x += steps * (at(n - 1)[k] - at(n - 2)[k]);
      strip[i][k] = x;
    }
  }
  return strip;
}

/// Beyond this scale indices could overflow; a polygon that shrinks to few points would get there.
constexpr std::int64_t max_scale = std::int64_t{1} << 36;

[[noreturn]] void too_many(const Refinement& refinement, int possible) {
  throw LimitError(fmt::format("{} levels are too many: the result may have {} points, so at most {} {} possible here",
                               refinement.levels, refinement.max_points, possible,
                               possible == 1 ? "level is" : "levels are"));
}

Strip refined_closed(const Polygon& polygon, const Support& support, const Refinement& refinement, const Stop& stop,
                     const Step& step) {
  std::int64_t size = static_cast<std::int64_t>(polygon.size());
  for (int level = 1; level <= refinement.levels; ++level) {
    size *= support.arity;
    if (size > static_cast<std::int64_t>(refinement.max_points)) too_many(refinement, level - 1);
  }
  const int shift = support.interpolatory ? support.centre_twice / 2 : 0;
  Strip strip = continued(polygon, {0, static_cast<std::int64_t>(polygon.size()) - 1});
  for (int level = 1; level <= refinement.levels; ++level) {
    stop.check();
    const std::int64_t made = (strip.last() + 1) * support.arity;
    const Polygon period(polygon.dimension(), std::move(strip.coordinates), true);
    const auto d = static_cast<std::size_t>(period.dimension());
    strip = {shift, d, std::vector<double>(static_cast<std::size_t>(made) * d)};
    step(continued(period, dependence({strip.first, strip.last()}, support)), strip, level);
    strip.first = 0;
  }
  return strip;
}

Strip refined_open(const Polygon& polygon, const Support& support, bool extend, const Refinement& refinement,
                   const Stop& stop, const Step& step) {
  const std::int64_t last = static_cast<std::int64_t>(polygon.size()) - 1;
  const int p = support.arity;
  Range range{0, last};
  if (extend) {
    // So many that the determined points reach both ends at every level; exact, since the centre counts halves.
    const auto before = ceil_div(2 * (support.highest - p + 1) - support.centre_twice, 2 * (p - 1));
    const auto after = ceil_div(support.centre_twice - 2 * (support.lowest + p - 1), 2 * (p - 1));
    range = {-std::max<std::int64_t>(before, 0), last + std::max<std::int64_t>(after, 0)};
  }
  // The place of point i of a level in the first polygon is (2 i - centre) / (2 scale).
  std::vector<Range> ranges{range};
  std::int64_t scale = 1, centre = 0;
  Range kept{0, last};
  for (int level = 1; level <= refinement.levels; ++level) {
    ranges.push_back(determined(ranges.back(), support));
    scale *= p;
    centre = p * centre + support.centre_twice;
    kept = ranges.back();
    if (extend)
      kept = {std::max(kept.first, ceil_div(centre, 2)), std::min(kept.last, floor_div(centre + 2 * scale * last, 2))};
    if (kept.size() > static_cast<std::int64_t>(refinement.max_points) || scale > max_scale)
      too_many(refinement, level - 1);
    if (kept.size() < 2) {
      throw InputError(
          fmt::format("{} points are too few for an open polygon that shrinks: after {} {} nothing is left", last + 1,
                      level, level == 1 ? "level" : "levels"));
    }
  }
  Strip strip = continued(polygon, ranges.front(), support.continuation);
  for (int level = 1; level <= refinement.levels; ++level) {
    stop.check();
    const Range& made = ranges[static_cast<std::size_t>(level)];
    Strip next{made.first, strip.dimension,
               std::vector<double>(static_cast<std::size_t>(made.size()) * strip.dimension)};
    step(strip, next, level);
    strip = std::move(next);
  }
  std::vector<double> coordinates(strip[kept.first], strip[kept.last] + strip.dimension);
  return {kept.first, strip.dimension, std::move(coordinates)};
}

}  // namespace

Strip refined_strip(const Polygon& polygon, const Support& support, const Refinement& refinement, const Stop& stop,
                    const Step& step) {
  if (refinement.levels < 0) throw DomainError("the number of levels is negative");
  const int needed = polygon.closed() ? 3 : std::max({support.points, 2, static_cast<int>(support.continuation.size())});
  if (polygon.size() < static_cast<std::size_t>(needed)) {
    throw InputError(fmt::format("{} {} too few: {} needs at least {}", polygon.size(),
                                 polygon.size() == 1 ? "point is" : "points are",
                                 polygon.closed() ? "a closed polygon" : "the scheme on an open polygon", needed));
  }
  if (polygon.closed()) return refined_closed(polygon, support, refinement, stop, step);
  const bool extend =
      refinement.ends == EndRule::extend || refinement.ends == EndRule::exact || (refinement.ends == EndRule::automatic && support.interpolatory);
  return refined_open(polygon, support, extend, refinement, stop, step);
}

}  // namespace limes::geometry_impl
