// SPDX-License-Identifier: MIT
//
// Theorem E2 (docs/theory.md): the eigenvector of block 1 as an enclosure, its limit's derivatives on the half annulus
// reach <= a <= 2 reach, 0 <= b <= a of the half-plane around spoke 0, and the signs of the Jacobian and of the distance from the sector's
// sides. Numbers are value + slope s for an unknown s in [-1, 1], where cos(pi/n) = C = C_0 + delta s.
#include "proofs/checker/characteristic_map.hpp"

#include <algorithm>
#include <cmath>

namespace limes::checker {
namespace {

constexpr int max_level = 6;

Enclosure exact(double x) {
  if (!std::isfinite(x) || std::abs(x) > 1e9) throw Rejected{"map", "no eigenvector was found"};
  return Enclosure(mpq_class(x));
}
double approximate(const Enclosure& x) {
  return std::ldexp(mpz_class((x.lower + x.upper) >> (enclosure_bits - 63)).get_d(), -64);
}

/// For every |s| <= 1 the number is v + w s with some v in `value`, w in `slope`.
struct Model {
  Enclosure value, slope;
};

Model operator+(const Model& x, const Model& y) { return {x.value + y.value, x.slope + y.slope}; }
Model operator-(const Model& x, const Model& y) { return {x.value - y.value, x.slope - y.slope}; }
Model operator*(const Enclosure& c, const Model& x) { return {c * x.value, c * x.slope}; }
Model operator*(const Model& x, const Model& y) {
  static const Enclosure square(mpq_class(0), mpq_class(1));  // of s
  return {x.value * y.value + x.slope * y.slope * square, x.value * y.slope + x.slope * y.value};
}
Model negative(const Model& x) { return {-x.value, -x.slope}; }
Enclosure range(const Model& x) {
  static const Enclosure s(mpq_class(-1), mpq_class(1));
  return x.value + s * x.slope;
}
/// \pre the range is positive. 1/(v + w s) = 1/v - w s / (v (v + w s))
Model inverse(const Model& x) {
  return {Enclosure(mpq_class(1)) / x.value, -x.slope / (x.value * range(x))};
}

/// x + i S y, S = sin(pi/n); a point of the map in the frame of spoke 0, or a power of omega.
struct Pair {
  Model x, y;
};

}  // namespace

CharacteristicMap::CharacteristicMap(const RingScheme& scheme, const CurveLimits& limits, int rings,
                                     std::optional<int> valence, Budget& budget)
    : scheme_(scheme), limits_(limits), blocks_(ring_blocks(scheme, rings, valence, budget)) {
  if (scheme.given_reach() >= limits_.reach()) throw Rejected{"map", "a rule of its own reaches into the regular annulus"};
  for (int a = rings + (scheme.dual ? 0 : 1); a <= limits_.outermost(); ++a)
    for (int b = 0; b <= a; ++b) outer_[{a, b}] = ring_row(scheme, {a, b}, valence, budget);
}

/// The map for one interval of cosines.
class MapProof {
 public:
  MapProof(const CharacteristicMap& map, const Enclosure& cosine, int level, Budget& budget)
      : map_(map), level_(level), budget_(budget), dual_(map.scheme_.dual) {
    const mpz_class middle = (cosine.lower + cosine.upper) >> 1;
    const mpz_class radius = std::max(mpz_class(cosine.upper - middle), mpz_class(middle - cosine.lower));
    C_ = {Enclosure(middle, middle), Enclosure(radius, radius)};
    one_ = {Enclosure(mpq_class(1)), Enclosure(mpq_class(0))};
    square_ = one_ - C_ * C_;
    const Model twice = C_ + C_;
    powers_[0] = {one_, zero_};
    powers_[1] = {twice * C_ - one_, twice};
  }

  Enclosure run() {
    place_unknowns();
    assemble();
    find_eigenvector();
    verify_eigenvector();
    extend();
    verify_signs();
    return range(lambda_);
  }

