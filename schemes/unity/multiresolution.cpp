#include "schemes/unity/multiresolution.hpp"

#include "algebra/error.hpp"
#include "algebra/matrix/exact_solve.hpp"
#include "algebra/polynomial/polynomial.hpp"
#include "schemes/unity/multiresolution_impl.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace limes {
namespace multiresolution_impl {
namespace {

/// q for the shifts 2i - K, i = 1 .. K - 1, without extension: column i - 1. Of all solutions of BQ = I the one with
/// sum_j p_j q_j = 0; the others differ by multiples of p.
RationalMatrix particular_solutions(const std::vector<Rational>& p) {
  const int K = static_cast<int>(p.size());
  RationalMatrix system(K, K), right(K, K - 1);
  for (int i = 1; i < K; ++i) {
    right(i - 1, i - 1) = 1;
    for (int j = 1; j <= K; ++j) {  // b_{K - 2i + j} = (-1)^j p_{2i - j + 1}, all counted from 1
      const int k = 2 * i - j + 1;
      if (k >= 1 && k <= K) system(i - 1, j - 1) = j % 2 == 0 ? p[std::size_t(k - 1)] : -p[std::size_t(k - 1)];
    }
  }
  for (int j = 0; j < K; ++j) system(K - 1, j) = p[std::size_t(j)];
  std::optional<RationalMatrix> q = exact_solve(system, right);
  if (!q) throw InternalError("the hard constraints of a mask without symmetric zeros are dependent");
  return *std::move(q);
}

}  // namespace

std::vector<Candidate> exact_candidates(const std::vector<Rational>& p, int extension) {
  const int K = static_cast<int>(p.size()), base = K - extension, freedom = extension / 2 + 1;
  const RationalMatrix particular = particular_solutions({p.begin(), p.end() - extension});
  std::vector<Candidate> result;
  for (int i = 1; i <= K - 1 - extension / 2; ++i) {
    // Moved by 2r, the solution for row i - r of the short system solves row i of this one.
    const int r = std::clamp(i - base / 2, 0, extension / 2);
    Candidate candidate{2 * i - K, std::vector<Rational>(p.size()), 0};
    for (int j = 0; j < base; ++j) candidate.q[std::size_t(j + 2 * r)] = particular(j, i - r - 1);
    result.push_back(std::move(candidate));
  }
  // All solutions are q + sum_t w_t p(. - 2t); P^T p(. - 2t) is g, the even autocorrelation of p, moved by t. The normal
  // equations are Toeplitz, with the autocorrelation of g.
  std::vector<Rational> g;
  for (int lag = -K / 2; lag <= K / 2; ++lag) g.push_back(correlation(p, p, 0, lag));
  const auto g_at = [&](int lag) { return std::abs(lag) <= K / 2 ? g[std::size_t(lag + K / 2)] : Rational(0); };
  RationalMatrix system(freedom, freedom), right(freedom, static_cast<int>(result.size()));
  for (int t = 0; t < freedom; ++t) {
    Rational h = 0;
    for (int lag = -K; lag <= K; ++lag) h += g_at(lag) * g_at(lag + t);
    for (int s = 0; s + t < freedom; ++s) system(s, s + t) = system(s + t, s) = h;
  }
  for (std::size_t c = 0; c < result.size(); ++c) {
    for (int lag = -K / 2; lag <= K / 2; ++lag) {
      const Rational residual = correlation(p, result[c].q, 0, lag);
      result[c].squared_error += residual * residual;
      for (int t = 0; t < freedom; ++t) right(t, int(c)) -= g_at(lag + t) * residual;
    }
  }
  const std::optional<RationalMatrix> w = exact_solve(system, right);
  if (!w) throw InternalError("the normal equations of a non-zero mask are singular");
  for (std::size_t c = 0; c < result.size(); ++c) {
    for (int t = 0; t < freedom; ++t) {
      result[c].squared_error -= (*w)(t, int(c)) * right(t, int(c));
      for (int j = 0; j < base; ++j) result[c].q[std::size_t(j + 2 * t)] += (*w)(t, int(c)) * p[std::size_t(j)];
    }
  }
  return result;
}

}  // namespace multiresolution_impl

