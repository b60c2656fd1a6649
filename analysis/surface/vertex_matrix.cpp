#include "analysis/surface/vertex_matrix.hpp"

#include "algebra/error.hpp"
#include "algebra/matrix/polynomial_matrix.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace limes {
namespace {

constexpr int variables = 2;  // mu, n

/// `factor` of a harmonic is what the average (1/n) sum_t cos(2 pi harmonic t/n) omega^t becomes in this block.
template <class Factor>
VertexBlock block_with(const RingRule& rule, int rings, bool with_centre, bool constant, const Factor& factor) {
  VertexBlock result;
  result.points = sector_points(rule.dual, rings);
  if (with_centre) result.points.insert(result.points.begin(), RingPoint{0, 0});
  const std::size_t size = result.points.size();
  std::map<RingPoint, std::size_t> column;
  for (std::size_t i = 0; i < size; ++i) column[result.points[i]] = i;
  result.entries.assign(size * size, LaurentPolynomial(variables));
  for (std::size_t row = 0; row < size; ++row) {
    for (const RingTerm& t : rule.at(result.points[row])) {
      if (!rule.dual && t.point == RingPoint{} && !with_centre) continue;  // constant along the sectors
      const auto place = column.find(t.point);
      if (place == column.end()) throw DomainError("vertex matrix: the rings are not invariant");
      RationalFunction weight = t.weight;
      if (t.harmonic >= 0) weight *= RationalFunction::constant(variables, factor(t.harmonic));
      const int exponent = t.harmonic >= 0 || constant ? 0 : t.sector;
      result.entries[row * size + place->second] += LaurentPolynomial(variables, exponent, {std::move(weight)});
    }
  }
  return result;
}

/// A term's place, sectors counted from that of the rule's point.
using Place = std::tuple<RingPoint, int, int>;
using Weights = std::map<Place, RationalFunction>;

Weights weights_of(const std::vector<RingTerm>& terms) {
  Weights sums;
  for (const RingTerm& t : terms) {
    const bool centre = t.point == RingPoint{} && t.harmonic < 0;
    auto [place, is_new] = sums.emplace(Place{t.point, centre ? 0 : t.sector, t.harmonic}, t.weight);
    if (!is_new) place->second += t.weight;
  }
  std::erase_if(sums, [](const auto& entry) { return entry.second.is_zero(); });
  return sums;
}

bool on_spoke(bool dual, RingPoint x) { return !dual && x.b == 0; }

/// The points that the non-zero entries of a matrix join in both directions, and with them their mirror images.
std::vector<std::vector<int>> components(const VertexBlock& block) {
  const int size = block.size();
  std::vector<std::vector<bool>> reaches(static_cast<std::size_t>(size), std::vector<bool>(static_cast<std::size_t>(size)));
  const auto at = [&](int i, int j) -> std::vector<bool>::reference { return reaches[std::size_t(i)][std::size_t(j)]; };
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) at(i, j) = i == j || !block(i, j).is_zero();
  }
  for (int k = 0; k < size; ++k) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; at(i, k) && j < size; ++j) at(i, j) = at(i, j) || at(k, j);
    }
  }
  const auto image = [&](int i) {
    const RingPoint x = block.points[std::size_t(i)];
    const auto found = std::find(block.points.begin(), block.points.end(), RingPoint{x.b, x.a});
    return found == block.points.end() ? i : int(found - block.points.begin());  // spokes are their own images
  };
  std::vector<std::vector<int>> result;
  std::vector<bool> done(std::size_t(size), false);
  for (int i = 0; i < size; ++i) {
    if (done[std::size_t(i)]) continue;
    std::vector<int> members;
    for (int j = 0; j < size; ++j) {
      const bool joined = (at(i, j) && at(j, i)) || (at(image(i), j) && at(j, image(i)));
      if (!joined || done[std::size_t(j)]) continue;
      members.push_back(j);
      done[std::size_t(j)] = true;
    }
    result.push_back(std::move(members));
  }
  return result;
}

