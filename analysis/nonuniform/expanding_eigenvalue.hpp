#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/schur_cohn.hpp"
#include "algebra/stop.hpp"
#include "analysis/nonuniform/lambda_polynomial.hpp"

#include <optional>
#include <vector>

namespace limes {

/// Why an interpolatory scheme is not C^m for all knots: at one parameter value and one isolated ratio gamma > 0, the
/// subdivision matrix has an eigenvalue of modulus >= 2^{-m} besides one simple 2^{-k} for k = 0..m each. Its
/// eigenvector (a principal vector for a double 2^{-k}) is the limit's values at the knots, and f(2^{-k} t) = lambda^k
/// f(t) contradicts a Taylor polynomial up to o(t^m).
struct ExpandingEigenvalue {
  /// Parameters, then gamma.
  std::vector<Rational> point;
  /// chi at the point, without the factors (lambda - 2^{-k}), k <= m, that it has, each divided out once.
  Polynomial remainder;
  /// Of the remainder, for the circle |lambda| = 2^{-m}; on + outside > 0.
  CircleCount count;
};

/// Exact check of one point. Nothing when all eigenvalues are as C^m needs them. \pre chi's leading coefficient does
/// not vanish there
std::optional<ExpandingEigenvalue> expanding_eigenvalue_at(const LambdaPolynomial& chi, int smoothness,
                                                           const std::vector<Rational>& point);

/// The ratios gamma that are tried: 1, 1/2, 1/4, .., the k/16 and their inverses.
std::vector<Rational> candidate_ratios();

/// Tries rational points: the candidate ratios, with `steps` values of each parameter in the region. Nothing found is no statement. \param region the parameters' intervals, without gamma
std::optional<ExpandingEigenvalue> find_expanding_eigenvalue(const LambdaPolynomial& chi, int smoothness,
                                                             const Box& region, int steps = 5, const Stop& stop = {});

}  // namespace limes
