#include "analysis/nonuniform/split_characteristic_polynomial.hpp"

#include "algebra/error.hpp"
#include "analysis/nonuniform/polynomial_determinant.hpp"

#include <numeric>

namespace limes {

namespace {

// The odd indices j with |j| <= 2n-3, left to right.
std::vector<int> inner_odd_indices(int points) {
  std::vector<int> result;
  for (int j = 3 - points; j <= points - 3; j += 2) result.push_back(j);
  return result;
}

// S(mu) = D - sum_{k >= 0} mu^{k+1} N_k with (N_k)_{rc} = D_r L_{r, 2^k c}, r and c odd; variables mu, then those of L.
// Rows are multiplied by their denominators D_r.
PolynomialMatrix eliminated(const SubdivisionMatrix& matrix) {
  const int variables = matrix.variables();
  std::vector<int> shift(static_cast<std::size_t>(variables));
  std::iota(shift.begin(), shift.end(), 1);
  const auto lifted = [&](const MultivariatePolynomial& p) { return p.mapped(variables + 1, shift); };
  const auto mu = MultivariatePolynomial::variable(variables + 1, 0);

  const std::vector<int> odd = inner_odd_indices(matrix.points());
  const int size = static_cast<int>(odd.size());
  PolynomialMatrix result(variables + 1, size, size);
  for (int i = 0; i < size; ++i) {
    const int row = odd[static_cast<std::size_t>(i)];
    result(i, i) = lifted(matrix.row_denominator(row));
    for (int j = 0; j < size; ++j) {
      MultivariatePolynomial factor = mu;
      for (int column = odd[static_cast<std::size_t>(j)]; std::abs(column) <= matrix.points() - 2; column *= 2) {
        result(i, j) -= factor * lifted(matrix.row_numerator(row, column));
        factor *= mu;
      }
    }
  }
  return result;
}

LambdaPolynomial constant_root(int variables, const Rational& root) {
  return primitive_part(LambdaPolynomial::linear(MultivariatePolynomial::constant(variables, 1),
                                                 MultivariatePolynomial::constant(variables, root)))
      .part;
}

// denominator(e) lambda - factor numerator(e)
LambdaPolynomial function_root(const RationalFunction& e, const Rational& factor) {
  return primitive_part(LambdaPolynomial::linear(e.denominator(), factor * e.numerator())).part;
}

// Divides out a linear factor as often as it goes.
void divide_out(const LambdaPolynomial& factor, LambdaPolynomial& rest, std::vector<CharacteristicFactor>& found) {
  int multiplicity = 0;
  while (rest.degree() > 0) {
    auto quotient = exact_quotient(rest, factor);
    if (!quotient) break;
    rest = std::move(*quotient);
    ++multiplicity;
  }
  if (multiplicity > 0) found.push_back({factor, multiplicity});
}

std::vector<CharacteristicFactor> all_factors(const LambdaPolynomial& p) {
  std::vector<CharacteristicFactor> result;
  for (const auto& [factor, multiplicity] : factorisation(p.expanded())) {
    auto q = LambdaPolynomial::from_expanded(factor);
    if (q.degree() > 0) result.push_back({primitive_part(q).part, multiplicity});
  }
  return result;
}

// A factor of p would be one of the specialisation, of positive degree since the leading coefficient does not vanish.
bool has_irreducible_specialisation(const LambdaPolynomial& p) {
  for (int attempt = 0; attempt < 6; ++attempt) {
    std::vector<Rational> point;
    for (int i = 0; i < p.variables(); ++i) point.push_back(Rational(2 * attempt + 3 + i) / (7 * i + 5 + attempt));
    const Polynomial at = p.at(point);
    if (at.degree() != p.degree()) continue;
    const auto factors = factorisation(MultivariatePolynomial::from_univariate(1, 0, at));
    if (factors.size() == 1 && factors.front().second == 1) return true;
  }
  return false;
}

constexpr std::size_t few_terms = 300;

// gcd of the coefficients with respect to the last variable, gamma.
LambdaPolynomial part_without_gamma(const LambdaPolynomial& p) {
  const MultivariatePolynomial expanded = p.expanded();
  MultivariatePolynomial divisor(expanded.variables());
  for (const auto& c : expanded.coefficients(p.variables())) {
    if (divisor.is_zero() || divisor.degree(0) > 0) divisor = gcd(divisor, c);
  }
  return LambdaPolynomial::from_expanded(divisor);
}

void append(std::vector<CharacteristicFactor>& result, std::vector<CharacteristicFactor> more) {
  for (auto& factor : more) {
    const auto same =
        std::find_if(result.begin(), result.end(), [&](const auto& f) { return f.polynomial == factor.polynomial; });
    if (same != result.end()) {
      same->multiplicity += factor.multiplicity;
    } else {
      result.push_back(std::move(factor));
    }
  }
}

}  // namespace

std::vector<CharacteristicFactor> cheap_factors(const LambdaPolynomial& p) {
  if (p.degree() <= 1 || has_irreducible_specialisation(p)) return {{p, 1}};
  if (p.expanded().term_count() <= few_terms) return all_factors(p);
  const LambdaPolynomial divisor = part_without_gamma(p);
  if (divisor.degree() <= 0 || divisor.degree() == p.degree()) return {{p, 1}};
  const LambdaPolynomial factor = primitive_part(divisor).part;
  std::vector<CharacteristicFactor> result = cheap_factors(factor);
  append(result, cheap_factors(primitive_part(*exact_quotient(p, factor)).part));
  return result;
}

LambdaPolynomial characteristic_polynomial(const SubdivisionMatrix& matrix, const Stop& stop) {
  const int variables = matrix.variables();
  const int last = matrix.points() - 1;
  // det(I - mu L), read backwards, is the characteristic polynomial of the inner block without the extraordinary knot.
  const LambdaPolynomial inverse = LambdaPolynomial::from_expanded(determinant(eliminated(matrix), stop));
  std::vector<MultivariatePolynomial> coefficients(static_cast<std::size_t>(2 * last - 1),
                                                   MultivariatePolynomial(variables));
  for (std::size_t k = 0; k < inverse.coefficients().size(); ++k) {
    coefficients[coefficients.size() - 1 - k] = inverse.coefficients()[k];
  }
  stop.check();
  LambdaPolynomial result = primitive_part(LambdaPolynomial(variables, std::move(coefficients))).part;
  result = result * constant_root(variables, 1);
  result = result * function_root(matrix.entry(-last, -last), 1);
  result = result * function_root(matrix.entry(last, last), 1);
  return result;
}

SplitCharacteristicPolynomial split_characteristic_polynomial(const SubdivisionMatrix& matrix, int smoothness,
                                                              const Stop& stop) {
  const int variables = matrix.variables();
  const int last = matrix.points() - 1;
  SplitCharacteristicPolynomial result;
  result.smoothness = smoothness;
  result.chi = characteristic_polynomial(matrix, stop);

  LambdaPolynomial rest = result.chi;
  for (int k = 0; k <= smoothness && !result.missing_eigenvalue; ++k) {
    if (auto quotient = exact_quotient(rest, constant_root(variables, power(Rational(2), -k)))) {
      rest = std::move(*quotient);
    } else {
      result.missing_eigenvalue = k;
    }
  }
  divide_out(
      LambdaPolynomial::linear(MultivariatePolynomial::constant(variables, 1), MultivariatePolynomial(variables)), rest,
      result.ell);
  for (int k = smoothness + 1; k <= 2 * matrix.points(); ++k) {
    divide_out(constant_root(variables, power(Rational(2), -k)), rest, result.ell);
  }
  for (const int corner : {-last, last}) {
    const RationalFunction e = matrix.entry(corner, corner);
    if (e.is_zero()) continue;
    for (const int factor : {1, -1, 2, -2}) {
      stop.check();
      divide_out(function_root(e, factor), rest, result.ell);
    }
  }
  if (rest.degree() > 0) result.r = cheap_factors(primitive_part(rest).part);
  return result;
}

MultivariatePolynomial SplitCharacteristicPolynomial::leading() const {
  MultivariatePolynomial result = MultivariatePolynomial::constant(chi.variables(), 1);
  for (const auto* factors : {&ell, &r}) {
    for (const auto& factor : *factors) result *= power(factor.polynomial.leading(), factor.multiplicity);
  }
  return result;
}

LambdaPolynomial mirrored(const LambdaPolynomial& p) {
  const auto gamma = static_cast<std::size_t>(p.variables() - 1);
  const int degree = p.degrees()[gamma];
  std::vector<MultivariatePolynomial> result;
  for (const auto& d : p.coefficients()) {
    auto terms = d.terms();
    for (auto& term : terms) term.exponents[gamma] = degree - term.exponents[gamma];
    result.push_back(MultivariatePolynomial::from_terms(p.variables(), terms));
  }
  return {p.variables(), std::move(result)};
}

bool SplitCharacteristicPolynomial::is_symmetric() const { return primitive_part(mirrored(chi)).part == chi; }

}  // namespace limes
