#include "analysis/nonuniform/spectrum_screen.hpp"

#include "algebra/error.hpp"
#include "algebra/matrix/rational_matrix.hpp"
#include "analysis/eigen_impl.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/finite_sections.hpp"

#include <cmath>

namespace limes {
namespace {

using Point = std::vector<Rational>;
using Matrix = Eigen::MatrixXd;

/// M(x) = M(0) + sum_k x_k (M(e_k) - M(0))
struct AffineMatrix {
  Matrix constant;
  std::vector<Matrix> slopes;

  Matrix at(std::span<const double> x) const {
    Matrix result = constant;
    for (std::size_t k = 0; k < x.size(); ++k) result += x[k] * slopes[k];
    return result;
  }
};

/// 0 and the unit vectors.
std::vector<Point> corners(int parameters) {
  std::vector<Point> result(std::size_t(parameters) + 1, Point(std::size_t(parameters), 0));
  for (int k = 0; k < parameters; ++k) result[std::size_t(k) + 1][std::size_t(k)] = 1;
  return result;
}

/// One more point, at which affinity is tested.
Point test_point(int parameters) {
  Point point;
  for (int k = 0; k < parameters; ++k) point.push_back(Rational(2 * k + 3) / (k + 5));
  return point;
}

/// Row by row, the weights of the divided differences [t_j .. t_{j+order}], j = 0 .. size - order - 1.
RationalMatrix divided_differences(const std::vector<Rational>& knots, int order) {
  const int size = static_cast<int>(knots.size());
  RationalMatrix result(size - order, size);
  for (int j = 0; j + order < size; ++j) {
    for (int s = j; s <= j + order; ++s) {
      Rational product = 1;
      for (int t = j; t <= j + order; ++t) {
        if (t != s) product *= knots[std::size_t(s)] - knots[std::size_t(t)];
      }
      result(j, s) = 1 / product;
    }
  }
  return result;
}

/// L on the knots j <= 0 and gamma j > 0, |j| <= 2n-1.
RationalMatrix subdivision_matrix_at(const InsertionRule& rule, const std::vector<Rational>& knots, const Point& x) {
  const int n = rule.points() / 2, last = 2 * n - 1;
  RationalMatrix result(2 * last + 1, 2 * last + 1);
  for (int row = -last; row <= last; ++row) {
    if (row % 2 == 0) {
      result(row + last, row / 2 + last) = 1;
      continue;
    }
    const int first = (row - 1) / 2 - n + 1 + last;
    const std::vector<Rational> e = rule.stencil(std::span(knots).subspan(std::size_t(first), std::size_t(2 * n)), x);
    for (int j = 0; j < 2 * n; ++j) result(row + last, first + j) = e[std::size_t(j)];
  }
  return result;
}

/// M/2 with 2^{order} D L = M D. \throws DomainError when there is none: L does not preserve polynomials of degree < order.
RationalMatrix on_differences(const RationalMatrix& l, const RationalMatrix& d, int order) {
  RationalMatrix rest = d * l;
  const Rational scale = power(Rational(2), order - 1);
  RationalMatrix result(d.rows(), d.rows());
  for (int i = 0; i < d.rows(); ++i) {
    for (int j = 0; j < d.rows(); ++j) {
      const Rational weight = rest(i, j) / d(j, j);
      if (weight == 0) continue;
      for (int s = j; s <= j + order; ++s) rest(i, s) -= weight * d(j, s);
      result(i, j) = scale * weight;
    }
    for (int s = 0; s < d.columns(); ++s) {
      if (rest(i, s) != 0) {
        throw DomainError(fmt::format("the rule does not reproduce polynomials of degree {} about an isolated knot for all parameter values",
                                      order - 1));
      }
    }
  }
  return result;
}

/// Powers of two by which a similarity makes the rows' and the columns' sums of moduli about equal. [Parlett & Reinsch 1969]
Eigen::VectorXd balance(Matrix moduli) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(moduli.rows());
  for (int round = 0; round < 100; ++round) {
    bool changed = false;
    for (Eigen::Index i = 0; i < moduli.rows(); ++i) {
      const double row = moduli.row(i).sum() - moduli(i, i), column = moduli.col(i).sum() - moduli(i, i);
      if (row == 0 || column == 0) continue;
      const double factor = std::exp2(std::round(std::log2(column / row) / 2));
      if (factor == 1) continue;
      moduli.row(i) *= factor;
      moduli.col(i) /= factor;
      scale[i] *= factor;
      changed = true;
    }
    if (!changed) break;
  }
  return scale;
}

Matrix rounded(const RationalMatrix& a) {
  Matrix result(a.rows(), a.columns());
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) result(i, j) = approx_double(a(i, j));
  }
  return result;
}

