#include "analysis/uniform/hoelder_exponent.hpp"

#include "algebra/error.hpp"
#include "algebra/number/power_comparison.hpp"
#include "algebra/polynomial/real_roots.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/finite_sections.hpp"

#include <cmath>
#include <limits>

namespace limes {
namespace {

/// The transition operator (T v)_i = sum_j c_{pi-j} v_j, c(z) = b(z) b(1/z), on even sequences supported in |i| <= ceil(N / (p-1)); rows and
/// columns are i, j >= 0. sum_i |b^{[l]}_i|^2 = (T^l delta)_0 grows as its spectral radius, which is an eigenvalue: T maps the cone of
/// sequences with non-negative Fourier transform to itself, and delta is in its interior.
RationalMatrix transition_operator(const std::vector<Rational>& b, int p) {
  const int n = int(b.size()) - 1, size = section_size(n, p) + 1;
  const auto c = [&](int k) {
    Rational sum = 0;
    for (int i = 0; i + std::abs(k) <= n; ++i) sum += b[std::size_t(i)] * b[std::size_t(i + std::abs(k))];
    return sum;
  };
  RationalMatrix result(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) result(i, j) = j == 0 ? c(p * i) : Rational(c(p * i - j) + c(p * i + j));
  }
  return result;
}

/// (k - 1/2) - (log_p rho(T)) / 2.
ExponentBounds sobolev_exponent(const LaurentPolynomial& b, int p, int order, int digits) {
  const Polynomial chi = characteristic_polynomial(transition_operator(b.rational_coefficients(), p));
  const RootInterval radius = isolate_real_roots(chi, power(Rational(1, 10), digits + 2) / 4).back();
  if (radius.lower <= 0) return {};
  const Rational start = order - Rational(1, 2);
  return {start - logarithm_above(radius.upper, p, digits + 1) / 2, start - logarithm_below(radius.lower, p, digits + 1) / 2};
}

/// A short number above norm^{1/level}.
Rational root_above(const Rational& norm, int level) {
  constexpr int bits = 40;
  const Rational unit = power(Rational(1, 2), bits);
  const double approx = std::ldexp(std::pow(approx_double(norm), 1.0 / level), bits);
  if (!std::isfinite(approx)) return norm + 1;
  Rational root = exact_rational(std::ceil(approx)) * unit;
  while (power(root, level) <= norm) root += unit;
  return root;
}

/// JSR <= ||S_b^l||^{1/l}: the rows of products of l sections are parts of the rows of S_b^l.
struct NormBound {
  Rational bound;
  int level = 1;
};

/// The least of these bounds for short l, the level chosen in floating point.
NormBound bound_by_norms(const LaurentPolynomial& b, int p, const Stop& stop) {
  constexpr int max_level = 10;
  constexpr double max_entries = 1e5;
  const int levels = std::min(max_level, static_cast<int>(std::log(max_entries) / std::log(p)));
  const std::vector<double> norms = approx_contractivity_norms(b, p, {}, levels, 0);
  NormBound result;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < norms.size(); ++k) {
    const double root = std::pow(norms[k], 1.0 / static_cast<double>(k + 1));
    if (!(root < least)) continue;
    least = root;
    result.level = static_cast<int>(k) + 1;
  }
  result.bound = root_above(exact_contractivity_norm(b, p, result.level, stop), result.level);
  return result;
}