namespace {

using multiresolution_impl::Candidate;

void check(const std::vector<Rational>& mask, const MultiresolutionOptions& options) {
  if (mask.size() < 2) throw InputError("a mask with a single entry has no multiresolution");
  if (mask.size() > max_mask_length) throw LimitError(fmt::format("a mask of more than {} entries", max_mask_length));
  if (options.extension < 0 || options.extension > max_extension || options.extension % 2 != 0)
    throw InputError(fmt::format("the extension must be even, from 0 to {}", max_extension));
  if (options.digits < 20 || options.digits > 1000) throw InputError("the precision must be 20 to 1000 digits");
  if (options.threshold && *options.threshold < 0) throw InputError("the threshold is negative");
  std::vector<Rational> part[2];
  for (std::size_t i = 0; i < mask.size(); ++i) part[i % 2].push_back(mask[i]);
  if (gcd(Polynomial(part[0]), Polynomial(part[1])).degree() == 0) return;
  throw InputError("the even and the odd part of the mask have a common zero, so no banded filters reverse the scheme");
}

std::vector<Candidate> candidates(const std::vector<Rational>& p, int extension,
                                  const MultiresolutionOptions& options) {
  switch (options.arithmetic) {
    case Arithmetic::exact:
      return multiresolution_impl::exact_candidates(p, extension);
    case Arithmetic::multiprecision:
      return multiresolution_impl::approx_candidates_multiprecision(p, extension, options.digits);
    case Arithmetic::binary64:
      break;
  }
  return multiresolution_impl::approx_candidates_binary64(p, extension);
}

/// The part of a number that rounding may change, in comparisons.
Rational tolerance(const MultiresolutionOptions& options) {
  if (options.arithmetic == Arithmetic::exact) return 0;
  return power(Rational(10), options.arithmetic == Arithmetic::binary64 ? -8 : -options.digits / 2);
}

/// The first in the order: smaller error, smaller modulus of the shift, negative shift.
const Candidate& best(const std::vector<Candidate>& list, const MultiresolutionOptions& options) {
  if (options.shift) {
    for (const Candidate& c : list) {
      if (c.shift == *options.shift) return c;
    }
    throw InputError(fmt::format("no filters of this length have the shift {}: it is even, from {} to {}",
                                 *options.shift, list.front().shift, list.back().shift));
  }
  Rational least = list.front().squared_error;
  for (const Candidate& c : list) least = std::min(least, c.squared_error);
  const Rational limit = least + tolerance(options) * (1 + abs(least));
  const Candidate* result = nullptr;
  for (const Candidate& c : list) {  // by increasing shift
    if (c.squared_error <= limit && (!result || std::abs(c.shift) < std::abs(result->shift))) result = &c;
  }
  return *result;
}

}  // namespace

Multiresolution find_multiresolution(const std::vector<Rational>& mask, const MultiresolutionOptions& options,
                                     const Stop& stop) {
  check(mask, options);
  std::vector<Rational> p = mask;
  if (p.size() % 2 != 0) p.emplace_back(0);
  Multiresolution result;
  // A shift that is asked for may exist for the longest filters only.
  for (int l = options.shift && !options.threshold ? options.extension : 0; l <= options.extension; l += 2) {
    stop.check();
    p.resize((mask.size() + 1) / 2 * 2 + std::size_t(l));
    const std::vector<Candidate> list = candidates(p, l, options);
    const Candidate& chosen = best(list, options);
    const bool better = result.steps.empty() || chosen.squared_error < result.squared_error * (1 - tolerance(options));
    result.steps.push_back({l, chosen.shift, chosen.squared_error});
    if (better) {
      result.bank = alternated_bank(p, chosen.q, chosen.shift, l);
      result.squared_error = chosen.squared_error;
    }
    result.threshold_reached = !options.threshold || result.squared_error <= *options.threshold * *options.threshold;
    if (options.threshold && result.threshold_reached) break;
  }
  return result;
}

}  // namespace limes
