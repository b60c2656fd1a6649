// The FLINT inside of MultivariatePolynomial. Included by sources only.
#pragma once

#include "algebra/number/flint_conversion.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <flint/fmpq_mpoly.h>

namespace limes {

/// The one context (lexicographic order) of polynomials in so many variables, made on first use and never freed. FLINT
/// counts at least one variable: a polynomial in none lives in the context of one that does not occur.
/// \throws DomainError for a negative number, LimitError above 64.
const fmpq_mpoly_ctx_struct* flint_context(int variables);

struct MultivariatePolynomial::Impl {
  explicit Impl(int variables_) : variables(variables_), context(flint_context(variables_)) {
    fmpq_mpoly_init(poly, context);
  }
  Impl(const Impl& other) : variables(other.variables), context(other.context) {
    fmpq_mpoly_init(poly, context);
    fmpq_mpoly_set(poly, other.poly, context);
  }
  Impl& operator=(const Impl&) = delete;
  ~Impl() { fmpq_mpoly_clear(poly, context); }

  int variables;
  const fmpq_mpoly_ctx_struct* context;
  fmpq_mpoly_t poly;
};

}  // namespace limes