const int only_level_and_valence[] = {0, 1};

/// A symmetric sum_i g_i omega^i in c: g_0 + sum 2 g_i T_i(c). Variable 2 is omega, of exponents 0 .. 2 shift with the centre at `shift`.
MultivariatePolynomial in_cosine(const MultivariatePolynomial& g, int shift) {
  std::vector<MultivariatePolynomial> by_power = g.coefficients(2);
  by_power.resize(std::max(by_power.size(), std::size_t(2 * shift + 1)), MultivariatePolynomial(3));
  MultivariatePolynomial sum = by_power[std::size_t(shift)];
  const MultivariatePolynomial c = MultivariatePolynomial::variable(3, 2);
  MultivariatePolynomial before = MultivariatePolynomial::constant(3, 1), chebyshev = c;  // T_0, T_1
  for (std::size_t i = 1; i < by_power.size() - std::size_t(shift) || i <= std::size_t(shift); ++i) {
    const MultivariatePolynomial low = i <= std::size_t(shift) ? by_power[std::size_t(shift) - i] : MultivariatePolynomial(3);
    const MultivariatePolynomial high = std::size_t(shift) + i < by_power.size() ? by_power[std::size_t(shift) + i] : MultivariatePolynomial(3);
    if (!(low == high)) throw DomainError("the characteristic polynomial of a block is not symmetric in omega and 1/omega");
    sum += Rational(2) * high * chebyshev;
    MultivariatePolynomial after = Rational(2) * c * chebyshev - before;
    before = std::move(chebyshev);
    chebyshev = std::move(after);
  }
  return sum;
}

LambdaPolynomialInC characteristic_polynomial_of(const VertexBlock& block, const std::vector<int>& members) {
  const int size = int(members.size());
  // The matrix times q omega^shift has polynomial entries.
  MultivariatePolynomial q = MultivariatePolynomial::constant(variables, 1);
  int shift = 0;
  for (const int i : members) {
    for (const int j : members) {
      const LaurentPolynomial& entry = block(i, j);
      if (entry.is_zero()) continue;
      shift = std::max(shift, -entry.lowest());
      const MultivariatePolynomial d = common_denominator(entry);
      q *= *exact_quotient(d, gcd(q, d));
    }
  }
  PolynomialMatrix matrix(3, size, size);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const LaurentPolynomial& entry = block(members[std::size_t(row)], members[std::size_t(column)]);
      int exponent = entry.is_zero() ? 0 : entry.lowest() + shift;
      for (const MultivariatePolynomial& c : numerators_over(entry, q)) {
        matrix(row, column) += c.mapped(3, only_level_and_valence) * power(MultivariatePolynomial::variable(3, 2), exponent);
        ++exponent;
      }
    }
  }
  const std::vector<MultivariatePolynomial> scaled = characteristic_polynomial(matrix);
  // chi(lambda) = sum_k b_k lambda^k / (q omega^shift)^{size - k}; times q^size.
  LambdaPolynomialInC chi;
  const MultivariatePolynomial denominator = q.mapped(3, only_level_and_valence);
  MultivariatePolynomial content(3);
  for (int k = 0; k <= size; ++k) {
    chi.coefficients.push_back(in_cosine(scaled[std::size_t(k)], shift * (size - k)) * power(denominator, k));
    content = gcd(content, chi.coefficients.back());
  }
  for (MultivariatePolynomial& c : chi.coefficients) c = *exact_quotient(c, content);
  return chi;
}

}  // namespace

VertexBlock VertexBlock::at(const Rational& mu, int n) const {
  VertexBlock result{points, {}};
  for (const LaurentPolynomial& entry : entries) result.entries.push_back(entry.substitute(0, mu).substitute(1, Rational(n)));
  return result;
}

VertexBlock VertexBlock::at_valence(int n) const {
  VertexBlock result{points, {}};
  for (const LaurentPolynomial& entry : entries) result.entries.push_back(entry.substitute(1, Rational(n)));
  return result;
}

