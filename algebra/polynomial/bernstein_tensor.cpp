#include "algebra/polynomial/bernstein_tensor.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/multivariate_polynomial_impl.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

namespace limes {

namespace {

constexpr std::size_t max_coefficients = 10000000;

/// Distance in memory between neighbours along each axis.
std::vector<std::size_t> strides_of(const std::vector<int>& degrees) {
  std::vector<std::size_t> strides(degrees.size());
  std::size_t stride = 1;
  for (std::size_t i = degrees.size(); i-- > 0;) {
    strides[i] = stride;
    stride *= static_cast<std::size_t>(degrees[i]) + 1;
  }
  return strides;
}

/// Calls body(start) for the first element of every line along an axis.
template <class Body>
void for_each_line(std::size_t size, std::size_t stride, std::size_t length, const Body& body) {
  for (std::size_t outer = 0; outer < size; outer += stride * length) {
    for (std::size_t inner = 0; inner < stride; ++inner) body(outer + inner);
  }
}

/// The coefficients of p in the power basis, with point axes substituted.
BernsteinTensor power_tensor(MultivariatePolynomial p, const Box& box, const std::vector<int>& degrees) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (box[i].is_point()) p = p.substitute(static_cast<int>(i), box[i].lower);
  }
  BernsteinTensor tensor{degrees, std::vector<Integer>(bernstein_size(degrees)), 1};
  const auto strides = strides_of(degrees);
  const auto& flint = p.impl();
  const Integer content = from_fmpz(fmpq_numref(flint.poly->content));
  tensor.denominator = from_fmpz(fmpq_denref(flint.poly->content));
  std::vector<ulong> exponents(std::max<std::size_t>(degrees.size(), 1));
  for (slong term = 0; term < static_cast<slong>(p.term_count()); ++term) {
    fmpq_mpoly_get_term_exp_ui(exponents.data(), flint.poly, term, flint.context);
    std::size_t index = 0;
    for (std::size_t i = 0; i < degrees.size(); ++i) index += exponents[i] * strides[i];
    fmpz_get_mpz(tensor.values[index].backend().data(), flint.poly->zpoly->coeffs + term);
    tensor.values[index] *= content;
  }
  return tensor;
}

/// base^0 .. base^n
std::vector<Integer> powers(const Integer& base, std::size_t n) {
  std::vector<Integer> result(n + 1, Integer(1));
  for (std::size_t k = 1; k <= n; ++k) result[k] = result[k - 1] * base;
  return result;
}

/// Power basis on [lower, upper] to Bernstein basis, along one axis. With lower = L/q, upper - lower = W/q:
/// q^n p(x) = sum_k (v_k q^{n-k}) (q x)^k, a shift by L and a scaling by W lead to t, and
/// c_I = sum_k binom(I, k) / binom(n, k) a_k leads from powers of t to Bernstein coefficients.
void to_bernstein(BernsteinTensor& tensor, std::size_t axis, const Interval& interval) {
  const auto n = static_cast<std::size_t>(tensor.degrees[axis]);
  if (n == 0) return;
  Integer q;
  mpz_lcm(q.backend().data(), mpq_denref(interval.lower.backend().data()), mpq_denref(interval.upper.backend().data()));
  const Integer shift = numerator(Rational(interval.lower * Rational(q)));
  const Integer width = numerator(Rational(interval.width() * Rational(q)));
  const auto q_powers = powers(q, n), width_powers = powers(width, n);
  std::vector<Integer> scale(n + 1);
  Integer binomials = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    mpz_bin_uiui(scale[k].backend().data(), n, k);
    mpz_lcm(binomials.backend().data(), binomials.backend().data(), scale[k].backend().data());
  }
  for (std::size_t k = 0; k <= n; ++k) scale[k] = binomials / scale[k] * width_powers[k];

  const std::size_t stride = strides_of(tensor.degrees)[axis];
  for_each_line(tensor.values.size(), stride, n + 1, [&](std::size_t start) {
    const auto at = [&](std::size_t k) -> Integer& { return tensor.values[start + k * stride]; };
    for (std::size_t k = 0; k < n; ++k) at(k) *= q_powers[n - k];
    if (!shift.is_zero()) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = n; j-- > i;) {
          mpz_addmul(at(j).backend().data(), shift.backend().data(), at(j + 1).backend().data());
        }
      }
    }
    for (std::size_t k = 0; k <= n; ++k) at(k) *= scale[k];
    for (std::size_t i = 1; i <= n; ++i) {
      for (std::size_t j = n; j >= i; --j) at(j) += at(j - 1);
    }
  });
  tensor.denominator *= q_powers[n] * binomials;
}

