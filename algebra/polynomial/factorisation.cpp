#include "algebra/polynomial/factorisation.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/polynomial_impl.hpp"

#include <flint/fmpz_poly_factor.h>

#include <algorithm>

namespace limes {

std::vector<std::pair<Polynomial, int>> irreducible_factors(const Polynomial& a) {
  if (a.is_zero()) throw DomainError("the irreducible factors of the zero polynomial");
  fmpz_poly_t integral;
  fmpz_poly_init(integral);
  fmpq_poly_get_numerator(integral, a.impl().poly);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, integral);
  std::vector<std::pair<Polynomial, int>> result;
  for (slong i = 0; i < factors->num; ++i) {
    Polynomial f;
    fmpq_poly_set_fmpz_poly(f.impl().poly, factors->p + i);
    f *= 1 / f.leading_coefficient();
    result.emplace_back(std::move(f), int(factors->exp[i]));
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(integral);
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& f, const auto& g) { return f.first.degree() < g.first.degree(); });
  return result;
}

}  // namespace limes
