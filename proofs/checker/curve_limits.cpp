// SPDX-License-Identifier: MIT
//
// Bounds of limits of tensor-product schemes from their data: for weights that sum to 1, and their absolute values to at most
// Lambda, a sum lies in the hull of the data it takes, widened by (Lambda - 1)/2 of its width on both sides.
#include "proofs/checker/curve_limits.hpp"

#include <algorithm>
#include <optional>

namespace limes::checker {
namespace {

__extension__ typedef __int128 Wide;
constexpr unsigned long range_bits = 40;

std::int64_t narrowed(Wide x) {
  if (x >= Wide(1) << 60 || x <= -(Wide(1) << 60)) throw Rejected{"map", "the map is too large"};
  return static_cast<std::int64_t>(x);
}

std::int64_t narrowed(const mpz_class& x) {
  if (mpz_sizeinbase(x.get_mpz_t(), 2) > 60) throw Rejected{"map", "the map is too large"};
  return x.get_si();
}

Range outward(const Enclosure& x) {
  mpz_class low, high;
  mpz_fdiv_q_2exp(low.get_mpz_t(), x.lower.get_mpz_t(), enclosure_bits - range_bits);
  mpz_cdiv_q_2exp(high.get_mpz_t(), x.upper.get_mpz_t(), enclosure_bits - range_bits);
  return {narrowed(low), narrowed(high)};
}

Wide floor_quotient(Wide x, std::int64_t y) { return x / y - (x % y < 0 ? 1 : 0); }

/// New data i from old ones, in one direction.
template <typename Get>
Range refined(const IntegerMask& mask, const std::vector<std::int64_t>& weights, int i, const Get& old) {
  const std::int64_t denominator = mask.denominator.get_si();
  Wide low = 0, high = 0;
  for (std::size_t k = static_cast<unsigned>(i - mask.first) % 2; k < weights.size(); k += 2) {
    const std::int64_t w = weights[k];
    const Range& x = old((i - mask.first - static_cast<int>(k)) / 2);
    low += Wide(w) * (w > 0 ? x.lower : x.upper);
    high += Wide(w) * (w > 0 ? x.upper : x.lower);
  }
  return {narrowed(floor_quotient(low, denominator)), narrowed(-floor_quotient(-high, denominator))};
}

/// The least range that contains `size` successive ones.
template <typename Get>
Range hull_of(int from, int size, const Get& old) {
  Range result = old(from);
  for (int i = from + 1; i < from + size; ++i) {
    const Range& x = old(i);
    result.lower = std::min(result.lower, x.lower), result.upper = std::max(result.upper, x.upper);
  }
  return result;
}

[[noreturn]] void fail_smoothness() { throw Rejected{"map", "the curve scheme is not proved to be C1"}; }

/// 2 z a(z) / (1 + z).
IntegerMask derived_mask(const IntegerMask& mask) {
  IntegerMask result{mask.first + 1, {}, mask.denominator};
  mpz_class last = 0;
  for (const mpz_class& a : mask.numerators) {
    last = 2 * a - last;
    result.numerators.push_back(last);
  }
  if (last != 0) fail_smoothness();
  result.numerators.pop_back();
  return result;
}

}  // namespace

mpq_class lebesgue_bound(const IntegerMask& mask, Budget& budget) {
  // Delta S_a = S_b Delta, b = a / (1 + z)
  std::vector<mpz_class> b;
  for (const mpz_class& a : mask.numerators) b.push_back(a - (b.empty() ? mpz_class(0) : b.back()));
  if (b.back() != 0) fail_smoothness();
  b.pop_back();
  mpz_class sums[2];
  for (std::size_t i = 0; i < mask.numerators.size(); ++i) sums[i % 2] += mask.numerators[i];
  if (sums[0] != mask.denominator || sums[1] != mask.denominator) fail_smoothness();
  // |(S_a f)_i - f_{i div 2}| <= K max |Delta f|: the differences of the weights, which sum to 0, summed up
  mpz_class K = 0;
  for (int parity = 0; parity < 2; ++parity) {
    mpz_class total = 0, sum = 0;
    for (int i = std::min(mask.first, 0); i <= std::max(mask.last(), 1); ++i) {
      if ((i & 1) != parity) continue;
      if (i >= mask.first && i <= mask.last()) sum += mask.numerators[static_cast<std::size_t>(i - mask.first)];
      if (i == parity) sum -= mask.denominator;
      total += abs(sum);
    }
    K = std::max(K, total);
  }
  std::vector<mpz_class> power_a{1}, power_b{1};
  mpz_class scale = 1;
  const auto next = [&](std::vector<mpz_class>& power, const std::vector<mpz_class>& factor) {
    std::vector<mpz_class> product(2 * power.size() + factor.size());  // factor(z) power(z^2)
    budget.work(150. * static_cast<double>(power.size() * factor.size()));
    for (std::size_t i = 0; i < power.size(); ++i)
      for (std::size_t j = 0; j < factor.size(); ++j) product[2 * i + j] += power[i] * factor[j];
    power = std::move(product);
  };
  const auto norm = [&](const std::vector<mpz_class>& power, std::size_t step) {
    std::vector<mpz_class> rows(step);
    for (std::size_t i = 0; i < power.size(); ++i) rows[i % step] += abs(power[i]);
    mpq_class result(*std::max_element(rows.begin(), rows.end()), scale);
    result.canonicalize();
    return result;
  };
  // ||S_a^l f|| <= ||S_a^L f|| + sum_{L <= m < l} K ||S_b^m Delta f||, and ||Delta f|| <= 2 ||f||; with q = ||S_b^L|| < 1 the
  // sum is at most (||1|| + .. + ||S_b^{L-1}||) q / (1 - q).
  std::optional<mpq_class> best;
  mpq_class sum_b = 1, twice_k(2 * K, mask.denominator);
  twice_k.canonicalize();
  for (std::size_t level = 1; level <= 10; ++level) {
    next(power_a, mask.numerators), next(power_b, b);
    scale *= mask.denominator;
    const mpq_class q = norm(power_b, std::size_t(1) << level);
    if (q < 1) {
      const mpq_class bound = norm(power_a, std::size_t(1) << level) + twice_k * sum_b * q / (1 - q);
      if (!best || bound < *best) best = bound;
    }
    sum_b += q;
  }
  if (!best) fail_smoothness();
  return *best;
}

bool product_exceeds(const Range& x, const Range& y, const Range& z, const Range& w) {
  const Wide left = std::min({Wide(x.lower) * y.lower, Wide(x.lower) * y.upper, Wide(x.upper) * y.lower, Wide(x.upper) * y.upper});
  const Wide right = std::max({Wide(z.lower) * w.lower, Wide(z.lower) * w.upper, Wide(z.upper) * w.lower, Wide(z.upper) * w.upper});
  return left > right;
}

CurveLimits::CurveLimits(const std::vector<mpq_class>& mask, bool dual, Budget& budget)
    : dual_(dual), last_((static_cast<int>(mask.size()) - (dual ? 0 : 1)) / 2) {
  if (reach() < 1 || reach() > 8) throw Rejected{"map", "the mask has an unsuitable length"};
  for (const mpq_class& a : mask) {
    mpz_class common;
    mpz_lcm(common.get_mpz_t(), mask_.denominator.get_mpz_t(), a.get_den_mpz_t());
    mask_.denominator = common;
  }
  mask_.first = dual ? 1 - last_ : -last_;
  for (const mpq_class& a : mask) {
    mask_.numerators.push_back(a.get_num() * (mask_.denominator / a.get_den()));
    if (abs(mask_.numerators.back()) >= 1 << 24 || mask_.denominator >= 1 << 24)
      throw Rejected{"limits", "the mask has too long fractions"};
  }
  mask_bound_ = lebesgue_bound(mask_, budget);
  derived_ = derived_mask(mask_);
  derived_bound_ = lebesgue_bound(derived_, budget);  // that S_a is C^1, too
}

/// A curve scheme for data or for differences: the cell [m, m+1] depends on the `size` ones from m - reach on.
struct CurveLimits::Direction {
  const IntegerMask& mask;
  const mpq_class& bound;
  int size = 0;
  std::vector<std::int64_t> weights = {};
};

CurveLimits::Direction CurveLimits::direction(bool derived) const {
  Direction result{derived ? derived_ : mask_, derived ? derived_bound_ : mask_bound_,
                   2 * last_ - (dual_ ? 1 : 0) - (derived ? 1 : 0)};
  for (const mpz_class& a : result.mask.numerators) result.weights.push_back(a.get_si());
  return result;
}

double CurveLimits::cost(int level) const {
  const double cells = static_cast<double>(((reach() << level) + 2 * last_)) * ((2 * reach() << level) + 2 * last_);
  return 100. * cells * 2 * last_;
}

Grid CurveLimits::on_annulus(const std::function<Enclosure(int, int)>& data, Part part, int level) const {
  const Direction along_a = direction(part == Part::by_a), along_b = direction(part == Part::by_b);
  const auto last = [&](const Direction& d, int l) { return ((2 * reach()) << l) - 1 - reach() + d.size - 1; };
  Grid grid(0, last(along_a, 0), -reach(), last(along_b, 0));
  for (int a = 0; a <= grid.last_a(); ++a)
    for (int b = -reach(); b <= grid.last_b(); ++b) grid.at(a, b) = outward(data(a, b));
  for (int l = 1; l <= level; ++l) {
    Grid wide((reach() << l) - reach(), last(along_a, l), grid.first_b, grid.last_b());
    for (int a = wide.first_a; a <= wide.last_a(); ++a)
      for (int b = wide.first_b; b <= wide.last_b(); ++b)
        wide.at(a, b) = refined(along_a.mask, along_a.weights, a, [&](int j) -> const Range& { return grid.at(j, b); });
    grid = Grid(wide.first_a, wide.last_a(), -reach(), last(along_b, l));
    for (int a = grid.first_a; a <= grid.last_a(); ++a)
      for (int b = grid.first_b; b <= grid.last_b(); ++b)
        grid.at(a, b) = refined(along_b.mask, along_b.weights, b, [&](int j) -> const Range& { return wide.at(a, j); });
  }

  const mpq_class beyond_exactly = (along_a.bound * along_b.bound - 1) / 2;
  const mpz_class beyond = (beyond_exactly.get_num() << 20) / beyond_exactly.get_den() + 1;  // times 2^-20, rounded up
  if (beyond >= mpz_class(1) << 40) throw Rejected{"map", "the curve scheme is too rough"};
  Grid wide(reach() << level, ((2 * reach()) << level) - 1, grid.first_b, grid.last_b());
  for (int a = wide.first_a; a <= wide.last_a(); ++a)
    for (int b = wide.first_b; b <= wide.last_b(); ++b)
      wide.at(a, b) = hull_of(a - reach(), along_a.size, [&](int i) -> const Range& { return grid.at(i, b); });
  Grid result(wide.first_a, wide.last_a(), 0, wide.last_a());
  for (int a = result.first_a; a <= result.last_a(); ++a) {
    for (int b = 0; b <= a; ++b) {
      const Range hull = hull_of(b - reach(), along_b.size, [&](int i) -> const Range& { return wide.at(a, i); });
      const Wide more = ((Wide(hull.upper) - hull.lower) * beyond.get_si() >> 20) + 1;
      result.at(a, b) = {narrowed(hull.lower - more), narrowed(hull.upper + more)};
    }
  }
  return result;
}

}  // namespace limes::checker
