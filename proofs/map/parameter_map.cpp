#include "proofs/map/parameter_map.hpp"

#include "algebra/error.hpp"
#include "proofs/map/smoothness_hint.hpp"
#include "proofs/prove.hpp"
#include "proofs/uniform/smoothness_proof.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace limes {
namespace {

enum class Seems { smooth, rough, critical };

Seems seems(double growth) {
  constexpr double margin = 1e-9;
  return growth < 1 - margin ? Seems::smooth : growth > 1 + margin ? Seems::rough : Seems::critical;
}

/// A short rational well inside of an interval.
Rational middle_of(const Interval& interval) {
  return simplest_between(interval.lower + interval.width() / 3, interval.upper - interval.width() / 3);
}

class MapSearch {
 public:
  MapSearch(const Scheme& scheme, int m, const Box& region, const MapOptions& options, const MapObserver& observer, const Stop& stop)
      : scheme_(scheme), m_(m), region_(region), options_(options), observer_(observer), stop_(stop), hint_(scheme, m, stop) {
    for (std::size_t k = 0; k < region.size(); ++k) {
      if (!region[k].is_point()) free_axes_.push_back(k);
    }
    if (free_axes_.empty() || free_axes_.size() > 2) throw InputError("a map needs one or two parameters that vary");
  }

  ParameterMap run() {
    const std::vector<Rational> isolated = free_axes_.size() == 1 ? hint_.isolated_values(region_) : std::vector<Rational>{};
    for (Box& piece : isolated.empty() ? std::vector<Box>{region_} : cut_at(region_, isolated)) {
      unknown_ += measure(piece);
      pending_.push_back({std::move(piece), 0});
    }
    while (!pending_.empty() && !result_.interrupted && (unknown_ > options_.tolerance || has_points()) &&
           looked_at_ < options_.max_cells) {
      run_round();
    }
    for (Pending& cell : pending_) result_.cells.push_back({std::move(cell.cell), Outcome::undecided, {}});
    std::stable_sort(result_.cells.begin(), result_.cells.end(), is_before);
    result_.unknown_measure = unknown_;
    result_.complete = unknown_ <= options_.tolerance && !result_.interrupted;
    return std::move(result_);
  }

 private:
  struct Pending {
    Box cell;
    /// How many generations of proofs have failed.
    int failures = 0;
  };

  bool has_points() const {
    return std::any_of(pending_.begin(), pending_.end(), [](const Pending& p) { return is_point(p.cell); });
  }

  static bool is_before(const MapCell& x, const MapCell& y) {
    for (std::size_t k = 0; k < x.region.size(); ++k) {
      const Interval& a = x.region[k];
      const Interval& b = y.region[k];
      if (a.lower != b.lower) return a.lower < b.lower;
      if (a.lower_open != b.lower_open) return b.lower_open;
      if (a.upper != b.upper) return a.upper < b.upper;
    }
    return false;
  }

  /// All pending cells are looked at; what remains of them is pending in the next round.
  void run_round() {
    std::vector<std::optional<MapRecord>> records(pending_.size());
    tbb::parallel_for(std::size_t{0}, pending_.size(), [&](std::size_t k) {
      try {
        records[k] = record_of(pending_[k].cell);
      } catch (const Interrupted&) {
      }
    }, tbb::simple_partitioner());
    looked_at_ += static_cast<int>(pending_.size());
    std::vector<Pending> next;
    for (std::size_t k = 0; k < pending_.size(); ++k) {
      if (!records[k]) {
        result_.interrupted = true;
        next.push_back(std::move(pending_[k]));
        continue;
      }
      constexpr int max_failures = 5;
      // Bisection that comes closer to a boundary fails at one half and succeeds at the other.
      const int failures = sibling_succeeded(records, k) ? 0 : pending_[k].failures + (records[k]->failed ? 1 : 0);
      for (MapCell& piece : records[k]->pieces) {
        if (piece.verdict != Outcome::undecided) {
          unknown_ -= measure(piece.region);
          result_.cells.push_back(std::move(piece));
        } else if (failures < max_failures && can_be_cut(piece.region) && !(is_point(piece.region) && is_point(pending_[k].cell))) {
          next.push_back({std::move(piece.region), failures});
        } else {
          result_.cells.push_back(std::move(piece));
        }
      }
    }
    pending_ = std::move(next);
    if (observer_.progress) observer_.progress({result_.cells.size() + pending_.size(), unknown_});
  }