VertexBlock generic_block(const RingRule& rule, int rings) {
  return block_with(rule, rings, false, false, [](int) { return Rational(0); });
}

VertexBlock harmonic_block(const RingRule& rule, int rings, int k) {
  const auto factor = [k](int harmonic) { return harmonic != k ? Rational(0) : k == 0 ? Rational(1) : Rational(1) / 2; };
  return block_with(rule, rings, k == 0 && !rule.dual, k == 0, factor);
}

VertexBlock block(const RingRule& rule, int rings, int n, int j) {
  if (n < 3) throw DomainError("a valence is at least 3");
  const auto factor = [n, j](int harmonic) {
    return Rational(int((harmonic - j) % n == 0) + int((harmonic + j) % n == 0)) / 2;
  };
  const bool constant = j % n == 0;
  return block_with(rule, rings, constant && !rule.dual, constant, factor).at_valence(n);
}

std::vector<int> harmonics(const RingRule& rule) {
  std::set<int> found{0};
  for (const auto& [point, terms] : rule.given) {
    for (const RingTerm& t : terms) found.insert(std::max(t.harmonic, 0));
  }
  return {found.begin(), found.end()};
}

bool rows_sum_to_one(const RingRule& rule, int rings) {
  std::vector<RingPoint> points = sector_points(rule.dual, rings);
  if (!rule.dual) points.push_back({0, 0});
  const RationalFunction one = RationalFunction::constant(variables, 1);
  return std::all_of(points.begin(), points.end(), [&](const RingPoint& point) {
    RationalFunction sum(variables);
    for (const RingTerm& t : rule.at(point)) {
      if (t.harmonic <= 0) sum += t.weight;
    }
    return sum == one;
  });
}

bool mirror_symmetric(const RingRule& rule, int rings) {
  std::vector<RingPoint> points = sector_points(rule.dual, rings);
  if (!rule.dual) points.push_back({0, 0});
  const auto image = [&](RingPoint x) { return on_spoke(rule.dual, x) ? x : RingPoint{x.b, x.a}; };
  for (const RingPoint& point : points) {
    // The image of the new point of sector 0 lies in sector 1 (on a spoke) or 0.
    const int own_shift = on_spoke(rule.dual, point) && point.a > 0 ? 1 : 0;
    std::vector<RingTerm> mirrored = rule.at(point);
    for (RingTerm& t : mirrored) {
      const bool spoke = on_spoke(rule.dual, t.point) && t.point.a > 0;
      if (t.harmonic < 0) {
        t.sector = (spoke ? 1 : 0) - t.sector - own_shift;
      } else if (t.harmonic > 0 && spoke != (own_shift == 1)) {
        return false;  // cos(2 pi k (t - s)/n) is centred between spokes for one of them only
      }
      t.point = image(t.point);
    }
    if (weights_of(mirrored) != weights_of(rule.at(image(point)))) return false;
  }
  return true;
}

std::vector<LambdaPolynomialInC> characteristic_factors(const VertexBlock& block) {
  std::vector<LambdaPolynomialInC> factors;
  for (const std::vector<int>& members : components(block)) factors.push_back(characteristic_polynomial_of(block, members));
  return factors;
}

LambdaPolynomialInC characteristic_polynomial(const VertexBlock& block) {
  LambdaPolynomialInC product{{MultivariatePolynomial::constant(3, 1)}};
  for (const LambdaPolynomialInC& factor : characteristic_factors(block)) {
    std::vector<MultivariatePolynomial> next(product.coefficients.size() + factor.coefficients.size() - 1, MultivariatePolynomial(3));
    for (std::size_t i = 0; i < product.coefficients.size(); ++i) {
      for (std::size_t k = 0; k < factor.coefficients.size(); ++k) next[i + k] += product.coefficients[i] * factor.coefficients[k];
    }
    product.coefficients = std::move(next);
  }
  return product;
}

}  // namespace limes
