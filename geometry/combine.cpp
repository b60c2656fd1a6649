// Compiled with -O3, for AVX2 too where the linker can choose at run time; without contraction, so that the results are
// the same everywhere.
#include "geometry/combine_impl.hpp"

#include <algorithm>

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define LIMES_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define LIMES_CLONES
#endif

namespace limes {
namespace {

constexpr std::size_t most = 10;

template <std::size_t taps, bool add>
[[gnu::always_inline]] inline void combine_some(double* __restrict out, const double* const* sources,
                                                const double* weights, std::size_t n) {
  const double* source[taps];
  double weight[taps];
  for (std::size_t t = 0; t < taps; ++t) source[t] = sources[t], weight[t] = weights[t];
  for (std::size_t i = 0; i < n; ++i) {
    double sum = add ? out[i] : 0;
#pragma GCC unroll 10
    for (std::size_t t = 0; t < taps; ++t) sum += weight[t] * source[t][i];
    out[i] = sum;
  }
}

template <bool add>
[[gnu::always_inline]] inline void combine_up_to_most(double* out, const double* const* sources, const double* weights,
                                                      std::size_t taps, std::size_t n) {
  switch (taps) {
    case 1:
      return combine_some<1, add>(out, sources, weights, n);
    case 2:
      return combine_some<2, add>(out, sources, weights, n);
    case 3:
      return combine_some<3, add>(out, sources, weights, n);
    case 4:
      return combine_some<4, add>(out, sources, weights, n);
    case 5:
      return combine_some<5, add>(out, sources, weights, n);
    case 6:
      return combine_some<6, add>(out, sources, weights, n);
    case 7:
      return combine_some<7, add>(out, sources, weights, n);
    case 8:
      return combine_some<8, add>(out, sources, weights, n);
    case 9:
      return combine_some<9, add>(out, sources, weights, n);
    default:
      return combine_some<most, add>(out, sources, weights, n);
  }
}

}  // namespace

LIMES_CLONES void combine(double* out, const double* const* sources, const double* weights, std::size_t taps,
                          std::size_t n) {
  if (taps == 0) std::fill_n(out, n, 0.0);
  for (std::size_t first = 0; first < taps; first += most) {
    const std::size_t count = std::min(most, taps - first);
    if (first == 0)
      combine_up_to_most<false>(out, sources, weights, count, n);
    else
      combine_up_to_most<true>(out, sources + first, weights + first, count, n);
  }
}

}  // namespace limes
