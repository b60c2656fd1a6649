#pragma once

#include "algebra/stop.hpp"
#include "analysis/nonuniform/lambda_polynomial.hpp"
#include "analysis/nonuniform/subdivision_matrix.hpp"

#include <optional>
#include <vector>

namespace limes {

/// det(lambda I - L) up to a factor that does not contain lambda: primitive, with coprime integer coefficients. Its
/// leading coefficient divides the product of the rows' denominators, so it does not vanish where none of these does.
///
/// Exact: the rows of the outermost knots and of the extraordinary one split off; unit rows are eliminated
/// (v_{2j} = v_j / lambda for an eigenvector v), which leaves det(I - mu L) = det S(mu), mu = 1/lambda, with a
/// polynomial (2n-2) x (2n-2) matrix S that is taken by evaluation and interpolation with proven degree bounds.
LambdaPolynomial characteristic_polynomial(const SubdivisionMatrix& matrix, const Stop& stop = {});

/// A factor of the characteristic polynomial: primitive, of positive degree in lambda.
struct CharacteristicFactor {
  LambdaPolynomial polynomial;
  int multiplicity = 1;
};

/// chi = (lambda - 1)(lambda - 1/2) .. (lambda - 2^{-m}) ell r / leading, where `leading` is the leading coefficient of
/// 1 * prod ell * prod r. [Karciauskas & Peters 2013, eq. (15)]
struct SplitCharacteristicPolynomial {
  int smoothness = 0;
  /// (lambda - 2^{-k}) divides chi for all k = 0..m; each was divided out exactly once. Otherwise the least k that does
  /// not divide (then those before it were divided out).
  std::optional<int> missing_eigenvalue;
  /// Linear factors found by exact division: lambda, lambda - 2^{-k} with k > m, lambda -+ e and lambda -+ 2e for the
  /// outer weights e of the rule for equal intervals.
  std::vector<CharacteristicFactor> ell;
  /// What remains, in coprime factors as far as they are found cheaply.
  std::vector<CharacteristicFactor> r;
  /// Of degree 4n-1 in lambda.
  LambdaPolynomial chi{0};

  MultivariatePolynomial leading() const;
  /// chi with gamma replaced by 1/gamma is chi times a power of gamma (and a sign): the eigenvalues for 1/gamma are
  /// those for gamma.
  bool is_symmetric() const;
};

/// p with gamma (the last variable) replaced by 1/gamma, times the least power of gamma that makes it a polynomial.
LambdaPolynomial mirrored(const LambdaPolynomial& p);

/// \pre smoothness >= 0
SplitCharacteristicPolynomial split_characteristic_polynomial(const SubdivisionMatrix& matrix, int smoothness,
                                                              const Stop& stop = {});

/// Coprime or equal factors with product p, up to a constant. Irreducible when cheap to find: a univariate
/// specialisation of the same degree that is irreducible proves p irreducible; otherwise small p are factored, of large
/// ones only a divisor that does not contain gamma. \pre p primitive of positive degree in lambda
std::vector<CharacteristicFactor> cheap_factors(const LambdaPolynomial& p);

}  // namespace limes