 private:
  Pair times(const Pair& x, const Pair& y) const {
    return {x.x * y.x - square_ * x.y * y.y, x.x * y.y + x.y * y.x};
  }
  const Pair& power(int k) {
    const auto found = powers_.find(k);
    if (found != powers_.end()) return found->second;
    const Pair value = k < 0 ? Pair{power(-k).x, negative(power(-k).y)} : times(power(k - 1), powers_[1]);
    return powers_[k] = value;
  }
  Pair weight_at(const Laurent& weight) {
    Pair sum{zero_, zero_};
    for (const auto& [k, c] : weight) {
      const Pair& p = power(k);
      sum = {sum.x + Enclosure(c) * p.x, sum.y + Enclosure(c) * p.y};
    }
    return sum;
  }
  /// The value at (b, a) from that at (a, b): omega times the conjugate.
  Pair transposed(const Pair& v) { return times(power(1), {v.x, negative(v.y)}); }

  /// Real unknowns: x on the spoke, where y = 0; y on the diagonal, where x = C y; else x and y, for a > b.
  void place_unknowns() {
    for (const RingPoint& p : map_.blocks_.points) {
      if (p.b > p.a) continue;
      place_[p] = size_;
      size_ += is_spoke(p) || p.a == p.b ? 1 : 2;
    }
    budget_.work(enclosure_cost * 12. * static_cast<double>(size_ * size_ * (size_ + 8)));
  }
  bool is_spoke(RingPoint p) const { return !dual_ && p.b == 0; }
  /// The values of a point when one unknown is 1 and the others are 0.
  std::vector<Pair> columns(RingPoint p) {
    if (p.b > p.a) {
      std::vector<Pair> result = columns({p.b, p.a});
      for (Pair& v : result) v = transposed(v);
      return result;
    }
    if (is_spoke(p)) return {{one_, zero_}};
    if (p.a == p.b) return {{C_, one_}};
    return {{one_, zero_}, {zero_, one_}};
  }

