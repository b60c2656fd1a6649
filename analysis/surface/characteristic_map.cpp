#include "analysis/surface/characteristic_map.hpp"

#include "algebra/error.hpp"
#include "analysis/eigen_impl.hpp"
#include "analysis/surface/map_number_impl.hpp"

#include <Eigen/LU>

#include <map>

namespace limes {
namespace {

using namespace approx_map;

/// Weights of Fourier block 1 at mu = 1: sum_k weight_k omega^k on every point of a sector but the vertex.
using BlockRow = std::map<RingPoint, std::map<int, double>>;

double weight_at(const RationalFunction& weight, std::optional<int> valence) {
  if (valence) {
    const Rational point[] = {Rational(1), Rational(*valence)};
    return approx_double(weight(point));
  }
  const RationalFunction limit = weight.substitute(0, Rational(1));
  if (!limit.is_constant()) throw InputError("a weight of the blocks 1 and n - 1 depends on the valence");
  return approx_double(limit.constant_value());
}

BlockRow block_row(const RingRule& rule, RingPoint point, std::optional<int> valence) {
  BlockRow row;
  for (const RingTerm& term : rule.at(point)) {
    if ((!rule.dual && term.point == RingPoint{}) || term.harmonic == 0) continue;
    if (term.harmonic > 1) throw InputError("a mean with a harmonic above 1 is not supported here");
    if (term.harmonic == 1) row[term.point][0] += weight_at(term.weight, valence) / 2;
    else row[term.point][term.sector] += weight_at(term.weight, valence);
  }
  return row;
}

/// 2 a(z) / (1 + z).
std::vector<double> derived(const std::vector<double>& mask) {
  std::vector<double> result;
  double last = 0;
  for (const double a : mask) result.push_back(last = 2 * a - last);
  result.pop_back();
  return result;
}

/// The norm of 8 steps, a little more than sup_x sum_i |phi(x - i)|.
double approx_lebesgue_constant(const std::vector<double>& mask) {
  std::vector<double> power{1};
  constexpr int level = 8;
  for (int l = 0; l < level; ++l) {
    std::vector<double> next(2 * power.size() + mask.size());
    for (std::size_t i = 0; i < power.size(); ++i) {
      for (std::size_t j = 0; j < mask.size(); ++j) next[2 * i + j] += power[i] * mask[j];
    }
    power = std::move(next);
  }
  std::vector<double> rows(std::size_t(1) << level);
  for (std::size_t i = 0; i < power.size(); ++i) rows[i % rows.size()] += std::abs(power[i]);
  const double norm = *std::max_element(rows.begin(), rows.end());
  return norm + 0.1 * (norm - 1);
}

}  // namespace

/// The eigenvector: unknowns are x on a spoke, where y = 0; y on the diagonal, where x = C y; x and y of the other points with a > b.
struct ApproxMapBuilder {
  const RingRule& rule;
  std::optional<int> valence;
  using Pair = ApproxCharacteristicMap::Pair;
  Number one{1, 0, 0}, zero{}, cosine, square;  // square = S^2
  std::map<int, Pair> powers = {};
  std::map<RingPoint, std::size_t> place = {};
  std::size_t size = 0;
  std::map<RingPoint, Pair> values = {};
  Number eigenvalue = {};

  ApproxMapBuilder(const RingRule& of, std::optional<int> n, double c, double radius) : rule(of), valence(n), cosine{c, radius, 0} {
    square = one - cosine * cosine;
    powers[0] = {one, zero};
    powers[1] = {2 * (cosine * cosine) - one, 2 * cosine};
  }

  Pair times(const Pair& u, const Pair& v) const { return {u.x * v.x - square * u.y * v.y, u.x * v.y + u.y * v.x}; }
  const Pair& power(int k) {
    if (const auto found = powers.find(k); found != powers.end()) return found->second;
    return powers[k] = k < 0 ? Pair{power(-k).x, -power(-k).y} : times(power(k - 1), powers[1]);
  }
  Pair weight(const std::map<int, double>& by_sector) {
    Pair sum{zero, zero};
    for (const auto& [k, w] : by_sector) sum = {sum.x + w * power(k).x, sum.y + w * power(k).y};
    return sum;
  }
  Pair transposed(const Pair& v) { return times(power(1), {v.x, -v.y}); }
  bool is_spoke(RingPoint p) const { return !rule.dual && p.b == 0; }
  std::vector<Pair> columns(RingPoint p) {
    if (p.b > p.a) {
      std::vector<Pair> result = columns({p.b, p.a});
      for (Pair& v : result) v = transposed(v);
      return result;
    }
    if (is_spoke(p)) return {{one, zero}};
    if (p.a == p.b) return {{cosine, one}};
    return {{one, zero}, {zero, one}};
  }

  std::vector<Number> matrix(int rings) {
    for (const RingPoint& p : sector_points(rule.dual, rings)) {
      if (p.b > p.a) continue;
      place[p] = size;
      size += is_spoke(p) || p.a == p.b ? 1 : 2;
    }
    std::vector<Number> entries(size * size);
    for (const auto& [point, row] : place) {
      for (const auto& [old, by_sector] : block_row(rule, point, valence)) {
        const auto found = place.find({std::max(old.a, old.b), std::min(old.a, old.b)});
        if (found == place.end()) throw InputError("the rings are not invariant");
        const Pair w = weight(by_sector);
        std::size_t column = found->second;
        for (const Pair& unit : columns(old)) {
          const Pair value = times(w, unit);
          Number* entry = &entries[row * size + column++];
          *entry = *entry + (point.a == point.b ? value.y : value.x);
          if (point.a != point.b && !is_spoke(point)) entry[size] = entry[size] + value.y;
        }
      }
    }
    return entries;
  }

