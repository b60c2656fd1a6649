// The Bernstein coefficients of all d_s on a box, in one multidegree. Included by the sources of this folder.
#pragma once

#include "algebra/polynomial/bernstein_tensor.hpp"
#include "analysis/nonuniform/lambda_polynomial.hpp"

namespace limes {

class CoefficientTensors {
 public:
  CoefficientTensors(const LambdaPolynomial& r, const Box& box);

  int degree() const { return static_cast<int>(tensors_.size()) - 1; }
  /// A common positive multiple of the Bernstein coefficients of sum_s weights[s] d_s.
  std::vector<Integer> combination(const std::vector<Rational>& weights) const;
  /// The strict sign of the combination on the box off its open faces, or 0.
  int sign_off_open_faces(const std::vector<Rational>& weights) const;
  /// The same for r(lambda; .) with a fixed lambda.
  int sign_at(const Rational& lambda) const;
  /// Common positive multiples of weights[s] d_s, for all s the same: element s.
  std::vector<std::vector<Integer>> scaled(const std::vector<Rational>& weights) const;

 private:
  std::vector<Integer> factors(const std::vector<Rational>& weights) const;

  Box box_;
  std::vector<int> degrees_;
  std::vector<BernsteinTensor> tensors_;
};

/// The box of one point.
Box point_box(const std::vector<Rational>& point);

/// 1, x, .., x^n
std::vector<Rational> powers(const Rational& x, int n);

}  // namespace limes
