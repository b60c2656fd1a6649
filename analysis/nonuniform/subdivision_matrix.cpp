#include "analysis/nonuniform/subdivision_matrix.hpp"

#include "algebra/error.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"

namespace limes {

SubdivisionMatrix::SubdivisionMatrix(const InsertionRule& rule)
    : SubdivisionMatrix(from_stencils(isolated_ratio_stencils(rule, {}))) {}

SubdivisionMatrix SubdivisionMatrix::from_stencils(std::vector<std::vector<RationalFunction>> stencils) {
  const std::size_t points = stencils.size() + 1;
  if (stencils.empty() || points % 2 != 0) throw DomainError("a 2n-point scheme has 2n-1 different stencils");
  SubdivisionMatrix result;
  result.points_ = static_cast<int>(points);
  result.variables_ = stencils.front().empty() ? 0 : stencils.front().front().variables();
  if (result.variables_ < 1) throw DomainError("stencils are functions of the parameters and of gamma");
  for (const auto& functions : stencils) {
    if (functions.size() != points) throw DomainError("a stencil of a 2n-point scheme has 2n weights");
    Stencil stencil{MultivariatePolynomial::constant(result.variables_, 1), {}};
    for (const auto& e : functions) {
      stencil.denominator *= *exact_quotient(e.denominator(), gcd(stencil.denominator, e.denominator()));
    }
    for (const auto& e : functions) {
      stencil.numerators.push_back(e.numerator() * *exact_quotient(stencil.denominator, e.denominator()));
    }
    result.stencils_.push_back(std::move(stencil));
  }
  return result;
}

// Row 2i+1, i = -n .. n-1, has its first weight at t_{i-n+1}; in eq. (14) it is row number i + n, and its stencil is
// E_{i+n}, with E_{2n-1} = E_0.
const SubdivisionMatrix::Stencil& SubdivisionMatrix::stencil(int row) const {
  return stencils_[static_cast<std::size_t>((row - 1 + points_) / 2 % (points_ - 1))];
}

int SubdivisionMatrix::first_knot(int row) const { return (row - 1 - points_) / 2 + 1; }

MultivariatePolynomial SubdivisionMatrix::row_numerator(int row, int column) const {
  if (row % 2 == 0) return MultivariatePolynomial::constant(variables_, 2 * column == row ? 1 : 0);
  const int j = column - first_knot(row);
  return 0 <= j && j < points_ ? stencil(row).numerators[static_cast<std::size_t>(j)]
                               : MultivariatePolynomial(variables_);
}

MultivariatePolynomial SubdivisionMatrix::row_denominator(int row) const {
  return row % 2 != 0 ? stencil(row).denominator : MultivariatePolynomial::constant(variables_, 1);
}

RationalFunction SubdivisionMatrix::entry(int row, int column) const {
  return {row_numerator(row, column), row_denominator(row)};
}

RationalMatrix SubdivisionMatrix::at(std::span<const Rational> point) const {
  const int last = points_ - 1;
  RationalMatrix result(size(), size());
  for (int row = -last; row <= last; ++row) {
    const Rational denominator = row_denominator(row)(point);
    if (denominator == 0) throw DomainError("the subdivision matrix has a pole here");
    for (int column = -last; column <= last; ++column) {
      result(row + last, column + last) = row_numerator(row, column)(point) / denominator;
    }
  }
  return result;
}

MultivariatePolynomial SubdivisionMatrix::knot(int j) const {
  const auto index = MultivariatePolynomial::constant(variables_, j);
  return j > 0 ? index * MultivariatePolynomial::variable(variables_, gamma()) : index;
}

std::vector<MultivariatePolynomial> SubdivisionMatrix::power_defects(int k) const {
  std::vector<MultivariatePolynomial> result;
  const int last = points_ - 1;
  for (int row = -last; row <= last; ++row) {
    if (row % 2 == 0) continue;  // unit rows: t_{row/2} = t_row / 2
    MultivariatePolynomial sum(variables_);
    for (int j = 0; j < points_; ++j) {
      sum += stencil(row).numerators[static_cast<std::size_t>(j)] * power(knot(first_knot(row) + j), k);
    }
    sum -= power(Rational(2), -k) * (power(knot(row), k) * stencil(row).denominator);
    if (!sum.is_zero()) result.push_back(std::move(sum));
  }
  return result;
}

int SubdivisionMatrix::reproduced_degree(int limit) const {
  for (int k = 0; k <= limit; ++k) {
    if (!power_defects(k).empty()) return k - 1;
  }
  return limit;
}

}  // namespace limes
