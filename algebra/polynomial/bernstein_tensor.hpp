// Bernstein coefficients as integers over one common denominator: what BernsteinForm and the sign proofs compute with.
#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace limes {

/// The Bernstein coefficients values[I] / denominator in multidegree `degrees`, last index fastest. denominator > 0.
struct BernsteinTensor {
  std::vector<int> degrees;
  std::vector<Integer> values;
  Integer denominator = 1;
};

/// Number of coefficients in a multidegree. \throws LimitError above 10^7.
std::size_t bernstein_size(const std::vector<int>& degrees);
/// p on the closure of the box. \pre degrees are at least those of p, and 0 on point axes
BernsteinTensor bernstein_tensor(const MultivariatePolynomial& p, const Box& box, const std::vector<int>& degrees);
/// Both halves along an axis by de Casteljau.
std::pair<BernsteinTensor, BernsteinTensor> bisect(const BernsteinTensor& tensor, int axis);
/// +1 or -1 when, on the box without its open faces, the coefficients show this strict sign; see
/// BernsteinForm::strict_sign_off_open_faces(). `values` are the coefficients, or positive multiples of them.
template <class Number>
int sign_off_open_faces(const std::vector<int>& degrees, const std::vector<Number>& values, const Box& box);

}  // namespace limes
