#include "analysis/nonuniform/coefficient_tensors.hpp"
#include "analysis/nonuniform/dominance_test.hpp"
#include "analysis/nonuniform/polynomial_determinant.hpp"

namespace limes {

MultivariatePolynomial boundary_determinant(const LambdaPolynomial& r, const Rational& rho, const Stop& stop) {
  const int p = r.degree();
  const std::vector<Rational> weights = powers(rho, p);
  std::vector<MultivariatePolynomial> s;
  for (int k = 0; k <= p; ++k) s.push_back(weights[std::size_t(k)] * r.coefficients()[std::size_t(k)]);
  PolynomialMatrix matrix(r.variables(), p - 1, p - 1);
  for (int i = 1; i < p; ++i) {
    for (int j = 1; j < p; ++j) {
      auto& entry = matrix(i - 1, j - 1);
      if (j >= i) entry += s[std::size_t(p - j + i)];
      if (i + j >= p) entry -= s[std::size_t(i + j - p)];
    }
  }
  return determinant(matrix, stop);
}

namespace {

class BoundaryTest final : public DominanceTest {
 public:
  BoundaryTest(const LambdaPolynomial& r, const Rational& rho) : r_(r), rho_(rho) {}

  DominanceMethod method() const override { return DominanceMethod::boundary; }

  std::optional<DominanceLeaf> prove(const Box& box, const std::vector<Rational>& sample) const override {
    const CoefficientTensors tensors(r_, box);
    if (tensors.sign_at(rho_) <= 0) return std::nullopt;
    if (tensors.sign_at(-rho_) != (r_.degree() % 2 == 0 ? 1 : -1)) return std::nullopt;
    if (is_too_large()) return std::nullopt;
    if (!determinant_) determinant_ = boundary_determinant(r_, rho_);
    std::vector<int> degrees = determinant_->degrees();
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (box[i].is_point()) degrees[i] = 0;
    }
    if (sign_off_open_faces(degrees, bernstein_tensor(*determinant_, box, degrees).values, box) <= 0)
      return std::nullopt;
    return DominanceLeaf{box, method(), sample, {}, {}};
  }

 private:
  // D has degree at most p - 1 in the d_s; other methods are quicker than it beyond this size.
  bool is_too_large() const {
    double size = 1;
    for (const int n : r_.degrees()) size *= n * (r_.degree() - 1) + 1;
    return size > 3e5;
  }

  LambdaPolynomial r_;
  Rational rho_;
  mutable std::optional<MultivariatePolynomial> determinant_;  // made when first needed: it is the costly part
};

}  // namespace

std::unique_ptr<DominanceTest> make_boundary_test(const LambdaPolynomial& r, const Rational& rho) {
  return std::make_unique<BoundaryTest>(r, rho);
}

}  // namespace limes