  /// Siblings are next to each other in a round.
  bool sibling_succeeded(const std::vector<std::optional<MapRecord>>& records, std::size_t k) const {
    const auto succeeded = [&](std::size_t i) {
      return records[i] && std::any_of(records[i]->pieces.begin(), records[i]->pieces.end(),
                                       [](const MapCell& piece) { return piece.verdict != Outcome::undecided; });
    };
    const auto touches = [&](std::size_t i) {
      for (std::size_t axis : free_axes_) {
        const Interval& a = pending_[i].cell[axis];
        const Interval& b = pending_[k].cell[axis];
        if (a.upper < b.lower || b.upper < a.lower) return false;
      }
      return true;
    };
    return (k > 0 && touches(k - 1) && succeeded(k - 1)) || (k + 1 < records.size() && touches(k + 1) && succeeded(k + 1));
  }

  bool can_be_cut(const Box& cell) const {
    return is_point(cell) || measure(cell) * (free_axes_.size() == 1 ? 16 : 100000) > options_.tolerance;
  }

  MapRecord record_of(const Box& cell) {
    if (observer_.find) {
      if (const MapRecord* found = observer_.find(cell)) return *found;
    }
    stop_.check();
    MapRecord record = is_point(cell) ? decide_point(cell) : decide(cell);
    if (observer_.record) observer_.record(record);
    return record;
  }

  /// The hint at a point, remembered.
  Seems seems_at(const std::vector<Rational>& point) {
    {
      const std::scoped_lock lock(mutex_);
      if (const auto place = hints_.find(point); place != hints_.end()) return place->second;
    }
    const Seems result = seems(hint_.approx_growth(point));
    const std::scoped_lock lock(mutex_);
    return hints_.emplace(point, result).first->second;
  }

  /// A proof of "C^m" or of "not C^m" on the cell: whether there is one.
  bool prove_cell(const Box& cell, bool negated, MapRecord& record) {
    const Claim claim{.smoothness = m_, .negated = negated, .space = {}, .region = cell, .expected = Outcome::certified, .source = {}, .erratum = {}};
    Verdict verdict = prove_as_stated(scheme_, claim, options_.limits, stop_);
    if (verdict.interrupted) throw Interrupted(verdict.reason);
    if (verdict.outcome != Outcome::certified) {
      record.failed = true;
      return false;
    }
    record.pieces.push_back({cell, negated ? Outcome::refuted : Outcome::certified, std::move(verdict.certificate_json)});
    return true;
  }

  MapRecord decide_point(const Box& cell) {
    MapRecord record{cell, {}};
    const bool rough_first = seems_at(midpoint(cell)) != Seems::smooth;
    if (!prove_cell(cell, rough_first, record) && !prove_cell(cell, !rough_first, record)) record.pieces.push_back({cell});
    return record;
  }

  /// The corners of a cell's closure, and its midpoint.
  std::vector<std::vector<Rational>> samples(const Box& cell) const {
    std::vector<std::vector<Rational>> points{midpoint(cell)};
    for (unsigned corner = 0; corner < (1u << free_axes_.size()); ++corner) {
      std::vector<Rational> point = midpoint(cell);
      for (std::size_t k = 0; k < free_axes_.size(); ++k) {
        const Interval& interval = cell[free_axes_[k]];
        point[free_axes_[k]] = (corner >> k) & 1 ? interval.upper : interval.lower;
      }
      points.push_back(std::move(point));
    }
    return points;
  }

