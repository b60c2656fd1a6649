#include "schemes/unity/derive_mask.hpp"

#include "algebra/error.hpp"
#include "algebra/matrix/exact_solve.hpp"
#include "algebra/number/read_rational.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

/// (-c, 1)^T gram (-c, 1) >= 0.
Rational squared_residual(const RationalMatrix& gram, const std::vector<Rational>& c) {
  const int n = gram.rows() - 1;
  Rational sum = gram(n, n);
  for (int i = 0; i < n; ++i) {
    Rational row = -2 * gram(i, n);
    for (int j = 0; j < n; ++j) row += gram(i, j) * c[j];
    sum += c[i] * row;
  }
  return sum;
}

/// sqrt(x / y) without underflow. \pre x >= 0, y > 0
double root_of_quotient(const Rational& x, const Rational& y) {
  if (x == 0) return 0;
  const Rational scale = power(Rational(2), 1000);
  return std::sqrt(approx_double(x / y * scale)) / std::sqrt(approx_double(scale));
}

/// c = particular + basis y.
std::vector<Rational> combine(const AffineSolutions& solutions, const std::vector<Rational>& y) {
  std::vector<Rational> c = solutions.basis * y;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] += solutions.particular[i];
  return c;
}

std::vector<Rational> minimise(const RationalMatrix& gram, const AffineSolutions& solutions) {
  const int n = gram.rows() - 1, unknowns = solutions.basis.columns();
  RationalMatrix transposed(unknowns, n), inner(n, n), right(n, 1);
  for (int i = 0; i < n; ++i) {
    right(i, 0) = gram(i, n);
    for (int j = 0; j < n; ++j) {
      inner(i, j) = gram(i, j);
      right(i, 0) -= gram(i, j) * solutions.particular[j];
    }
    for (int j = 0; j < unknowns; ++j) transposed(j, i) = solutions.basis(i, j);
  }
  const auto solution = exact_solve(transposed * inner * solutions.basis, transposed * right);
  if (!solution) throw InputError("rank-deficient system: the dilates are linearly dependent on the samples, so the mask is not unique");
  std::vector<Rational> y;
  for (int k = 0; k < unknowns; ++k) y.push_back((*solution)(k, 0));
  return y;
}

/// The nearest multiple of 1/unit.
Rational nearest_multiple(const Rational& x, const Integer& unit) {
  const Integer twice = 2 * numerator(x) * unit + denominator(x);
  const Integer step = 2 * denominator(x);
  Integer quotient = twice / step;
  if (twice < 0 && quotient * step != twice) --quotient;
  return Rational(quotient) / Rational(unit);
}

Integer power_of_ten(int exponent) { return numerator(power(Rational(10), exponent)); }

/// Whether the whole problem is its own mirror image; so is its solution then, up to rounding.
bool is_symmetric(const RefinementEquation& equation) {
  const std::optional<Rational> axis = equation.weight.axis();
  return axis && 2 * *axis == equation.domain.lower + equation.domain.upper && 2 * *axis == 2 * equation.first_shift + equation.count - 1;
}

}  // namespace

double DerivedMask::error_of(const std::vector<Rational>& coefficients) const {
  const int n = system.gram.rows() - 1;
  return root_of_quotient(squared_residual(system.gram, coefficients), system.gram(n, n));
}

DerivedMask derive_mask(const RefinementEquation& equation, LeastSquares system, const MaskConstraints& constraints,
                        const std::optional<int>& decimals) {
  MaskConstraints all = constraints;
  all.symmetry = all.symmetry || is_symmetric(equation);
  if (system.gram(equation.count, equation.count) == 0) throw InputError("the weight function vanishes where the equation is asked for");
  DerivedMask result{.equation = equation, .system = std::move(system), .solutions = solve_constraints(all, equation), .mask = {}};
  const AffineSolutions& solutions = result.solutions;
  const std::vector<double> singular = approx_singular_values(result.system, solve_constraints(constraints, equation).basis);
  result.unknowns = static_cast<int>(singular.size());
  const double tolerance = result.system.precision == 0 ? 0 : std::ldexp(std::max(result.system.samples, equation.count), -result.system.precision);
  for (const double value : singular) result.rank += value > tolerance * singular.front();
  if (result.rank < result.unknowns) {
    throw InputError(fmt::format("rank-deficient system: rank {} with {} unknowns; the dilates are linearly dependent where the equation is asked "
                                 "for, so the mask is not unique (fewer shifts, or another constraint?)", result.rank, result.unknowns));
  }
  if (!singular.empty()) result.condition = singular.front() / singular.back();

  std::vector<Rational> y = minimise(result.system.gram, solutions);
  result.mask = combine(solutions, y);
  result.exact = result.system.precision == 0 && !decimals;
  result.least_error = result.error_of(result.mask);
  if (!result.exact) {
    if (result.least_error < 1e-10) {
      std::vector<Rational> simple;
      const Rational radius = power(Rational(10), -9);
      for (const Rational& value : y) simple.push_back(simplest_between(value - radius, value + radius));
      if (result.error_of(combine(solutions, simple)) < 1e-12) y = simple;
    }
    const Integer unit = power_of_ten(decimals.value_or(std::max(15, result.system.precision * 3 / 10)));
    for (Rational& value : y) {
      if (denominator(value) > 1000000) value = nearest_multiple(value, unit);
    }
    result.mask = combine(solutions, y);
  }
  result.error = result.error_of(result.mask);
  return result;
}

std::vector<Rational> rounded_to_float(const std::vector<Rational>& mask) {
  std::vector<Rational> rounded;
  for (const Rational& c : mask) rounded.emplace_back(static_cast<double>(static_cast<float>(approx_double(c))));
  return rounded;
}

std::vector<Rational> rounded_to_digits(const std::vector<Rational>& mask, int digits) {
  std::vector<Rational> rounded;
  for (const Rational& c : mask) rounded.push_back(read_rational(to_decimal(c, digits, Rounding::nearest)));
  return rounded;
}

}  // namespace limes