/// From exact values at the corners, tested at another point.
template <class Exact>
AffineMatrix affine(int parameters, Exact exact) {
  std::vector<RationalMatrix> values;
  for (const Point& corner : corners(parameters)) values.push_back(exact(corner));
  const Point x = test_point(parameters);
  const RationalMatrix tested = exact(x);
  AffineMatrix result{.constant = rounded(values.front()), .slopes = {}};
  RationalMatrix expected = values.front();
  for (int k = 0; k < parameters; ++k) {
    RationalMatrix slope = values[std::size_t(k) + 1];
    for (int i = 0; i < slope.rows(); ++i) {
      for (int j = 0; j < slope.columns(); ++j) {
        slope(i, j) -= values.front()(i, j);
        expected(i, j) += x[std::size_t(k)] * slope(i, j);
      }
    }
    result.slopes.push_back(rounded(slope));
  }
  if (tested != expected) throw DomainError("the new point is not affine in the parameters");
  return result;
}

/// A similar family, balanced for all parameter values of about 1.
AffineMatrix balanced(AffineMatrix a) {
  Matrix moduli = a.constant.cwiseAbs();
  for (const Matrix& slope : a.slopes) moduli += slope.cwiseAbs();
  const Eigen::VectorXd scale = balance(moduli);
  const auto apply = [&](Matrix& m) { m = (scale.asDiagonal() * m * scale.cwiseInverse().asDiagonal()).eval(); };
  apply(a.constant);
  for (Matrix& slope : a.slopes) apply(slope);
  return a;
}

/// Binary words of 0 and 1 up to the length that are least among their rotations and no power of a shorter one.
std::vector<std::vector<int>> primitive_words(int length) {
  std::vector<std::vector<int>> result;
  for (int n = 1; n <= length; ++n) {
    for (unsigned bits = 0; bits < 1U << n; ++bits) {
      const auto rotated = [&](int by) { return ((bits >> by) | (bits << (n - by))) & ((1U << n) - 1); };
      bool least = true;
      for (int by = 1; by < n && least; ++by) least = bits < rotated(by);
      if (!least) continue;
      std::vector<int> word;
      for (int k = 0; k < n; ++k) word.push_back(int(bits >> k & 1));
      result.push_back(std::move(word));
    }
  }
  return result;
}

double spectral_radius(const Matrix& a) {
  if (!a.allFinite()) return 1e300;
  return approx_spectral_radius(a);
}

}  // namespace

struct SpectrumScreen::Matrices {
  std::vector<AffineMatrix> ratios;
  std::vector<AffineMatrix> sections;
  std::vector<std::vector<int>> words;
};

std::vector<Rational> SpectrumScreen::default_ratios() {
  std::vector<Rational> result{1, Rational(3) / 4, Rational(1) / 2, Rational(1) / 3, Rational(1) / 5};
  for (const int k : {3, 4, 5, 6, 7, 8, 10, 12, 16, 20, 30}) result.push_back(Rational(1) / (1 << k));
  return result;
}

SpectrumScreen::SpectrumScreen(const InsertionRule& rule, int m, const std::vector<Rational>& ratios, int word_length)
    : parameters_(rule.parameters()) {
  auto made = std::make_unique<Matrices>();
  const int order = m + 1, last = rule.points() - 1;
  if (m < 0 || 2 * last + 1 <= order) throw DomainError("a scheme of so few points has no differences of that order");
  for (const Rational& gamma : ratios) {
    std::vector<Rational> knots;
    for (int j = -last; j <= last; ++j) knots.push_back(j < 0 ? Rational(j) : gamma * j);
    const RationalMatrix differences = divided_differences(knots, order);
    made->ratios.push_back(balanced(affine(parameters_, [&](const Point& x) {
      return on_differences(subdivision_matrix_at(rule, knots, x), differences, order);
    })));
  }
  const auto b = difference_symbol(uniform_mask(rule), order);
  if (!b) throw DomainError(fmt::format("(1+z)^{} does not divide the mask for equal intervals", order));
  const FiniteSections sections(*b, 2);
  for (const int e : {0, 1}) {
    made->sections.push_back(affine(parameters_, [&](const Point& x) { return sections.product({e}, x); }));
  }
  made->words = primitive_words(word_length);
  matrices_ = std::move(made);
}

SpectrumScreen::~SpectrumScreen() = default;

std::vector<double> SpectrumScreen::approx_radii(std::span<const double> x) const {
  std::vector<double> result;
  for (const AffineMatrix& matrix : matrices_->ratios) result.push_back(spectral_radius(matrix.at(x)));
  const Matrix sections[] = {matrices_->sections[0].at(x), matrices_->sections[1].at(x)};
  for (const std::vector<int>& word : matrices_->words) {
    Matrix product = sections[word.front()];
    for (std::size_t k = 1; k < word.size(); ++k) product = (product * sections[word[k]]).eval();
    result.push_back(std::pow(spectral_radius(product), 1.0 / double(word.size())));
  }
  return result;
}

}  // namespace limes
