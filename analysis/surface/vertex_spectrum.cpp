#include "analysis/surface/vertex_spectrum.hpp"

#include "algebra/error.hpp"
#include "algebra/number/elementary.hpp"
#include "algebra/polynomial/complex_roots.hpp"
#include "algebra/polynomial/factorisation.hpp"
#include "analysis/surface/cosine_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace limes {
namespace {

enum Variable { mu, valence, cosine, lambda };  // of the factors below

/// A factor of a characteristic polynomial in the four variables, and how often it occurs.
struct Factor {
  MultivariatePolynomial polynomial;
  int multiplicity = 1;

  std::vector<MultivariatePolynomial> in_lambda() const {
    std::vector<MultivariatePolynomial> result;
    static constexpr int place[] = {0, 1, 2, -1};
    for (const MultivariatePolynomial& c : polynomial.coefficients(lambda)) result.push_back(c.mapped(3, place));
    return result;
  }
};
using Factors = std::vector<Factor>;

MultivariatePolynomial derivative_in_lambda(const MultivariatePolynomial& a) {
  std::vector<MultivariatePolynomial::Term> terms = a.terms();
  std::erase_if(terms, [](const auto& t) { return t.exponents[lambda] == 0; });
  for (auto& t : terms) t.coefficient *= t.exponents[lambda]--;
  return MultivariatePolynomial::from_terms(4, terms);
}

void add(Factors& factors, MultivariatePolynomial polynomial, int multiplicity) {
  if (polynomial.degree(lambda) < 1) return;
  const auto same = std::find_if(factors.begin(), factors.end(), [&](const Factor& f) { return f.polynomial == polynomial; });
  if (same == factors.end()) factors.push_back({std::move(polynomial), multiplicity});
  else same->multiplicity += multiplicity;
}

/// Irreducible factors, or only square-free ones when mu occurs (large degrees).
void split_into(Factors& factors, const MultivariatePolynomial& a, int times) {
  if (a.degree(lambda) < 1) return;
  if (a.degree(mu) <= 0) {
    for (auto& [factor, multiplicity] : factorisation(a)) add(factors, std::move(factor), times * multiplicity);
    return;
  }
  // Yun's algorithm over Q(mu, n, c).
  MultivariatePolynomial repeated = gcd(a, derivative_in_lambda(a));
  MultivariatePolynomial rest = *exact_quotient(a, repeated);  // each root once
  for (int multiplicity = 1; rest.degree(lambda) > 0; ++multiplicity) {
    MultivariatePolynomial more = gcd(rest, repeated);
    add(factors, *exact_quotient(rest, more), times * multiplicity);
    repeated = *exact_quotient(repeated, more);
    rest = std::move(more);
  }
}

Factors factors_of(const VertexBlock& block) {
  Factors factors;
  static constexpr int place[] = {0, 1, 2};
  for (const LambdaPolynomialInC& chi : characteristic_factors(block)) {
    MultivariatePolynomial sum(4);
    for (std::size_t k = 0; k < chi.coefficients.size(); ++k)
      sum += chi.coefficients[k].mapped(4, place) * power(MultivariatePolynomial::variable(4, lambda), int(k));
    split_into(factors, sum, 1);
  }
  return factors;
}

Factors substituted(const Factors& factors, Variable variable, const Rational& value) {
  Factors result;
  for (const Factor& f : factors) {
    const MultivariatePolynomial at = f.polynomial.substitute(variable, value);
    if (at.degree(lambda) != f.polynomial.degree(lambda)) throw DomainError("the rules have a pole here");
    split_into(result, at, f.multiplicity);
  }
  return result;
}

/// cos(2 pi j/n), 0 <= 2 j <= n, when it is rational.
std::optional<Rational> rational_cosine(int n, int j) {
  const Polynomial minimal = minimal_polynomial_of_cosine(n, j);
  if (minimal.degree() > 1) return std::nullopt;
  return -minimal.coefficient(0) / minimal.coefficient(1);
}

Interval cosine_enclosure(int n, int j, int bits) {
  const Interval pi = pi_enclosure(bits + 16);
  const Rational turn = Rational(2 * j) / n;
  return {cos_enclosure(pi.upper * turn, bits).lower, cos_enclosure(pi.lower * turn, bits).upper};
}

/// A factor's root or cluster in one block.
struct Root {
  RootCluster enclosure;
  std::vector<std::size_t> factors;
  int multiplicity = 1;
  bool is_cluster = false;
};

bool overlap(const Interval& a, const Interval& b) { return a.lower <= b.upper && b.lower <= a.upper; }
Interval hull(const Interval& a, const Interval& b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }

/// The roots of all factors, those that are not told apart in one cluster.
std::vector<Root> clusters(const Factors& factors, const Box& box, int bits) {
  std::vector<Root> roots;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    for (RootCluster& enclosure : enclose_root_clusters(factors[k].in_lambda(), box, bits)) {
      const int count = enclosure.count;
      roots.push_back({std::move(enclosure), {k}, count * factors[k].multiplicity, count > 1});
    }
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      Root &a = roots[k], &b = roots[i];
      if (!overlap(a.enclosure.re, b.enclosure.re) || !overlap(a.enclosure.im, b.enclosure.im)) continue;
      b.enclosure.re = hull(a.enclosure.re, b.enclosure.re);
      b.enclosure.im = hull(a.enclosure.im, b.enclosure.im);
      b.enclosure.modulus = hull(a.enclosure.modulus, b.enclosure.modulus);
      b.multiplicity += a.multiplicity;
      b.factors.insert(b.factors.end(), a.factors.begin(), a.factors.end());
      b.is_cluster = true;
      roots.erase(roots.begin() + long(k));
      i = std::size_t(-1);  // once more from the start
      break;
    }
  }
  return roots;
}