  MapRecord decide(const Box& cell) {
    MapRecord record{cell, {}};
    const std::vector<std::vector<Rational>> points = samples(cell);
    std::vector<Seems> votes;
    for (const auto& point : points) votes.push_back(seems_at(point));
    const auto count = [&](Seems what) { return std::count(votes.begin(), votes.end(), what); };
    if (free_axes_.size() == 1) return decide_interval(cell, votes, std::move(record));
    if (count(Seems::smooth) == 0) {
      if (prove_cell(cell, true, record)) return record;
    } else if (count(Seems::rough) == 0) {
      if (prove_cell(cell, false, record)) return record;
    }
    cut(cell, widest_axis(cell, region_), record);
    return record;
  }

  void cut(const Box& cell, int axis, MapRecord& record) const {
    if (free_axes_.size() == 1) return cut_interval(cell, {middle_of(cell[axis])}, record);
    auto [lower, upper] = bisect(cell, axis);
    record.pieces.push_back({std::move(lower)});
    record.pieces.push_back({std::move(upper)});
  }

  /// At values strictly inside, ascending; the pieces contain them.
  void cut_interval(const Box& cell, const std::vector<Rational>& values, MapRecord& record) const {
    Interval rest = cell[free_axes_[0]];
    const auto add = [&](const Interval& interval) {
      Box piece = cell;
      piece[free_axes_[0]] = interval;
      record.pieces.push_back({std::move(piece)});
    };
    for (const Rational& value : values) {
      add({rest.lower, value, rest.lower_open, false});
      rest.lower = value;
      rest.lower_open = false;
    }
    add(rest);
  }

  /// \param votes of the middle, the lower and the upper end
  MapRecord decide_interval(const Box& cell, const std::vector<Seems>& votes, MapRecord record) {
    const std::size_t axis = free_axes_[0];
    const Interval& interval = cell[axis];
    const Seems middle = votes[0];
    if (middle == Seems::smooth && votes[1] != Seems::rough && votes[2] != Seems::rough) {
      // At a critical end the uniform scheme is not smooth; a non-uniform one may be, if all knot ratios but the limit 0 are uncritical.
      // Otherwise the cell is open there, and the end a cell of its own.
      if (scheme_.insertion_rule && (votes[1] == Seems::critical || votes[2] == Seems::critical) && prove_cell(cell, false, record)) return record;
      Box open = cell;
      if (votes[1] == Seems::critical) open[axis].lower_open = true;
      if (votes[2] == Seems::critical) open[axis].upper_open = true;
      if (prove_cell(open, false, record)) {
        add_end(cell, open[axis].lower_open && !interval.lower_open, interval.lower, record);
        add_end(cell, open[axis].upper_open && !interval.upper_open, interval.upper, record);
        return record;
      }
    } else if (middle != Seems::smooth && votes[1] != Seems::smooth && votes[2] != Seems::smooth) {
      if (prove_cell(cell, true, record)) return record;
      if (const std::optional<Rational> value = cut_beside_critical_end(interval, votes)) {
        cut_interval(cell, {*value}, record);
        return record;
      }
    } else if (middle != Seems::critical) {
      for (const std::size_t end : {1, 2}) {
        if (votes[end] != middle && votes[end] != Seems::critical) {
          cut_interval(cell, cuts_at_crossing(cell, end == 1 ? interval.lower : interval.upper), record);
          return record;
        }
      }
    }
    cut(cell, static_cast<int>(axis), record);
    return record;
  }

  void add_end(const Box& cell, bool needed, const Rational& value, MapRecord& record) const {
    if (!needed) return;
    Box point = cell;
    point[free_axes_[0]] = Interval::point(value);
    record.pieces.push_back({std::move(point)});
  }

