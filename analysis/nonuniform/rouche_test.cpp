#include "analysis/nonuniform/coefficient_tensors.hpp"
#include "analysis/nonuniform/dominance_test.hpp"

namespace limes {

namespace {

class RoucheTest final : public DominanceTest {
 public:
  RoucheTest(const LambdaPolynomial& r, const Rational& rho) : r_(r), weights_(powers(rho, r.degree())) {}

  DominanceMethod method() const override { return DominanceMethod::rouche; }

  std::optional<DominanceLeaf> prove(const Box& box, const std::vector<Rational>&) const override {
    const auto terms = CoefficientTensors(r_, box).scaled(weights_);
    for (std::size_t i = 0; i < terms.front().size(); ++i) {
      Integer margin = terms.back()[i];
      for (std::size_t s = 0; s + 1 < terms.size(); ++s) margin -= abs(terms[s][i]);
      if (margin <= 0) return std::nullopt;
    }
    return DominanceLeaf{box, method(), {}, {}, {}};
  }

  bool is_hopeless_at(const std::vector<Rational>& point) const override { return !prove(point_box(point), point); }

 private:
  LambdaPolynomial r_;
  std::vector<Rational> weights_;
};

}  // namespace

std::unique_ptr<DominanceTest> make_rouche_test(const LambdaPolynomial& r, const Rational& rho) {
  return std::make_unique<RoucheTest>(r, rho);
}

}  // namespace limes