bool sharp(const std::vector<Root>& roots, int bits) {
  const Rational width = Rational(1) / power(Rational(2), bits);
  return std::all_of(roots.begin(), roots.end(), [&](const Root& r) {
    return !r.is_cluster && r.enclosure.re.width() <= width && r.enclosure.im.width() <= width && r.enclosure.modulus.width() <= width;
  });
}

/// Where moduli overlap, the order is that of equal numbers.
bool comes_first(const VertexEigenvalue& a, const VertexEigenvalue& b) {
  if (!overlap(a.modulus, b.modulus)) return a.modulus.lower > b.modulus.lower;
  if (a.fourier != b.fourier) return a.fourier < b.fourier;
  const bool a_real = a.im.is_point(), b_real = b.im.is_point();
  if (a_real != b_real) return a_real;
  if (!overlap(a.re, b.re)) return a.re.lower > b.re.lower;
  return a.im.lower > b.im.lower;
}

/// Rounded outward to multiples of 2^-(bits + 8).
Interval short_ends(const Interval& x, int bits) {
  if (x.is_point()) return x;
  const Integer scale = Integer(1) << (bits + 8);
  const auto floor = [](const Rational& y) {
    const Integer quotient = numerator(y) / denominator(y);
    return quotient * denominator(y) > numerator(y) ? Integer(quotient - 1) : quotient;
  };
  return {Rational(floor(x.lower * Rational(scale))) / scale, Rational(-floor(-x.upper * Rational(scale))) / scale};
}

std::string text(const MultivariatePolynomial& factor) { return to_string(factor, {"mu", "n", "c", "lambda"}); }

}  // namespace

struct VertexSpectrum::Impl {
  RingRule rule;
  int rings;
  std::vector<int> harmonics;
  /// By the level parameter, if it is exact, and harmonic; -1 is the generic block.
  std::map<std::pair<std::optional<Rational>, int>, Factors> known;

  static VertexBlock at_level(const VertexBlock& block, const LevelParameter& level) {
    if (!level.exact) return block;
    VertexBlock result{block.points, {}};
    for (const LaurentPolynomial& entry : block.entries) result.entries.push_back(entry.substitute(mu, *level.exact));
    return result;
  }

  const Factors& factors(int harmonic, const LevelParameter& level) {
    const auto found = known.find({level.exact, harmonic});
    if (found != known.end()) return found->second;
    const VertexBlock b = harmonic < 0 ? generic_block(rule, rings) : harmonic_block(rule, rings, harmonic);
    return known.emplace(std::pair{level.exact, harmonic}, factors_of(at_level(b, level))).first->second;
  }

  /// Of block j of valence n, as polynomials in lambda, c and perhaps mu.
  Factors factors_at(int n, int j, const LevelParameter& level) {
    std::vector<int> equal;
    for (const int k : harmonics) {
      if ((k - j) % n == 0 || (k + j) % n == 0) equal.push_back(k);
    }
    if (equal.empty()) return substituted(factors(-1, level), valence, n);
    const bool plain = equal.size() == 1 && equal.front() == j && (j == 0 || 2 * j % n != 0);
    return plain ? substituted(factors(j, level), valence, n) : factors_of(at_level(block(rule, rings, n, j), level));
  }

  static std::vector<Root> roots(Factors& all, int n, int j, const LevelParameter& level, int bits, const Stop& stop) {
    const std::optional<Rational> c = rational_cosine(n, j);
    if (c) all = substituted(all, cosine, *c);
    if (c && level.exact) return rational_case(all, bits);
    const int most = level.exact ? 8 * bits + 512 : 4 * bits + 256;
    std::vector<Root> roots;
    for (int precision = 2 * bits + 64;; precision *= 2) {
      stop.check();
      const Interval mu_enclosure = level.exact ? Interval::point(*level.exact) : level.enclosure(precision);
      roots = clusters(all, {mu_enclosure, Interval::point(n), c ? Interval::point(*c) : cosine_enclosure(n, j, precision)}, precision);
      if (sharp(roots, bits)) break;
      if (precision > most) {
        if (!level.exact) break;
        // Two roots that may be equal: decided in Q(c).
        all = told_apart(all, minimal_polynomial_of_cosine(n, j));
      }
      if (precision > 64 * most) throw LimitError("eigenvalues too close to each other to be told apart");
    }
    if (!c || !level.exact) make_exact(roots, all, n, j, bits);
    return roots;
  }

