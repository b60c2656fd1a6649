#include "algebra/polynomial/schur_cohn.hpp"
#include "analysis/nonuniform/coefficient_tensors.hpp"
#include "analysis/nonuniform/dominance_test.hpp"

#include <numeric>

namespace limes {

namespace {

// T_k(c), c the last of n + 1 variables.
std::vector<MultivariatePolynomial> chebyshev(int variables, int count) {
  const auto c = MultivariatePolynomial::variable(variables, variables - 1);
  std::vector<MultivariatePolynomial> result{MultivariatePolynomial::constant(variables, 1), c};
  while (static_cast<int>(result.size()) < count) {
    result.push_back(Rational(2) * (c * result.back()) - result[result.size() - 2]);
  }
  return result;
}

}  // namespace

MultivariatePolynomial circle_polynomial(const LambdaPolynomial& r, const Rational& rho) {
  const int p = r.degree();
  const int variables = r.variables() + 1;
  std::vector<int> map(static_cast<std::size_t>(r.variables()));
  std::iota(map.begin(), map.end(), 0);
  const std::vector<Rational> weights = powers(rho, p);
  std::vector<MultivariatePolynomial> s;
  for (std::size_t k = 0; k < weights.size(); ++k) s.push_back(weights[k] * r.coefficients()[k].mapped(variables, map));
  const auto t = chebyshev(variables, p + 1);
  MultivariatePolynomial result(variables);
  for (std::size_t k = 0; k < s.size(); ++k) {
    MultivariatePolynomial sum(variables);
    for (std::size_t i = 0; i + k < s.size(); ++i) sum += s[i] * s[i + k];
    result += Rational(k == 0 ? 1 : 2) * (t[k] * sum);
  }
  return result;
}

namespace {

// Cuts of [-1, 1] needed at a point are few; where more are, cutting the box helps more.
constexpr int max_cut_depth = 5;

class CircleTest final : public DominanceTest {
 public:
  CircleTest(const LambdaPolynomial& r, const Rational& rho) : r_(r), rho_(rho) {}

  DominanceMethod method() const override { return DominanceMethod::circle; }

  std::optional<DominanceLeaf> prove(const Box& box, const std::vector<Rational>& sample) const override {
    double size = r_.degree() + 1;
    for (const int n : r_.degrees()) size *= 2 * n + 1;
    if (size > 1e6) return std::nullopt;
    if (!polynomial_) polynomial_ = circle_polynomial(r_, rho_);
    Box closed = box;
    for (Interval& interval : closed) interval.lower_open = interval.upper_open = false;
    closed.push_back({-1, 1, false, false});
    std::vector<int> degrees = polynomial_->degrees();
    for (std::size_t i = 0; i < closed.size(); ++i) {
      if (closed[i].is_point()) degrees[i] = 0;
    }
    std::vector<Rational> cuts{-1};
    if (!positive(bernstein_tensor(*polynomial_, closed, degrees), closed.back(), 0, cuts)) return std::nullopt;
    return DominanceLeaf{box, method(), sample, std::move(cuts), {}};
  }

  // Pointwise the test is complete.
  bool is_hopeless_at(const std::vector<Rational>& point) const override {
    const Polynomial at = r_.at(point);
    return at.is_zero() || count_roots_by_circle(at, rho_).on > 0;
  }

 private:
  static bool positive(const BernsteinTensor& tensor, const Interval& c, int depth, std::vector<Rational>& cuts) {
    if (std::all_of(tensor.values.begin(), tensor.values.end(), [](const Integer& value) { return value > 0; })) {
      cuts.push_back(c.upper);
      return true;
    }
    // A corner is a value of F.
    if (depth == max_cut_depth || tensor.values.front() <= 0 || tensor.values.back() <= 0) return false;
    const auto halves = bisect(tensor, static_cast<int>(tensor.degrees.size()) - 1);
    return positive(halves.first, {c.lower, c.midpoint(), false, false}, depth + 1, cuts) &&
           positive(halves.second, {c.midpoint(), c.upper, false, false}, depth + 1, cuts);
  }

  LambdaPolynomial r_;
  Rational rho_;
  mutable std::optional<MultivariatePolynomial> polynomial_;
};

}  // namespace

std::unique_ptr<DominanceTest> make_circle_test(const LambdaPolynomial& r, const Rational& rho) {
  return std::make_unique<CircleTest>(r, rho);
}

}  // namespace limes
