// SPDX-License-Identifier: MIT
#include "proofs/checker/interval.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

/// A box between cuts that are numbered in their order along each axis; never empty.
struct Span {
  long lower, upper;
};
using Cell = std::vector<Span>;

bool covered(const Cell& cell, const std::vector<const Cell*>& leaves, Budget& budget) {
  budget.work(200 + 100. * static_cast<double>(leaves.size() * (cell.size() + 1)));
  std::vector<const Cell*> touching;
  for (const Cell* leaf : leaves) {
    bool contains = true, meets = true;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      contains = contains && (*leaf)[k].lower <= cell[k].lower && (*leaf)[k].upper >= cell[k].upper;
      meets = meets && (*leaf)[k].lower < cell[k].upper && (*leaf)[k].upper > cell[k].lower;
    }
    if (contains) return true;
    if (meets) touching.push_back(leaf);
  }
  // A leaf that meets the cell without containing it ends inside the cell. Splitting at the middle one of these ends
  // along the axis that has the most keeps the recursion shallow.
  std::size_t axis = 0;
  std::vector<long> ends;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    std::vector<long> inner;
    for (const Cell* leaf : touching)
      for (const long end : {(*leaf)[k].lower, (*leaf)[k].upper})
        if (cell[k].lower < end && end < cell[k].upper) inner.push_back(end);
    std::sort(inner.begin(), inner.end());
    inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
    if (inner.size() > ends.size()) axis = k, ends = std::move(inner);
  }
  if (ends.empty()) return false;
  Cell low = cell, high = cell;
  low[axis].upper = high[axis].lower = ends[ends.size() / 2];
  return covered(low, touching, budget) && covered(high, touching, budget);
}

}  // namespace

bool is_inside(const Region& inner, const Region& outer) {
  for (std::size_t k = 0; k < inner.size(); ++k)
    if (inner[k].lower < outer[k].lower || outer[k].upper < inner[k].upper) return false;
  return true;
}

bool covers(const std::vector<Region>& leaves, const Region& region, Budget& budget) {
  std::vector<Cell> cells(leaves.size() + 1, Cell(region.size()));  // the last one is the region
  for (std::size_t k = 0; k < region.size(); ++k) {
    std::vector<std::pair<const Cut*, long*>> cuts;
    double size = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Interval& interval = i < leaves.size() ? leaves[i][k] : region[k];
      cuts.insert(cuts.end(), {{&interval.lower, &cells[i][k].lower}, {&interval.upper, &cells[i][k].upper}});
      size = std::max({size, limbs(interval.lower.value), limbs(interval.upper.value)});
    }
    budget.work(40. * static_cast<double>(cuts.size()) * (100 + size));
    std::sort(cuts.begin(), cuts.end(), [](const auto& x, const auto& y) { return *x.first < *y.first; });
    *cuts[0].second = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
      *cuts[i].second = *cuts[i - 1].second + (*cuts[i - 1].first < *cuts[i].first ? 1 : 0);
  }
  std::vector<const Cell*> pieces;
  for (std::size_t i = 0; i < leaves.size(); ++i) pieces.push_back(&cells[i]);
  return covered(cells.back(), pieces, budget);
}

}  // namespace limes::checker
