// SPDX-License-Identifier: MIT
#include "proofs/checker/certificate.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

/// Long division of a symbol by a monic polynomial in z: the quotient, while `symbol` becomes the remainder.
Bernstein divide(Bernstein& symbol, const std::vector<mpz_class>& divisor, Budget& budget) {
  const std::size_t size = symbol.size(), degree = divisor.size() - 1;
  const std::size_t quotient_count = symbol.count() > degree ? symbol.count() - degree : 0;
  Bernstein quotient{symbol.degrees, std::vector<mpz_class>(quotient_count * size)};
  const double middle = limbs(divisor[degree / 2]);
  budget.work(static_cast<double>(quotient_count * size * divisor.size()) * cost(limbs(symbol) + middle, middle));
  for (std::size_t i = quotient_count * size; i-- > 0;) {
    quotient.coefficients[i] = symbol.coefficients[i + degree * size];
    for (std::size_t k = 0; k <= degree; ++k)
      symbol.coefficients[i + k * size] -= quotient.coefficients[i] * divisor[k];
  }
  symbol.coefficients.resize(std::min(symbol.count(), degree) * size);
  return quotient;
}

}  // namespace

Bernstein on_region(std::vector<Polynomial> polynomials, const Region& region, Region& box, Budget& budget) {
  for (const auto& p : polynomials) budget.work(1000 + 200. * static_cast<double>(p.size()));
  std::vector<std::size_t> axes;
  std::vector<int> degrees;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (region[k].is_point()) {
      for (auto& p : polynomials) p = substitute(p, k, region[k].lower.value, budget);
    } else {
      axes.push_back(k);
      box.push_back(region[k]);
    }
  }
  for (const std::size_t k : axes) {
    degrees.push_back(0);
    for (const auto& p : polynomials) degrees.back() = std::max(degrees.back(), degree(p, k));
  }
  return to_bernstein(polynomials, region, axes, degrees, budget);
}

LocalScheme restrict_to_leaf(const Scheme& scheme, int order, const Region& leaf, Budget& budget) {
  budget.start_leaf();
  LocalScheme local;
  local.arity = scheme.arity;
  std::vector<Polynomial> polynomials = scheme.mask;
  polynomials.push_back(scheme.denominator);
  local.mask = on_region(std::move(polynomials), leaf, local.box, budget);
  const std::vector<int> degrees = local.mask.degrees;
  local.denominator = local.mask.polynomial(scheme.mask.size());

  if (!is_positive(local.denominator.coefficients, degrees, local.box)) {
    for (auto* family : {&local.mask, &local.denominator})
      for (auto& c : family->coefficients) c = -c;
    if (!is_positive(local.denominator.coefficients, degrees, local.box))
      throw Rejected{"denominator", "the common denominator has no proven strict sign"};
  }
  std::size_t first = 0, last = scheme.mask.size();
  while (last > 0 && local.mask.is_zero(last - 1)) --last;
  while (first < last && local.mask.is_zero(first)) ++first;
  const auto begin = local.mask.coefficients.begin();
  const auto place = [&](std::size_t j) { return begin + static_cast<std::ptrdiff_t>(j * local.mask.size()); };
  local.mask.coefficients = std::vector<mpz_class>(place(first), place(last));

  std::vector<mpz_class> factor{1};  // sigma(z)^{m+1}
  budget.work(20. * scheme.arity * scheme.arity * (order + 1) * (order + 1));
  for (int k = 0; k <= order; ++k) {
    std::vector<mpz_class> next(factor.size() + static_cast<std::size_t>(scheme.arity - 1));
    for (std::size_t i = 0; i < factor.size(); ++i)
      for (std::size_t j = i; j < i + static_cast<std::size_t>(scheme.arity); ++j) next[j] += factor[i];
    factor = std::move(next);
  }
  local.remainder = local.mask;
  local.quotient = divide(local.remainder, factor, budget);
  local.has_factor = std::all_of(local.remainder.coefficients.begin(), local.remainder.coefficients.end(),
                                 [](const mpz_class& c) { return c == 0; });
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), static_cast<unsigned long>(scheme.arity), static_cast<unsigned long>(order));
  for (auto& c : local.quotient.coefficients) c *= scale;
  return local;
}

}  // namespace limes::checker
