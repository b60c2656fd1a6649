// Sampled and integrated least squares, over double or MPFR. The long side of the system is compressed by
// blocked QR to a triangle with as many rows as unknowns, plus 1; what follows is exact arithmetic on that triangle.

#include "algebra/error.hpp"
#include "schemes/unity/mpfr_impl.hpp"
#include "schemes/unity/refinement_equation.hpp"
#include "schemes/unity/weight_evaluation_impl.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>

namespace limes {
namespace {

int decimal_digits(int bits) { return static_cast<int>(std::ceil(bits * 0.30103)) + 1; }

template <class Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// A point at which the equation is asked for, and the square root of its weight.
template <class Real>
struct Node {
  Real point;
  Real root_weight;
};

/// Collects rows (w(2u - s_0), .., w(2u - s_{n-1}), w(u)) and keeps only R of their QR factorisation.
template <class Real>
class Compression {
 public:
  Compression(const RefinementEquation& equation, const Stop& stop)
      : evaluate_(equation.weight, from_rational<Real>), stop_(stop), columns_(equation.count + 1), rows_(columns_ + block, columns_) {
    for (int k = 0; k < equation.count; ++k) shifts_.push_back(from_rational<Real>(equation.first_shift + k));
  }

  void add(const Node<Real>& node) {
    if (filled_ == rows_.rows()) compress();
    for (int k = 0; k + 1 < columns_; ++k) rows_(filled_, k) = node.root_weight * evaluate_(2 * node.point - shifts_[k]);
    rows_(filled_, columns_ - 1) = node.root_weight * evaluate_(node.point);
    ++filled_;
  }

  /// R^T R, exactly. \throws InputError when a number is not finite
  RationalMatrix gram() {
    compress();
    if (!rows_.topRows(filled_).allFinite()) throw InputError("the numbers of the system exceed the range of double precision");
    RationalMatrix r(filled_, columns_), transposed(columns_, filled_);
    for (int i = 0; i < filled_; ++i) {
      for (int j = i; j < columns_; ++j) transposed(j, i) = r(i, j) = exact_rational(rows_(i, j));
    }
    return transposed * r;
  }

 private:
  static constexpr int block = 1024;

  void compress() {
    stop_.check();
    const Eigen::HouseholderQR<Matrix<Real>> qr(rows_.topRows(filled_));
    const int kept = std::min(filled_, columns_);
    rows_.topRows(kept) = qr.matrixQR().topRows(kept).template triangularView<Eigen::Upper>();
    filled_ = kept;
  }

