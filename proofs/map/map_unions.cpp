#include "proofs/map/map_unions.hpp"

#include "proofs/checker/checker.hpp"
#include "proofs/map/merge_certificates.hpp"

namespace limes {
namespace {

/// The box that two boxes make together, when they are equal but for one axis, along which they meet without a gap.
std::optional<Box> joined(const Box& x, const Box& y) {
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k] == y[k]) continue;
    if (axis) return std::nullopt;
    axis = k;
  }
  if (!axis) return x;
  const bool in_order = x[*axis].lower < y[*axis].lower || (x[*axis].lower == y[*axis].lower && !x[*axis].lower_open);
  const Interval& a = in_order ? x[*axis] : y[*axis];
  const Interval& b = in_order ? y[*axis] : x[*axis];
  if (a.upper < b.lower || (a.upper == b.lower && a.upper_open && b.lower_open)) return std::nullopt;
  Box result = x;
  Interval& sum = result[*axis];
  sum.lower = a.lower;
  sum.lower_open = a.lower_open && (b.lower > a.lower || b.lower_open);
  const bool b_ends_last = b.upper > a.upper || (b.upper == a.upper && !b.upper_open);
  sum.upper = b_ends_last ? b.upper : a.upper;
  sum.upper_open = b_ends_last ? b.upper_open : a.upper_open;
  return result;
}

/// Joins what can be joined until nothing can.
void join_neighbours(std::vector<MapUnion>& unions) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<MapUnion> result;
    for (MapUnion& next : unions) {
      bool taken = false;
      for (std::size_t k = result.size(); k-- > 0 && !taken;) {
        if (result[k].verdict != next.verdict) continue;
        if (std::optional<Box> box = joined(result[k].region, next.region)) {
          result[k].region = std::move(*box);
          std::move(next.parts.begin(), next.parts.end(), std::back_inserter(result[k].parts));
          taken = true;
        }
      }
      if (taken) {
        changed = true;
      } else {
        result.push_back(std::move(next));
      }
    }
    unions = std::move(result);
  }
}

/// Parts with joined certificates: all in one if the checker accepts it, otherwise by halves.
std::vector<MapCell> merged(std::vector<MapCell> parts, const VariableNames& parameters) {
  if (parts.size() < 2) return parts;
  std::optional<Box> region = parts.front().region;
  std::vector<std::string> certificates;
  for (const MapCell& part : parts) {
    if (region) region = joined(*region, part.region);
    certificates.push_back(part.certificate);
  }
  if (region) {
    if (std::optional<std::string> certificate = merge_certificates(certificates, *region, parameters);
        certificate && checker::check(*certificate).valid) {
      return {{*region, parts.front().verdict, std::move(*certificate)}};
    }
  }
  const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2);
  std::vector<MapCell> result = merged({parts.begin(), middle}, parameters);
  for (MapCell& part : merged({middle, parts.end()}, parameters)) result.push_back(std::move(part));
  return result;
}

}  // namespace

std::vector<MapUnion> map_unions(const std::vector<MapCell>& cells, const VariableNames& parameters) {
  std::vector<MapUnion> unions;
  for (const MapCell& cell : cells) unions.push_back({cell.region, cell.verdict, {cell}});
  join_neighbours(unions);
  for (MapUnion& one : unions) {
    if (one.verdict == Outcome::undecided) {
      one.parts.clear();
    } else {
      one.parts = merged(std::move(one.parts), parameters);
    }
  }
  return unions;
}

}  // namespace limes