  /// (lambda, v) -> (A - lambda) v with v_0 = 1: the solution at s = 0, its derivative by s, and a bound of the rest by iteration.
  void solve(int rings) {
    const std::vector<Number> A = matrix(rings);
    const auto n = Eigen::Index(size);
    Eigen::MatrixXd value(n, n), slope(n, n), error(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        const Number& a = A[std::size_t(i * n + j)];
        value(i, j) = a.value, slope(i, j) = a.slope, error(i, j) = a.error;
      }
    }
    const ApproxEigenpairs pairs = approx_eigenpairs(value);
    Eigen::Index best = 0;
    for (Eigen::Index i = 1; i < n; ++i) {
      if (std::abs(pairs.values(i)) > std::abs(pairs.values(best))) best = i;
    }
    const double lambda = pairs.values(best).real();
    Eigen::VectorXd v = pairs.vectors.col(best).real();
    if (!(lambda > 0) || std::abs(pairs.values(best).imag()) > 1e-9 * lambda || std::abs(v(0)) < 1e-9)
      throw DomainError("block 1 has no positive dominant eigenvalue");
    v /= v(0);
    Eigen::MatrixXd derivative = value - lambda * Eigen::MatrixXd::Identity(n, n);
    derivative.col(0) = -v;
    const Eigen::MatrixXd R = derivative.inverse();
    const Eigen::VectorXd change = -R * (slope * v);
    Eigen::VectorXd vector_change = change;
    vector_change(0) = 0;
    // what is of second order in s, and the errors of A
    const Eigen::VectorXd second = R * (slope * vector_change - change(0) * vector_change);
    Eigen::MatrixXd variation = (R * slope).cwiseAbs() + R.cwiseAbs() * error;
    variation.col(0).setZero();
    const Eigen::VectorXd rest = second.cwiseAbs() + R.cwiseAbs() * (error * (v.cwiseAbs() + vector_change.cwiseAbs()));
    Eigen::VectorXd bound = rest;
    for (int step = 0; step < 40; ++step) {
      Eigen::VectorXd inner = bound;
      inner(0) = 0;
      bound = rest + variation * inner + R.cwiseAbs() * ((std::abs(change(0)) + bound(0)) * inner + bound(0) * vector_change.cwiseAbs());
      if (!(bound.maxCoeff() < 1e3)) throw DomainError("the interval of cosines is too wide");
    }
    eigenvalue = {lambda, change(0), bound(0)};
    if (!(ends(eigenvalue).lower > 0)) throw DomainError("the interval of cosines is too wide");
    for (const auto& [point, first] : place) {
      Pair sum{zero, zero};
      auto i = Eigen::Index(first);
      for (const Pair& unit : columns(point)) {
        const Number x{i == 0 ? 1 : v(i), vector_change(i), i == 0 ? 0 : bound(i)};
        sum = {sum.x + unit.x * x, sum.y + unit.y * x};
        ++i;
      }
      values[point] = sum;
    }
  }

  void extend(int rings, int outermost) {
    const Number factor = inverse(eigenvalue);
    for (int a = rings + (rule.dual ? 0 : 1); a <= outermost; ++a) {
      for (int b = 0; b <= a; ++b) {
        Pair sum{zero, zero};
        for (const auto& [old, by_sector] : block_row(rule, {a, b}, valence)) {
          const Pair value = times(weight(by_sector), at(old));
          sum = {sum.x + value.x, sum.y + value.y};
        }
        values[{a, b}] = {factor * sum.x, factor * sum.y};
      }
    }
  }

  Pair at(RingPoint p) {
    if (p.b > p.a) return transposed(at({p.b, p.a}));
    const auto found = values.find(p);
    if (found == values.end()) throw InputError("there are too few rings");
    return found->second;
  }
  Pair half_plane(int a, int b) {
    if (b < 0) {
      const Pair above = half_plane(a, rule.dual ? -1 - b : -b);
      return {above.x, -above.y};
    }
    if (rule.dual || a > 0) return at({a, b});
    return b == 0 ? Pair{zero, zero} : times(power(1), at({b, 0}));
  }
};

ApproxCharacteristicMap::ApproxCharacteristicMap(const RingRule& rule, int rings, std::optional<int> valence, double cosine, double radius)
    : dual_(rule.dual), last_(rule.curve.symbol.highest()), cosine_(cosine), radius_(radius) {
  for (const RationalFunction& a : rule.curve.symbol.coefficients()) mask_.push_back(weight_at(a, valence));
  derived_ = derived(mask_);
  mask_bound_ = approx_lebesgue_constant(mask_), derived_bound_ = approx_lebesgue_constant(derived_);
  int given_reach = -1;
  for (const auto& [point, terms] : rule.given) given_reach = std::max({given_reach, point.a, point.b});
  if (reach() <= given_reach) throw InputError("a rule of its own reaches into the regular annulus");
  ApproxMapBuilder builder(rule, valence, cosine, radius);
  builder.solve(rings);
  eigenvalue_ = builder.eigenvalue;
  const int outermost = 2 * reach() - 1 + last_ - (dual_ ? 1 : 0);
  builder.extend(rings, outermost);
  for (int a = 0; a <= outermost; ++a) {
    half_plane_.emplace_back();
    for (int b = -reach(); b <= outermost; ++b) half_plane_.back().push_back(builder.half_plane(a, b));
  }
}

}  // namespace limes