  /// Where to cut between the middle and an end at which the hints differ: at a short rational if the hint is critical there,
  /// otherwise on both sides of the crossing.
  std::vector<Rational> cuts_at_crossing(const Box& cell, const Rational& end) {
    const std::size_t axis = free_axes_[0];
    const Interval& interval = cell[axis];
    std::vector<Rational> from = midpoint(cell);
    std::vector<Rational> to = from;
    to[axis] = end;
    const double fraction = hint_.approx_crossing(from, to);
    // Doubles are rationals.
    const Rational crossing = from[axis] + Rational(fraction) * (to[axis] - from[axis]);
    // Much closer than a rational with a short denominator comes to other numbers.
    const Rational near = interval.width() / 100000000000;
    std::vector<Rational> point = from;
    point[axis] = simplest_between(crossing - near, crossing + near);
    constexpr int short_denominator = 10000;
    if (denominator(point[axis]) <= short_denominator && seems_at(point) == Seems::critical && is_inside(interval, point[axis])) {
      return {point[axis]};
    }
    const Rational margin = options_.tolerance / 8;
    std::vector<Rational> cuts;
    for (const Rational& cut : {simplest_between(crossing - 2 * margin, crossing - margin),
                                simplest_between(crossing + margin, crossing + 2 * margin)}) {
      if (is_inside(interval, cut)) cuts.push_back(cut);
    }
    if (cuts.empty()) cuts.push_back(middle_of(interval));
    return cuts;
  }

  /// A value close to the one critical end of a rough cell: whatever is refuted there ends before it.
  std::optional<Rational> cut_beside_critical_end(const Interval& interval, const std::vector<Seems>& votes) const {
    const bool at_lower = votes[1] == Seems::critical;
    if (votes[0] != Seems::rough || at_lower == (votes[2] == Seems::critical)) return std::nullopt;
    const Rational margin = options_.tolerance / 8, distance = interval.width() / 2;
    if (distance <= 2 * margin) return std::nullopt;
    const Rational near = at_lower ? interval.lower + margin : interval.upper - 2 * margin;
    return simplest_between(near, near + margin);
  }

  static bool is_inside(const Interval& interval, const Rational& x) { return interval.lower < x && x < interval.upper; }

  const Scheme& scheme_;
  int m_;
  const Box& region_;
  const MapOptions& options_;
  const MapObserver& observer_;
  const Stop& stop_;
  SmoothnessHint hint_;
  std::vector<std::size_t> free_axes_;
  std::vector<Pending> pending_;
  Rational unknown_;
  int looked_at_ = 0;
  ParameterMap result_;
  std::mutex mutex_;
  std::map<std::vector<Rational>, Seems> hints_;
};

}  // namespace

Rational measure(const Box& box) {
  Rational result = 1;
  for (const Interval& interval : box) {
    if (!interval.is_point()) result *= interval.width();
  }
  return is_point(box) ? Rational(0) : result;
}

ProofLimits MapOptions::default_limits() {
  ProofLimits limits;
  limits.contractivity.max_level = 14;
  limits.contractivity.max_bytes = 3e7;
  limits.max_leaves = 64;
  limits.max_depth = 8;
  return limits;
}

ParameterMap map_parameters(const Scheme& scheme, int smoothness, const Box& region, const MapOptions& options,
                            const MapObserver& observer, const Stop& stop) {
  if (region.size() != scheme.parameters.size()) throw DomainError("map_parameters: the region has the wrong number of parameters");
  if (scheme.kind != SchemeKind::uniform && scheme.kind != SchemeKind::nonuniform) {
    throw InputError(fmt::format("maps are made of uniform and non-uniform schemes, not of {} ones", to_string(scheme.kind)));
  }
  if (options.tolerance <= 0) throw InputError("the tolerance of a map must be positive");
  return MapSearch(scheme, smoothness, region, options, observer, stop).run();
}

}  // namespace limes
