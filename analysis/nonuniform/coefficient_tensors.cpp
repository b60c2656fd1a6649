#include "analysis/nonuniform/coefficient_tensors.hpp"

namespace limes {

std::vector<Rational> powers(const Rational& x, int n) {
  std::vector<Rational> result{1};
  for (int k = 0; k < n; ++k) result.push_back(result.back() * x);
  return result;
}

Box point_box(const std::vector<Rational>& point) {
  Box result;
  for (const auto& x : point) result.push_back(Interval::point(x));
  return result;
}

CoefficientTensors::CoefficientTensors(const LambdaPolynomial& r, const Box& box) : box_(box), degrees_(r.degrees()) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (box[i].is_point()) degrees_[i] = 0;
  }
  for (const auto& d : r.coefficients()) tensors_.push_back(bernstein_tensor(d, box, degrees_));
}

// weights[s] / denominator_s = factors[s] / common denominator
std::vector<Integer> CoefficientTensors::factors(const std::vector<Rational>& weights) const {
  Integer common = 1;
  std::vector<Rational> quotients;
  for (std::size_t s = 0; s < tensors_.size(); ++s) {
    quotients.push_back(weights[s] / Rational(tensors_[s].denominator));
    common = lcm(common, denominator(quotients.back()));
  }
  std::vector<Integer> result;
  for (const auto& q : quotients) result.push_back(numerator(q) * (common / denominator(q)));
  return result;
}

std::vector<Integer> CoefficientTensors::combination(const std::vector<Rational>& weights) const {
  const std::vector<Integer> factor = factors(weights);
  std::vector<Integer> result(tensors_.front().values.size());
  for (std::size_t s = 0; s < tensors_.size(); ++s) {
    if (factor[s].is_zero()) continue;
    for (std::size_t i = 0; i < result.size(); ++i) {
      mpz_addmul(result[i].backend().data(), factor[s].backend().data(), tensors_[s].values[i].backend().data());
    }
  }
  return result;
}

std::vector<std::vector<Integer>> CoefficientTensors::scaled(const std::vector<Rational>& weights) const {
  const std::vector<Integer> factor = factors(weights);
  std::vector<std::vector<Integer>> result;
  for (std::size_t s = 0; s < tensors_.size(); ++s) {
    result.push_back(tensors_[s].values);
    for (Integer& value : result.back()) value *= factor[s];
  }
  return result;
}

int CoefficientTensors::sign_off_open_faces(const std::vector<Rational>& weights) const {
  return limes::sign_off_open_faces(degrees_, combination(weights), box_);
}

int CoefficientTensors::sign_at(const Rational& lambda) const { return sign_off_open_faces(powers(lambda, degree())); }

}  // namespace limes