  WeightEvaluator<Real, Real (*)(const Rational&)> evaluate_;
  const Stop& stop_;
  int columns_;
  int filled_ = 0;
  Matrix<Real> rows_;
  std::vector<Real> shifts_;
};

template <class Real>
RationalMatrix sampled_gram(const RefinementEquation& equation, int samples, const Stop& stop) {
  Compression<Real> compression(equation, stop);
  const Real lower = from_rational<Real>(equation.domain.lower), width = from_rational<Real>(equation.domain.width());
  for (int k = 0; k < samples; ++k) compression.add({lower + width * k / (samples - 1), Real(1)});
  return compression.gram();
}

/// Nodes and weights of the Gauss-Legendre rule on [-1, 1], by Newton's method.
template <class Real>
std::vector<std::pair<Real, Real>> gauss_rule(int size) {
  using std::cos, std::abs, std::acos;
  std::vector<std::pair<Real, Real>> rule;
  const Real pi = acos(Real(-1));
  for (int k = 0; k < size; ++k) {
    Real x = cos(pi * (k + Real(0.75)) / (size + Real(0.5))), derivative;
    for (int iteration = 0; iteration < 16; ++iteration) {
      Real before = 1, value = x;
      for (int n = 2; n <= size; ++n) before = std::exchange(value, ((2 * n - 1) * x * value - (n - 1) * before) / n);
      derivative = size * (x * value - before) / (x * x - 1);
      x -= value / derivative;
    }
    rule.emplace_back(x, 2 / ((1 - x * x) * derivative * derivative));
  }
  return rule;
}

/// Where w or a dilate may fail to be smooth, inside of the domain, with its ends.
std::vector<Rational> break_points(const RefinementEquation& equation) {
  std::set<Rational> points{equation.domain.lower, equation.domain.upper};
  std::vector<Rational> breaks;
  if (const auto* exact = std::get_if<PiecewisePolynomial>(&equation.weight.shape)) breaks = exact->breaks;
  if (const auto* expression = std::get_if<PiecewiseExpression>(&equation.weight.shape)) breaks = expression->breaks;
  if (const auto* cinpact = std::get_if<CinpactWeight>(&equation.weight.shape)) breaks = {-cinpact->radius, cinpact->radius};
  for (const Rational& b : breaks) {
    const Rational at = b + equation.weight.centre;
    if (equation.domain.contains(at)) points.insert(at);
    for (int k = 0; k < equation.count; ++k) {
      const Rational dilated = (at + equation.first_shift + k) / 2;
      if (equation.domain.contains(dilated)) points.insert(dilated);
    }
  }
  return {points.begin(), points.end()};
}

template <class Real>
RationalMatrix integrated_gram(const RefinementEquation& equation, int samples, const Stop& stop) {
  using std::sqrt;
  constexpr int order = 16;
  Compression<Real> compression(equation, stop);
  const std::vector<Rational> points = break_points(equation);
  const auto rule = gauss_rule<Real>(order);
  const int panels = std::max(1, samples / order / static_cast<int>(points.size()));
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Real lower = from_rational<Real>(points[k]), half = from_rational<Real>((points[k + 1] - points[k]) / (2 * panels));
    for (int panel = 0; panel < panels; ++panel) {
      for (const auto& [x, weight] : rule) compression.add({lower + half * (2 * panel + 1 + x), sqrt(half * weight)});
    }
  }
  return compression.gram();
}

/// The piece of w that holds just right of a point, as a polynomial in u.
Polynomial piece_right_of(const PiecewisePolynomial& f, const Rational& x) {
  for (std::size_t k = 0; k < f.pieces.size(); ++k) {
    if (f.global || (f.breaks[k] <= x && x < f.breaks[k + 1])) return compose(f.pieces[k], Polynomial({-f.breaks[k], Rational(1)}));
  }
  return {};
}

RationalMatrix exact_gram(const RefinementEquation& equation, const PiecewisePolynomial& f, const Stop& stop) {
  const int n = equation.count + 1;
  RationalMatrix gram(n, n);
  const std::vector<Rational> points = break_points(equation);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    stop.check();
    const Rational &lower = points[k], &upper = points[k + 1];
    std::vector<Polynomial> columns;
    for (int j = 0; j < n; ++j) {
      const bool dilate = j + 1 < n;  // u -> 2u - s_j - centre, or u - centre
      const Rational offset = -equation.weight.centre - (dilate ? equation.first_shift + j : Rational(0)), scale = dilate ? 2 : 1;
      columns.push_back(compose(piece_right_of(f, scale * lower + offset), Polynomial({offset, scale})));
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) {
        const Polynomial product = columns[i] * columns[j];
        std::vector<Rational> integral(1);
        for (int d = 0; d <= product.degree(); ++d) integral.push_back(product.coefficient(d) / (d + 1));
        const Polynomial primitive(integral);
        gram(i, j) += primitive(upper) - primitive(lower);
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) gram(j, i) = gram(i, j);
  }
  return gram;
}

}  // namespace

LeastSquares sampled_least_squares(const RefinementEquation& equation, int samples, int precision, const Stop& stop) {
  if (precision == 53) return {sampled_gram<double>(equation, samples, stop), precision, samples};
  const PrecisionScope scope(decimal_digits(precision));
  return {sampled_gram<Mpfr>(equation, samples, stop), precision, samples};
}

LeastSquares integral_least_squares(const RefinementEquation& equation, int samples, int precision, const Stop& stop) {
  if (const auto* exact = std::get_if<PiecewisePolynomial>(&equation.weight.shape)) return {exact_gram(equation, *exact, stop), 0, 0};
  if (precision == 53) return {integrated_gram<double>(equation, samples, stop), precision, samples};
  const PrecisionScope scope(decimal_digits(precision));
  return {integrated_gram<Mpfr>(equation, samples, stop), precision, samples};
}

std::vector<double> approx_singular_values(const LeastSquares& system, const RationalMatrix& basis) {
  // The Gram matrix has the squares of the singular values.
  const PrecisionScope scope(decimal_digits(system.precision == 0 ? 384 : 2 * system.precision + 64));
  const int n = basis.rows(), columns = basis.columns();
  if (columns == 0) return {};
  Matrix<Mpfr> gram(n, n), span(n, columns);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) gram(i, j) = from_rational<Mpfr>(system.gram(i, j));
    for (int j = 0; j < columns; ++j) span(i, j) = from_rational<Mpfr>(basis(i, j));
  }
  const Matrix<Mpfr> orthonormal =
      Eigen::HouseholderQR<Matrix<Mpfr>>(span).householderQ() * Matrix<Mpfr>::Identity(n, columns);
  const Matrix<Mpfr> restricted = orthonormal.transpose() * gram * orthonormal;
  const Eigen::JacobiSVD<Matrix<Mpfr>> svd(restricted);
  std::vector<double> values;
  for (Eigen::Index k = 0; k < columns; ++k) values.push_back(static_cast<double>(Mpfr(sqrt(svd.singularValues()(k)))));
  return values;
}

std::vector<double> approx_values(const WeightFunction& weight, const std::vector<double>& points) {
  const WeightEvaluator<double, double (*)(const Rational&)> evaluate(weight, from_rational<double>);
  std::vector<double> values;
  for (const double u : points) values.push_back(evaluate(u));
  return values;
}

}  // namespace limes
