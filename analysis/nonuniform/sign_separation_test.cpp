#include "algebra/polynomial/real_roots.hpp"
#include "analysis/nonuniform/coefficient_tensors.hpp"
#include "analysis/nonuniform/dominance_test.hpp"

namespace limes {

namespace {

// Element s: the coefficient of u^j in sign (x + direction u)^s.
std::vector<Rational> taylor_weights(const Rational& x, int direction, int sign, int degree, int j) {
  std::vector<Rational> result(static_cast<std::size_t>(degree) + 1, 0);
  Rational binomial = 1;
  for (int s = j; s <= degree; ++s) {
    result[static_cast<std::size_t>(s)] = binomial * power(x, s - j) * ((direction < 0 && j % 2 != 0) ? -sign : sign);
    binomial = binomial * (s + 1) / (s + 1 - j);
  }
  return result;
}

// (-1)^p for direction -1: the sign of r beyond all real roots.
int outer_sign(const CoefficientTensors& tensors, int direction) { return direction < 0 && tensors.degree() % 2 != 0 ? -1 : 1; }

bool no_negative_taylor_coefficient(const CoefficientTensors& tensors, const Rational& rho, int direction) {
  const int p = tensors.degree();
  for (int j = 1; j <= p; ++j) {
    const std::vector<Rational> weights = taylor_weights(direction * rho, direction, outer_sign(tensors, direction), p, j);
    for (const Integer& value : tensors.combination(weights)) {
      if (value < 0) return false;
    }
  }
  return true;
}

// (i): no real root >= rho (direction 1) or <= -rho (direction -1).
bool no_real_root_beyond(const CoefficientTensors& tensors, const Rational& rho, int direction) {
  const std::vector<Rational> constant =
      taylor_weights(direction * rho, direction, outer_sign(tensors, direction), tensors.degree(), 0);
  return tensors.sign_off_open_faces(constant) > 0 && no_negative_taylor_coefficient(tensors, rho, direction);
}

class SignSeparationTest final : public DominanceTest {
 public:
  SignSeparationTest(const LambdaPolynomial& r, const Rational& rho) : r_(r), rho_(rho) {}

  DominanceMethod method() const override { return DominanceMethod::sign_separation; }

  // The real roots at the sample, each enclosed in an interval whose ends keep their signs on the whole box.
  std::optional<DominanceLeaf> prove(const Box& box, const std::vector<Rational>& sample) const override {
    const int p = r_.degree();
    const auto real = isolate_real_roots(r_.at(sample), rho_ / 1000000);
    const int found = static_cast<int>(real.size());
    if (found < p - 2) return std::nullopt;
    const bool all_real = found == p;
    const CoefficientTensors tensors(r_, box);
    if (tensors.sign_at(rho_) <= 0 || tensors.sign_at(-rho_) != (p % 2 == 0 ? 1 : -1)) return std::nullopt;
    if (!all_real && !(no_real_root_beyond(tensors, rho_, 1) && no_real_root_beyond(tensors, rho_, -1)))
      return std::nullopt;

    std::vector<Interval> intervals;
    for (int k = 0; k < found; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (real[at].multiplicity != 1) return std::nullopt;
      const Rational root = (real[at].lower + real[at].upper) / 2;
      // Room up to the neighbours' middles; up to 0 where the modulus matters.
      Rational below = k == 0 ? Rational(-rho_) : (root + (real[at - 1].lower + real[at - 1].upper) / 2) / 2;
      Rational above = k == found - 1 ? rho_ : (root + (real[at + 1].lower + real[at + 1].upper) / 2) / 2;
      if (!all_real && root >= 0) below = std::max(below, Rational(root / 16));
      if (!all_real && root <= 0) above = std::min(above, Rational(root / 16));
      const auto a = end_with_sign(tensors, root, below);
      const auto b = end_with_sign(tensors, root, above);
      if (!a || !b || a->second == b->second) return std::nullopt;
      intervals.push_back({a->first, b->first, false, false});
    }
    if (!all_real && !pair_is_inside(tensors, intervals)) return std::nullopt;
    return DominanceLeaf{box, method(), {}, {}, std::move(intervals)};
  }

  // With multiplicity, real roots are limits of real ones: fewer than p - 2, or one conjugate pair and a root 0 or a negative
  // coefficient in (i), stay so nearby.
  bool is_hopeless_at(const std::vector<Rational>& point) const override {
    const Polynomial at = r_.at(point);
    const int p = r_.degree();
    if (at.degree() < p) return false;
    int real = 0;
    for (const RootInterval& root : isolate_real_roots(at, rho_)) real += root.multiplicity;
    if (real != p - 2) return real < p - 2;
    if (at.coefficient(0) == 0) return true;
    const CoefficientTensors tensors(r_, point_box(point));
    return !no_negative_taylor_coefficient(tensors, rho_, 1) || !no_negative_taylor_coefficient(tensors, rho_, -1);
  }

 private:
  /// A point between the root and `limit` (the nearest that works) where r has one sign on the box, and that sign.
  std::optional<std::pair<Rational, int>> end_with_sign(const CoefficientTensors& tensors, const Rational& root,
                                                        const Rational& limit) const {
    for (const int part : {16, 8, 4, 2, 1}) {
      Rational end = root + (limit - root) / part;
      if (part > 1) {
        const Rational slack = abs(limit - root) / (4 * part);
        end = simplest_between(end - slack, end + slack);
      }
      if (const int sign = tensors.sign_at(end); sign != 0) return std::pair{end, sign};
    }
    return std::nullopt;
  }

  // (iii) |d_0| < rho^2 d_p prod kappa_k on the closed box.
  bool pair_is_inside(const CoefficientTensors& tensors, const std::vector<Interval>& intervals) const {
    Rational bound = rho_ * rho_;
    for (const Interval& interval : intervals) {
      if (interval.lower <= 0 && interval.upper >= 0) return false;
      bound *= std::min(Rational(abs(interval.lower)), Rational(abs(interval.upper)));
    }
    std::vector<Rational> weights(static_cast<std::size_t>(tensors.degree()) + 1, 0);
    weights.back() = bound;
    for (const int sign : {1, -1}) {
      weights.front() += sign;
      for (const Integer& value : tensors.combination(weights)) {
        if (value <= 0) return false;
      }
      weights.front() -= sign;
    }
    return true;
  }

  LambdaPolynomial r_;
  Rational rho_;
};

}  // namespace

std::unique_ptr<DominanceTest> make_sign_separation_test(const LambdaPolynomial& r, const Rational& rho) {
  return std::make_unique<SignSeparationTest>(r, rho);
}

}  // namespace limes