  void assemble() {
    matrix_.assign(size_ * size_, zero_);
    const std::vector<RingPoint>& points = map_.blocks_.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].b > points[i].a) continue;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const Laurent& entry = map_.blocks_.first.at(i, j);
        if (entry.empty()) continue;
        const Pair weight = weight_at(entry);
        std::size_t column = place_.at({std::max(points[j].a, points[j].b), std::min(points[j].a, points[j].b)});
        for (const Pair& unit : columns(points[j])) {
          const Pair value = times(weight, unit);
          Model* rows = &matrix_[place_.at(points[i]) * size_ + column];
          // By symmetry the spoke's y and the diagonal's x - C y vanish.
          const bool diagonal = points[i].a == points[i].b;
          *rows = *rows + (diagonal ? value.y : value.x);
          if (!diagonal && !is_spoke(points[i])) rows[size_] = rows[size_] + value.y;
          ++column;
        }
      }
    }
  }

  /// In floating point: v + v' s with first element 1, lambda + lambda' s, and the inverse R of the derivative of
  /// (lambda, v) -> (A - lambda) v.
  void find_eigenvector() {
    std::vector<double> A(size_ * size_), slope(size_ * size_), v(size_, 1), next(size_);
    for (std::size_t i = 0; i < A.size(); ++i)
      A[i] = approximate(matrix_[i].value), slope[i] = approximate(matrix_[i].slope);
    double lambda = 0;
    for (int step = 0; step < 400; ++step) {
      for (std::size_t i = 0; i < size_; ++i) {
        next[i] = 0;
        for (std::size_t j = 0; j < size_; ++j) next[i] += A[i * size_ + j] * v[j];
      }
      double largest = 0;
      for (const double x : next) largest = std::max(largest, std::abs(x));
      lambda = next[0] / v[0];
      for (std::size_t i = 0; i < size_; ++i) v[i] = next[i] / largest;
    }
    for (std::size_t i = size_; i-- > 0;) v[i] /= v[0];
    invert(derivative(A, lambda, v));
    std::vector<double> change(size_);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j)
        for (std::size_t k = 0; k < size_; ++k) change[i] -= inverse_[i * size_ + j] * slope[j * size_ + k] * v[k];
    lambda_ = {exact(lambda), exact(change[0])};
    vector_ = {{Enclosure(mpq_class(1)), Enclosure(mpq_class(0))}};
    for (std::size_t i = 1; i < size_; ++i) vector_.push_back({exact(v[i]), exact(change[i])});
  }
  std::vector<double> derivative(std::vector<double> A, double lambda, const std::vector<double>& v) const {
    for (std::size_t i = 0; i < size_; ++i) {
      A[i * size_ + i] -= lambda;
      A[i * size_] = -v[i];
    }
    return A;
  }
  /// Gauss and Jordan, in floating point.
  void invert(std::vector<double> A) {
    std::vector<double> R(size_ * size_);
    for (std::size_t i = 0; i < size_; ++i) R[i * size_ + i] = 1;
    for (std::size_t k = 0; k < size_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < size_; ++i)
        if (std::abs(A[i * size_ + k]) > std::abs(A[pivot * size_ + k])) pivot = i;
      for (std::size_t j = 0; j < size_; ++j) {
        std::swap(A[k * size_ + j], A[pivot * size_ + j]);
        std::swap(R[k * size_ + j], R[pivot * size_ + j]);
      }
      const double divisor = A[k * size_ + k];
      for (std::size_t j = 0; j < size_; ++j) A[k * size_ + j] /= divisor, R[k * size_ + j] /= divisor;
      for (std::size_t i = 0; i < size_; ++i) {
        const double f = A[i * size_ + k];
        for (std::size_t j = 0; i != k && j < size_; ++j) {
          A[i * size_ + j] -= f * A[k * size_ + j];
          R[i * size_ + j] -= f * R[k * size_ + j];
        }
      }
    }
    inverse_ = std::move(R);
  }

  /// F(z + e) = F(z) + F'(z) e - e_0 e_v for z = (lambda, v), e = (e_0, e_v). When |e| <= E implies
  /// |e - R F(z + e)| < E, R has an inverse and by Brouwer there is e with F(z + e) = 0, for every s.
  void verify_eigenvector() {
    std::vector<Enclosure> R, residual(size_), deviation(size_ * size_);
    for (const double r : inverse_) R.push_back(exact(r));
    std::vector<Model> F(size_), derivative = matrix_;
    for (std::size_t i = 0; i < size_; ++i) {
      derivative[i * size_ + i] = derivative[i * size_ + i] - lambda_;
      F[i] = zero_;
      for (std::size_t j = 0; j < size_; ++j) F[i] = F[i] + derivative[i * size_ + j] * vector_[j];
      derivative[i * size_] = negative(vector_[i]);
    }
    for (std::size_t i = 0; i < size_; ++i) {
      Model own = zero_;
      for (std::size_t j = 0; j < size_; ++j) own = own + R[i * size_ + j] * F[j];
      residual[i] = absolute(range(own));
      for (std::size_t j = 0; j < size_; ++j) {
        Model entry = i == j ? one_ : zero_;
        for (std::size_t k = 0; k < size_; ++k) entry = entry - R[i * size_ + k] * derivative[k * size_ + j];
        deviation[i * size_ + j] = absolute(range(entry));
      }
    }
    const auto bound = [](const Enclosure& x) { return Enclosure(x.upper, x.upper); };
    const Enclosure growth(mpq_class(5, 4)), least(mpq_class(1, mpz_class(1) << 200));
    std::vector<Enclosure> error(size_);
    for (std::size_t i = 0; i < size_; ++i) error[i] = bound(growth * residual[i] + least);
    for (int attempt = 0;; ++attempt) {
      if (attempt == 40) throw Rejected{"map", "no eigenvector was found"};
      std::vector<Enclosure> next = residual;
      bool inside = true;
      for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t j = 0; j < size_; ++j) {
          next[i] = next[i] + deviation[i * size_ + j] * error[j];
          if (j > 0) next[i] = next[i] + absolute(R[i * size_ + j]) * error[0] * error[j];
        }
        inside = inside && next[i].upper < error[i].upper;
      }
      if (inside) break;
      for (std::size_t i = 0; i < size_; ++i) error[i] = bound(growth * next[i] + least);
      if (error[0].upper > Enclosure(mpq_class(1)).upper) throw Rejected{"map", "no eigenvector was found"};
    }
    const auto widen = [](Enclosure& x, const Enclosure& by) { x = x + Enclosure(mpz_class(-by.upper), by.upper); };
    widen(lambda_.value, error[0]);
    for (std::size_t i = 1; i < size_; ++i) widen(vector_[i].value, error[i]);
    if (!range(lambda_).is_positive() || !lambda_.value.is_positive())
      throw Rejected{"map", "the eigenvalue is not positive"};
  }

  /// The eigenvector on the points that determine the limit on the annulus.
  void extend() {
    for (const auto& [point, first] : place_) {
      Pair sum{zero_, zero_};
      std::size_t unknown = first;
      for (const Pair& unit : columns(point)) {
        const Model& x = vector_[unknown++];
        sum = {sum.x + unit.x * x, sum.y + unit.y * x};
      }
      values_[point] = sum;
    }
    const Model factor = inverse(lambda_);
    for (const auto& [point, row] : map_.outer_) {
      Pair sum{zero_, zero_};
      for (const auto& [old, entry] : row) {
        if (!dual_ && old == RingPoint{}) continue;  // the vertex is 0
        budget_.work(enclosure_cost * 40);
        Laurent weight;
        for (const auto& [sector, c] : entry.by_sector)
          if (!c.empty()) weight[sector] = c.begin()->second;
        const Pair value = times(weight_at(weight), value_at(old));
        sum = {sum.x + value.x, sum.y + value.y};
      }
      values_[point] = {factor * sum.x, factor * sum.y};
    }
  }
  Pair value_at(RingPoint p) {
    if (p.b > p.a) return transposed(value_at({p.b, p.a}));
    const auto found = values_.find(p);
    if (found == values_.end()) throw Rejected{"map", "there are too few rings"};
    return found->second;
  }
  /// A point of the half-plane a >= 0 around spoke 0.
  Pair half_plane(int a, int b) {
    if (b < 0) {
      const Pair above = half_plane(a, dual_ ? -1 - b : -b);
      return {above.x, negative(above.y)};
    }
    if (dual_ || a > 0) return value_at({a, b});
    return b == 0 ? Pair{zero_, zero_} : times(power(1), value_at({b, 0}));
  }

  void verify_signs() {
    budget_.work(5 * map_.limits_.cost(level_) + 1e6);
    std::map<RingPoint, Pair> known;
    const auto at = [&](int a, int b) -> const Pair& {
      const auto found = known.find({a, b});
      return found != known.end() ? found->second : known[{a, b}] = half_plane(a, b);
    };
    using Part = CurveLimits::Part;
    const auto derivative = [&](Model Pair::*part, int da, int db) {
      const auto difference = [&](int a, int b) { return range(at(a + da, b + db).*part - at(a, b).*part); };
      return map_.limits_.on_annulus(difference, da ? Part::by_a : Part::by_b, level_);
    };
    const Grid xa = derivative(&Pair::x, 1, 0), ya = derivative(&Pair::y, 1, 0);
    const Grid xb = derivative(&Pair::x, 0, 1), yb = derivative(&Pair::y, 0, 1);
    // Re(e^{-i pi/n} (x + i S y))
    const auto inward = [&](int a, int b) { return range(C_ * at(a, b).x + square_ * at(a, b).y); };
    const Grid inside = map_.limits_.on_annulus(inward, Part::value, level_);
    for (int a = xa.first_a; a <= xa.last_a(); ++a) {
      for (int b = 0; b <= a; ++b) {
        const auto fail = [&](const std::string& why) {
          throw Rejected{"map", why + " on the cell (" + std::to_string(a) + ", " + std::to_string(b) + ") of level " +
                                    std::to_string(level_)};
        };
        if (!product_exceeds(xa.at(a, b), yb.at(a, b), xb.at(a, b), ya.at(a, b)))
          fail("the Jacobian is not proved to be positive");
        if (inside.at(a, b).lower <= 0) fail("the map is not proved to stay in a half-plane");
      }
    }
  }

  const CharacteristicMap& map_;
  int level_;
  Budget& budget_;
  bool dual_;
  const Model zero_{};
  Model one_, C_, square_;  ///< square_ = S^2
  std::map<int, Pair> powers_;
  std::map<RingPoint, std::size_t> place_;
  std::size_t size_ = 0;
  std::vector<Model> matrix_, vector_;
  Model lambda_;
  std::vector<double> inverse_;
  std::map<RingPoint, Pair> values_;
};

Enclosure CharacteristicMap::prove(const Enclosure& cosine, int level, Budget& budget) const {
  if (level < 0 || level > max_level) throw Rejected{"limits", "the level of a map is not from 0 to 6"};
  return MapProof(*this, cosine, level, budget).run();
}

}  // namespace limes::checker
