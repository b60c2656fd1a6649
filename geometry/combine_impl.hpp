#pragma once

#include <cstddef>

namespace limes {

/// out[i] = sum_t weights[t] sources[t][i] for i < n, in the order of the t; `out` overlaps no source. The inner loop of all
/// filters: contiguous, for both directions of a grid.
void combine(double* out, const double* const* sources, const double* weights, std::size_t taps, std::size_t n);

}  // namespace limes
