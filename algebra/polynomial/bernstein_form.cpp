#include "algebra/polynomial/bernstein_form.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_tensor.hpp"

#include <algorithm>
#include <tuple>

namespace limes {

namespace {

void require_box(const MultivariatePolynomial& p, const Box& box) {
  if (box.size() != static_cast<std::size_t>(p.variables())) {
    throw DomainError("a polynomial in " + std::to_string(p.variables()) + " variables on a box of dimension " +
                      std::to_string(box.size()));
  }
  for (const Interval& interval : box) {
    const int order = interval.lower.compare(interval.upper);
    if (order > 0 || (order == 0 && (interval.lower_open || interval.upper_open))) {
      throw DomainError("the box is empty");
    }
  }
}

std::vector<int> degrees_on(const MultivariatePolynomial& p, const Box& box) {
  require_box(p, box);
  std::vector<int> degrees = p.degrees();
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (box[i].is_point()) degrees[i] = 0;
  }
  return degrees;
}

std::vector<Rational> rationals(const BernsteinTensor& tensor) {
  std::vector<Rational> result;
  result.reserve(tensor.values.size());
  for (const Integer& value : tensor.values) result.emplace_back(value, tensor.denominator);
  return result;
}

}  // namespace

BernsteinForm::BernsteinForm(const MultivariatePolynomial& p, const Box& box)
    : box_(box), degrees_(degrees_on(p, box)), coefficients_(rationals(bernstein_tensor(p, box, degrees_))) {}

BernsteinForm::BernsteinForm(const MultivariatePolynomial& p, const Box& box, const std::vector<int>& degrees)
    : box_(box), degrees_(degrees) {
  const std::vector<int> least = degrees_on(p, box);
  if (degrees.size() != least.size()) throw DomainError("a multidegree of wrong length");
  for (std::size_t i = 0; i < least.size(); ++i) {
    if (box[i].is_point()) degrees_[i] = 0;
    if (degrees_[i] < least[i]) {
      throw DomainError("a Bernstein form of degree " + std::to_string(degrees_[i]) + " of a polynomial of degree " +
                        std::to_string(least[i]));
    }
  }
  coefficients_ = rationals(bernstein_tensor(p, box, degrees_));
}

const Rational& BernsteinForm::lower() const { return *std::min_element(coefficients_.begin(), coefficients_.end()); }
const Rational& BernsteinForm::upper() const { return *std::max_element(coefficients_.begin(), coefficients_.end()); }

int BernsteinForm::strict_sign() const {
  const int sign = coefficients_.front().sign();
  const bool all = std::all_of(coefficients_.begin(), coefficients_.end(),
                               [&](const Rational& c) { return c.sign() == sign; });
  return all ? sign : 0;
}

int BernsteinForm::strict_sign_off_open_faces() const { return sign_off_open_faces(degrees_, coefficients_, box_); }

std::pair<BernsteinForm, BernsteinForm> BernsteinForm::bisect(int axis) const {
  BernsteinForm left, right;
  std::tie(left.box_, right.box_) = limes::bisect(box_, axis);
  left.degrees_ = right.degrees_ = degrees_;
  BernsteinTensor tensor{degrees_, {}, 1};
  for (const Rational& c : coefficients_) {
    mpz_lcm(tensor.denominator.backend().data(), tensor.denominator.backend().data(), mpq_denref(c.backend().data()));
  }
  tensor.values.resize(coefficients_.size());
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    auto* value = tensor.values[i].backend().data();
    mpz_divexact(value, tensor.denominator.backend().data(), mpq_denref(coefficients_[i].backend().data()));
    mpz_mul(value, value, mpq_numref(coefficients_[i].backend().data()));
  }
  const auto halves = limes::bisect(tensor, axis);
  left.coefficients_ = rationals(halves.first);
  right.coefficients_ = rationals(halves.second);
  return {std::move(left), std::move(right)};
}

namespace {

struct Piece {
  BernsteinTensor tensor;
  Box box;
  int depth;
};

/// Shows that no sign can be proved: a corner of the closed piece has a value of the wrong sign, or 0 although it
/// belongs to the piece. `sign` is that of the corners seen so far, 0 before the first.
bool corners_forbid(const Piece& piece, int& sign) {
  const std::size_t dimension = piece.box.size();
  std::vector<std::size_t> axes;  // those where the two ends differ
  for (std::size_t i = 0; i < dimension; ++i) {
    if (piece.tensor.degrees[i] > 0) axes.push_back(i);
  }
  if (axes.size() > 16) return false;  // too many corners to be worth it
  std::vector<std::size_t> strides(dimension);
  std::size_t stride = 1;
  for (std::size_t i = dimension; i-- > 0;) {
    strides[i] = stride;
    stride *= static_cast<std::size_t>(piece.tensor.degrees[i]) + 1;
  }
  for (std::size_t corner = 0; corner < std::size_t(1) << axes.size(); ++corner) {
    std::size_t index = 0;
    bool excluded = false;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const bool at_upper = (corner >> k & 1) != 0;
      const Interval& interval = piece.box[axes[k]];
      excluded = excluded || (at_upper ? interval.upper_open : interval.lower_open);
      if (at_upper) index += static_cast<std::size_t>(piece.tensor.degrees[axes[k]]) * strides[axes[k]];
    }
    const int value = piece.tensor.values[index].sign();
    if (value == 0 ? !excluded : sign * value < 0) return true;
    if (value != 0) sign = value;
  }
  return false;
}

}  // namespace

int prove_strict_sign(const MultivariatePolynomial& p, const Box& box, int max_boxes) {
  const std::vector<int> degrees = degrees_on(p, box);
  // Cutting an axis on which p does not depend proves nothing.
  Box relevant = box;
  int axes = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (degrees[i] == 0) {
      relevant[i] = Interval::point(box[i].lower);
    } else {
      ++axes;
    }
  }
  const int max_depth = 64 * axes;  // a piece this small that is still undecided is next to a zero
  std::vector<Piece> pieces;
  pieces.push_back({bernstein_tensor(p, relevant, degrees), relevant, 0});
  int sign = 0;
  for (int boxes = 0; !pieces.empty(); ++boxes) {
    const Piece piece = std::move(pieces.back());
    pieces.pop_back();
    if (boxes >= max_boxes || corners_forbid(piece, sign)) return 0;
    const int proved = sign_off_open_faces(piece.tensor.degrees, piece.tensor.values, piece.box);
    if (proved != 0) {
      if (sign != 0 && proved != sign) return 0;
      sign = proved;
      continue;
    }
    const int axis = widest_axis(piece.box, relevant);
    if (axis < 0 || piece.depth >= max_depth) return 0;
    auto tensors = bisect(piece.tensor, axis);
    auto boxes_of_halves = bisect(piece.box, axis);
    pieces.push_back({std::move(tensors.second), std::move(boxes_of_halves.second), piece.depth + 1});
    pieces.push_back({std::move(tensors.first), std::move(boxes_of_halves.first), piece.depth + 1});
  }
  return sign;
}

}  // namespace limes