/// Divides values and denominator by their common power of two, which de Casteljau makes grow.
void drop_powers_of_two(BernsteinTensor& tensor) {
  mp_bitcnt_t common = mpz_scan1(tensor.denominator.backend().data(), 0);
  for (const Integer& value : tensor.values) {
    if (common == 0) return;
    if (!value.is_zero()) common = std::min(common, mpz_scan1(value.backend().data(), 0));
  }
  if (common == 0) return;
  tensor.denominator >>= common;
  for (Integer& value : tensor.values) mpz_tdiv_q_2exp(value.backend().data(), value.backend().data(), common);
}

}  // namespace

std::size_t bernstein_size(const std::vector<int>& degrees) {
  std::size_t size = 1;
  for (const int n : degrees) {
    const std::size_t factor = static_cast<std::size_t>(n) + 1;
    if (factor > max_coefficients / size) {
      throw LimitError("more than " + std::to_string(max_coefficients) + " Bernstein coefficients");
    }
    size *= factor;
  }
  return size;
}

BernsteinTensor bernstein_tensor(const MultivariatePolynomial& p, const Box& box, const std::vector<int>& degrees) {
  BernsteinTensor tensor = power_tensor(p, box, degrees);
  for (std::size_t axis = 0; axis < box.size(); ++axis) to_bernstein(tensor, axis, box[axis]);
  return tensor;
}

std::pair<BernsteinTensor, BernsteinTensor> bisect(const BernsteinTensor& tensor, int axis) {
  const auto k = static_cast<std::size_t>(axis);
  const auto n = static_cast<std::size_t>(tensor.degrees[k]);
  const std::size_t stride = strides_of(tensor.degrees)[k];
  std::pair<BernsteinTensor, BernsteinTensor> halves{tensor, tensor};
  BernsteinTensor& left = halves.first;  // no structured binding: clang 14 cannot capture one
  BernsteinTensor& right = halves.second;
  // Sums instead of means: after round i the entries are 2^i times those of de Casteljau's triangle.
  for_each_line(tensor.values.size(), stride, n + 1, [&](std::size_t start) {
    const auto at = [&](BernsteinTensor& half, std::size_t i) -> Integer& { return half.values[start + i * stride]; };
    left.values[start] <<= n;
    for (std::size_t round = 1; round <= n; ++round) {
      for (std::size_t i = 0; i + round <= n; ++i) at(right, i) += at(right, i + 1);
      mpz_mul_2exp(at(left, round).backend().data(), at(right, 0).backend().data(), n - round);
    }
    // right[i] was last touched in round n - i.
    for (std::size_t i = 1; i <= n; ++i) at(right, i) <<= i;
  });
  for (BernsteinTensor* half : {&left, &right}) {
    half->denominator <<= n;
    drop_powers_of_two(*half);
  }
  return halves;
}

template <class Number>
int sign_off_open_faces(const std::vector<int>& degrees, const std::vector<Number>& values, const Box& box) {
  const std::size_t axes = degrees.size();
  // A face that belongs to the box contains one of these: at each axis with closed ends at one of them, at others the whole interval.
  std::size_t needed = 1;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    if (degrees[axis] > 0 && !box[axis].lower_open && !box[axis].upper_open) needed *= 2;
  }
  std::set<std::uint64_t> found;  // bitwise: the lower end; a tensor has less than 64 axes of positive degree
  std::vector<int> index(axes, 0);
  int sign = 0;
  for (const Number& value : values) {
    if (const int own = value.sign(); own != 0) {
      if (own == -sign) return 0;
      sign = own;
      std::uint64_t face = 0;
      bool on_face = true;
      for (std::size_t axis = 0; axis < axes && on_face; ++axis) {
        if (degrees[axis] == 0 || (box[axis].lower_open && box[axis].upper_open)) continue;
        const bool lower = !box[axis].lower_open && index[axis] == 0;
        on_face = lower || (!box[axis].upper_open && index[axis] == degrees[axis]);
        face = 2 * face + lower;
      }
      if (on_face) found.insert(face);
    }
    for (std::size_t axis = axes; axis-- > 0 && ++index[axis] > degrees[axis];) index[axis] = 0;
  }
  return found.size() == needed ? sign : 0;
}

template int sign_off_open_faces(const std::vector<int>&, const std::vector<Integer>&, const Box&);
template int sign_off_open_faces(const std::vector<int>&, const std::vector<Rational>&, const Box&);

}  // namespace limes
