// The loop of the invariant polytope algorithm. Included by the sources of this folder.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace limes {

/// Adds images B_e v_i until all of them are inside of the hull, generation after generation, the farthest first.
/// \param matrices the number of the B_e \param vectors the v_i; `add` appends to them
/// \param expanded in, out: how many vectors have had their images looked at
/// \param try_inside (e, i) -> the norm of B_e v_i as far as it is known; up to `tolerated` it is inside
/// \param add (e, i) -> whether the image could become a vector; otherwise the search is given up
template <class Vectors, class TryInside, class Add>
bool close_generations(std::size_t matrices, const Vectors& vectors, std::size_t& expanded, double tolerated, const TryInside& try_inside,
                       const Add& add) {
  struct Candidate {
    double norm;
    std::size_t matrix, index;
  };
  while (expanded < vectors.size()) {
    std::vector<Candidate> outside;
    for (; expanded < vectors.size(); ++expanded) {
      for (std::size_t e = 0; e < matrices; ++e) {
        if (const double norm = try_inside(e, expanded); norm > tolerated) outside.push_back({norm, e, expanded});
      }
    }
    std::stable_sort(outside.begin(), outside.end(), [](const Candidate& a, const Candidate& b) { return a.norm > b.norm; });
    for (const auto& [norm, e, i] : outside) {
      if (try_inside(e, i) > tolerated && !add(e, i)) return false;
    }
  }
  return true;
}

}  // namespace limes