  /// Everything in Q[lambda].
  static std::vector<Root> rational_case(const Factors& all, int bits) {
    std::vector<Root> roots;
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (ComplexRoot& root : enclose_complex_roots(all[k].polynomial.univariate(lambda), bits + 8))
        roots.push_back({{std::move(root.re), std::move(root.im), std::move(root.modulus), 1}, {k}, all[k].multiplicity * root.multiplicity, false});
    }
    return roots;
  }

  /// The pairwise coprime square-free parts of the product over Q(c).
  static Factors told_apart(const Factors& all, const Polynomial& minimal) {
    CosinePolynomial product{Polynomial::constant(1)};
    for (const Factor& f : all) {
      CosinePolynomial factor;
      for (const MultivariatePolynomial& c : f.in_lambda()) factor.push_back(c.univariate(cosine));
      for (int times = 0; times < f.multiplicity; ++times) product = multiply(product, factor, minimal);
    }
    Factors result;
    for (const auto& [part, multiplicity] : square_free_factorisation(product, minimal)) {
      MultivariatePolynomial sum(4);
      for (std::size_t k = 0; k < part.size(); ++k)
        sum += MultivariatePolynomial::from_univariate(4, cosine, part[k]) * power(MultivariatePolynomial::variable(4, lambda), int(k));
      result.push_back({std::move(sum), multiplicity});
    }
    return result;
  }

  /// Rational roots become points: f(r, c) = 0 for all mu when every coefficient of f(r, .) in mu is a multiple of c's minimal polynomial.
  static void make_exact(std::vector<Root>& roots, const Factors& all, int n, int j, int bits) {
    const Polynomial minimal = minimal_polynomial_of_cosine(n, j);
    for (Root& root : roots) {
      if (root.is_cluster || !(root.enclosure.im.is_point() && root.enclosure.im.lower == 0)) continue;
      const Rational r = simplest_between(root.enclosure.re.lower, root.enclosure.re.upper);
      if (denominator(r) >= Integer(1) << (bits / 2)) continue;
      const std::vector<MultivariatePolynomial> in_mu = all[root.factors.front()].polynomial.substitute(lambda, r).coefficients(mu);
      const bool is_root = std::all_of(in_mu.begin(), in_mu.end(), [&](const MultivariatePolynomial& c) {
        return divide(c.univariate(cosine), minimal).second.is_zero();
      });
      if (!is_root) continue;
      root.enclosure.re = Interval::point(r);
      root.enclosure.modulus = Interval::point(abs(r));
    }
  }
};

VertexSpectrum::VertexSpectrum(RingRule rule, int rings) : impl_(new Impl{std::move(rule), 0, {}, {}}) {
  impl_->rings = impl_->rule.invariant_rings(rings);
  if (rings > 0 && impl_->rings != rings)
    throw InputError(fmt::format("new points of {} rings depend on more rings; the least number here is {}", rings, impl_->rings));
  if (!mirror_symmetric(impl_->rule, impl_->rings)) throw InputError("the rules around the extraordinary point are not mirror symmetric");
  impl_->harmonics = harmonics(impl_->rule);
}

VertexSpectrum::~VertexSpectrum() = default;

int VertexSpectrum::rings() const { return impl_->rings; }

int VertexSpectrum::size(int n) const {
  return (impl_->rule.dual ? 0 : 1) + n * int(sector_points(impl_->rule.dual, impl_->rings).size());
}

std::vector<VertexEigenvalue> VertexSpectrum::eigenvalues(int n, const LevelParameter& level, int bits, const Stop& stop) const {
  if (n < 3) throw DomainError("a valence is at least 3");
  if (bits < 16 || bits > 1024) throw DomainError("eigenvalues to fewer than 16 or more than 1024 bits");
  std::vector<VertexEigenvalue> result;
  for (int j = 0; 2 * j <= n; ++j) {
    stop.check();
    Factors all = impl_->factors_at(n, j, level);
    const int blocks = j == 0 || 2 * j == n ? 1 : 2;
    for (Root& root : impl_->roots(all, n, j, level, bits, stop)) {
      VertexEigenvalue e{short_ends(root.enclosure.re, bits), short_ends(root.enclosure.im, bits), short_ends(root.enclosure.modulus, bits),
                         blocks * root.multiplicity, j, root.is_cluster, {}};
      for (const std::size_t k : root.factors) e.factor += (e.factor.empty() ? "" : "; ") + text(all[k].polynomial);
      const auto place = std::find_if(result.begin(), result.end(), [&](const VertexEigenvalue& other) { return comes_first(e, other); });
      result.insert(place, std::move(e));
    }
  }
  return result;
}

}  // namespace limes
