#include "analysis/surface/characteristic_map.hpp"

#include "algebra/error.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes {
namespace {

using Number = ApproxMapNumber;

Number operator+(const Number& x, const Number& y) { return {x.value + y.value, x.slope + y.slope, x.error + y.error}; }
Number operator-(const Number& x, const Number& y) { return {x.value - y.value, x.slope - y.slope, x.error + y.error}; }
Number operator-(const Number& x) { return {-x.value, -x.slope, x.error}; }
Number operator*(double c, const Number& x) { return {c * x.value, c * x.slope, std::abs(c) * x.error}; }
double magnitude(const Number& x) { return std::abs(x.value) + std::abs(x.slope) + x.error; }
Number operator*(const Number& x, const Number& y) {
  const double product = std::abs(x.slope * y.slope);
  return {x.value * y.value, x.value * y.slope + x.slope * y.value, product + magnitude(x) * y.error + magnitude(y) * x.error};
}
/// 1/(v + w s + e) = (1 - w s/v)/v + ...
Number inverse(const Number& x) {
  const double slope = -x.slope / (x.value * x.value), least = std::abs(x.value) - std::abs(x.slope) - x.error;
  const double rest = x.slope * x.slope / (x.value * x.value * least) + x.error / (least * least);
  return {1 / x.value, slope, rest};
}

struct Ends {
  double lower, upper;
};
Ends ends(const Number& x) {
  const double r = std::abs(x.slope) + x.error;
  return {x.value - r, x.value + r};
}
Ends product(const Ends& x, const Ends& y) {
  const auto [low, high] = std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
  return {low, high};
}

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
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(value);
    Eigen::Index best = 0;
    for (Eigen::Index i = 1; i < n; ++i) {
      if (std::abs(solver.eigenvalues()(i)) > std::abs(solver.eigenvalues()(best))) best = i;
    }
    const double lambda = solver.eigenvalues()(best).real();
    Eigen::VectorXd v = solver.eigenvectors().col(best).real();
    if (!(lambda > 0) || std::abs(solver.eigenvalues()(best).imag()) > 1e-9 * lambda || std::abs(v(0)) < 1e-9)
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

/// Values with indices from a and b on.
struct ApproxCharacteristicMap::Field {
  int first_a = 0, first_b = 0;
  std::vector<std::vector<Ends>> rows;  // by a
};

namespace {

/// New data from old ones in one direction, from `first` to `last`; the mask's first index is `lowest`.
std::vector<Ends> refined(const std::vector<Ends>& old, int old_first, const std::vector<double>& mask, int lowest, int first, int last) {
  std::vector<Ends> result;
  for (int i = first; i <= last; ++i) {
    Ends sum{0, 0};
    for (int k = (i - lowest) & 1; k < int(mask.size()); k += 2) {
      const double w = mask[std::size_t(k)];
      const Ends& x = old[std::size_t((i - lowest - k) / 2 - old_first)];
      sum.lower += w * (w > 0 ? x.lower : x.upper);
      sum.upper += w * (w > 0 ? x.upper : x.lower);
    }
    result.push_back(sum);
  }
  return result;
}

std::vector<std::vector<Ends>> transpose(const std::vector<std::vector<Ends>>& rows) {
  std::vector<std::vector<Ends>> result(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  }
  return result;
}

/// The hulls of `size` successive elements.
std::vector<Ends> hulls(const std::vector<Ends>& data, int size) {
  std::vector<Ends> result;
  for (std::size_t i = 0; i + std::size_t(size) <= data.size(); ++i) {
    Ends hull = data[i];
    for (std::size_t k = i + 1; k < i + std::size_t(size); ++k)
      hull = {std::min(hull.lower, data[k].lower), std::max(hull.upper, data[k].upper)};
    result.push_back(hull);
  }
  return result;
}

}  // namespace

/// Data after `level` steps on which the limit on the cells reach 2^level <= a < 2 reach 2^level, 0 <= b < 2 reach 2^level depends.
ApproxCharacteristicMap::Field ApproxCharacteristicMap::field(const std::function<Number(int, int)>& data, bool by_a, bool by_b,
                                                              int level) const {
  const auto size = [&](bool difference) { return 2 * last_ - (dual_ ? 1 : 0) - (difference ? 1 : 0); };
  const auto last = [&](bool difference, int l) { return ((2 * reach()) << l) - 2 - reach() + size(difference); };
  Field field{0, -reach(), {}};
  for (int a = 0; a <= last(by_a, 0); ++a) {
    field.rows.emplace_back();
    for (int b = -reach(); b <= last(by_b, 0); ++b) field.rows.back().push_back(ends(data(a, b)));
  }
  const int lowest = dual_ ? 1 - last_ : -last_;
  for (int l = 1; l <= level; ++l) {
    const int first_a = (reach() << l) - reach();
    for (auto& row : field.rows)
      row = refined(row, -reach(), by_b ? derived_ : mask_, lowest + (by_b ? 1 : 0), -reach(), last(by_b, l));
    field.rows = transpose(field.rows);
    for (auto& row : field.rows)
      row = refined(row, field.first_a, by_a ? derived_ : mask_, lowest + (by_a ? 1 : 0), first_a, last(by_a, l));
    field.rows = transpose(field.rows);
    field.first_a = first_a;
  }
  return field;
}

ApproxCharacteristicMap::Margins ApproxCharacteristicMap::margins(int level) const {
  const auto limits = [&](const std::function<Number(int, int)>& data, bool by_a, bool by_b) {
    const auto size = [&](bool difference) { return 2 * last_ - (dual_ ? 1 : 0) - (difference ? 1 : 0); };
    std::vector<std::vector<Ends>> rows = field(data, by_a, by_b, level).rows;
    for (auto& row : rows) row = hulls(row, size(by_b));
    rows = transpose(rows);
    for (auto& row : rows) row = hulls(row, size(by_a));
    rows = transpose(rows);
    const double beyond = ((by_a ? derived_bound_ : mask_bound_) * (by_b ? derived_bound_ : mask_bound_) - 1) / 2;
    for (auto& row : rows) {
      for (Ends& e : row) {
        const double more = beyond * (e.upper - e.lower);
        e = {e.lower - more, e.upper + more};
      }
    }
    return rows;
  };
  const auto derivative = [&](Number Pair::*part, int da, int db) {
    return limits([&](int a, int b) { return at(a + da, b + db).*part - at(a, b).*part; }, da != 0, db != 0);
  };
  const auto xa = derivative(&Pair::x, 1, 0), ya = derivative(&Pair::y, 1, 0);
  const auto xb = derivative(&Pair::x, 0, 1), yb = derivative(&Pair::y, 0, 1);
  const Number c{cosine_, radius_, 0}, square = Number{1, 0, 0} - c * c;
  const auto inward = limits([&](int a, int b) { return c * at(a, b).x + square * at(a, b).y; }, false, false);
  double least_jacobian = 1e300, greatest_jacobian = 0, least_inward = 1e300, greatest_inward = 0;
  for (std::size_t i = 0; i < xa.size(); ++i) {
    for (std::size_t j = 0; j <= i + std::size_t(reach() << level); ++j) {
      const Ends left = product(xa[i][j], yb[i][j]), right = product(xb[i][j], ya[i][j]);
      least_jacobian = std::min(least_jacobian, left.lower - right.upper);
      greatest_jacobian = std::max(greatest_jacobian, left.upper - right.lower);
      least_inward = std::min(least_inward, inward[i][j].lower);
      greatest_inward = std::max(greatest_inward, inward[i][j].upper);
    }
  }
  return {least_jacobian / greatest_jacobian, least_inward / greatest_inward};
}

std::vector<std::vector<std::complex<double>>> ApproxCharacteristicMap::samples(int level) const {
  // Control points after some more steps are close to the limit; those of a dual scheme lie half a step beside the lines of the grid.
  constexpr int more = 3;
  const double sine = std::sqrt(1 - cosine_ * cosine_);
  const auto part = [&](Number Pair::*which) {
    return field([&](int a, int b) { return Number{(at(a, b).*which).value, 0, 0}; }, false, false, level + more);
  };
  const Field x = part(&Pair::x), y = part(&Pair::y);
  std::vector<std::vector<std::complex<double>>> result;
  const auto value = [&](const Field& f, int a, int b) {
    const auto one = [&](int i, int j) { return f.rows[std::size_t(i - f.first_a)][std::size_t(j - f.first_b)].lower; };
    return dual_ ? (one(a, b) + one(a - 1, b) + one(a, b - 1) + one(a - 1, b - 1)) / 4 : one(a, b);
  };
  for (int a = reach() << level; a <= (2 * reach()) << level; ++a) {
    result.emplace_back();
    for (int b = 0; b <= a; ++b) result.back().emplace_back(value(x, a << more, b << more), sine * value(y, a << more, b << more));
  }
  return result;
}

namespace {

/// Signs as clear as this are found by the checker, too, whose bounds are rigorous.
constexpr double clear = 0.02;

std::optional<int> clear_level(const ApproxCharacteristicMap& map) {
  for (int level = 1; level <= 6; ++level) {
    const auto [jacobian, inward] = map.margins(level);
    if (jacobian > clear && inward > clear) return level;
  }
  return std::nullopt;
}

bool append_pieces(const RingRule& rule, int rings, const Rational& from, const Rational& to, std::vector<MapPiece>& pieces) {
  const double low = approx_double(from), high = approx_double(to);
  try {
    if (const auto level = clear_level({rule, rings, std::nullopt, (low + high) / 2, (high - low) / 2})) {
      pieces.push_back({to, *level});
      return true;
    }
  } catch (const DomainError&) {  // too wide
  }
  if (high - low < 1. / 1024) return false;
  const Rational middle = (from + to) / 2;
  return append_pieces(rule, rings, from, middle, pieces) && append_pieces(rule, rings, middle, to, pieces);
}

}  // namespace

std::optional<int> approx_map_level(const RingRule& rule, int rings, int valence) {
  return clear_level({rule, rings, valence, std::cos(std::numbers::pi / valence)});
}

std::vector<MapPiece> approx_map_pieces(const RingRule& rule, int rings, const Rational& start) {
  std::vector<MapPiece> pieces;
  return append_pieces(rule, rings, start, 1, pieces) ? pieces : std::vector<MapPiece>{};
}

}  // namespace limes