/// The joint spectral radius of the sections of b. Norms are good in particular for masks that nearly satisfy one sum rule more: then all products have
/// nearly the same radius, which is hard for polytopes, of which few vectors are tried before many.
void bound_radius(const MatrixFamily& sections, const LaurentPolynomial& b, int p, int digits, const PolytopeLimits& limits, HoelderExponent& exponent,
                  const Stop& stop) {
  constexpr std::size_t few_vectors = 60;
  PolytopeLimits few = limits;
  few.max_vectors = std::min(limits.max_vectors, few_vectors);
  std::optional<NormBound> norm;
  try {
    norm = bound_by_norms(b, p, stop);
  } catch (const Interrupted&) {  // the search notices it too
  }
  SpectralRadiusOptions options{.digits = digits, .polytopes = {}};
  if (norm) options.known_upper = norm->bound;
  for (const PolytopeLimits& now : {few, limits}) {
    options.polytopes = now;
    SpectralRadiusBounds found = bound_spectral_radius(sections, options, stop);
    exponent.radius.interrupted = found.interrupted;
    if (found.exact || exponent.radius.blocks.empty() || found.upper < exponent.radius.upper) {
      exponent.radius = std::move(found);
      exponent.level.reset();
    }
    if (exponent.radius.exact) return;
    if (norm && norm->bound < exponent.radius.upper) {
      exponent.radius.upper = norm->bound;
      exponent.level = norm->level;
    }
    const bool narrow = exponent.radius.upper <= exponent.radius.lower * (1 + power(Rational(1, 10), digits));
    // A narrow bound by a polytope is not the end: with more vectors the radius may be found exactly.
    const bool settled = narrow && (exponent.level || limits.max_degree == 1);
    if (exponent.radius.interrupted || settled || now.max_vectors == limits.max_vectors) return;
    options.known_upper = exponent.radius.upper;
  }
}

}  // namespace

MatrixFamily difference_sections(const Mask& mask, int order) {
  const std::optional<LaurentPolynomial> b = difference_symbol(mask, order);
  if (!b) throw DomainError("difference_sections: the sum rules have a lower order");
  const FiniteSections sections(*b, mask.arity);
  MatrixFamily result;
  for (int e = 0; e < mask.arity; ++e) result.push_back(sections.product({e}, {}));
  return result;
}

HoelderExponent bound_hoelder_exponent(const Mask& mask, int digits, const PolytopeLimits& limits, const Stop& stop) {
  if (mask.symbol.variables() != 0) throw DomainError("bound_hoelder_exponent: the mask has parameters");
  HoelderExponent result;
  Rational sum = 0;
  for (const Rational& a : mask.symbol.rational_coefficients()) sum += a;
  if (sum != mask.arity) {
    result.reason = "the coefficients of the mask do not add up to the arity: the scheme has no continuous limits but zero";
    return result;
  }
  result.order = sum_rule_order(mask);
  if (result.order == 0) {
    result.reason = "the symbol has no factor sigma: the scheme does not map constants to constants";
    return result;
  }
  result.stability = prove_stability(mask);
  const int p = mask.arity;
  bound_radius(difference_sections(mask, result.order), *difference_symbol(mask, result.order), p, digits + 1, limits, result, stop);

  if (result.radius.lower <= 0) {
    result.reason = "stopped before a bound of the joint spectral radius was found";
    return result;
  }
  const Rational start = result.order - 1;
  const Rational lower = start - logarithm_above(result.radius.upper, p, digits + 1);
  const Rational upper = start - logarithm_below(result.radius.lower, p, digits + 1);
  if (lower > upper) throw InternalError("the bounds of a Hoelder exponent contradict each other");
  if (lower > 0) {
    result.bounds.lower = lower;
    if (result.stability) result.bounds.upper = upper;
    if (lower == upper && result.stability) result.exact = lower;
  } else {
    result.reason = "the joint spectral radius of the differences is not proved small enough for a continuous limit";
  }
  result.sobolev = sobolev_exponent(*difference_symbol(mask, result.order), p, result.order, digits);
  // sup <= l2 <= (number of terms)^{1/2} sup, for every level, gives these two whether or not the shifts are stable.
  if (result.sobolev.lower && (lower > *result.sobolev.upper || *result.sobolev.lower - Rational(1, 2) > upper))
    throw InternalError("the bounds of the Hoelder and the Sobolev exponent contradict each other");
  if (!result.stability) result.sobolev.upper.reset();
  return result;
}

}  // namespace limes
