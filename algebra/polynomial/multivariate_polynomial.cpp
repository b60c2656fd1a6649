#include "algebra/polynomial/multivariate_polynomial.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/multivariate_polynomial_impl.hpp"
#include "algebra/polynomial/polynomial_impl.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace limes {

namespace {

constexpr int max_variables = 64;
constexpr slong max_degree = 1000000000;

struct Contexts {
  Contexts() {
    for (int n = 0; n <= max_variables; ++n) fmpq_mpoly_ctx_init(&context[n], std::max(n, 1), ORD_LEX);
  }
  std::array<fmpq_mpoly_ctx_struct, max_variables + 1> context;
};

void require_same(int a, int b) {
  if (a != b) {
    throw DomainError("polynomials in " + std::to_string(a) + " and in " + std::to_string(b) + " variables do not mix");
  }
}

void require_index(int index, int variables) {
  if (index < 0 || index >= variables) {
    throw DomainError("there is no variable x_" + std::to_string(index) + " among " + std::to_string(variables));
  }
}

/// FLINT's exponents are unbounded, ours are not.
void require_small_degrees(const MultivariatePolynomial::Impl& p) {
  if (fmpq_mpoly_degrees_fit_si(p.poly, p.context)) {
    std::array<slong, max_variables> degrees;
    fmpq_mpoly_degrees_si(degrees.data(), p.poly, p.context);
    const auto end = degrees.begin() + std::max(p.variables, 1);
    if (std::all_of(degrees.begin(), end, [](slong d) { return d <= max_degree; })) return;
  }
  throw LimitError("a polynomial of degree above " + std::to_string(max_degree));
}

[[noreturn]] void fail(const char* what) { throw LimitError(std::string("the polynomials are too large for ") + what); }

}  // namespace

const fmpq_mpoly_ctx_struct* flint_context(int variables) {
  if (variables < 0) throw DomainError("a negative number of variables");
  if (variables > max_variables) throw LimitError("more than " + std::to_string(max_variables) + " variables");
  // Never freed: static polynomials may outlive any static table.
  static const Contexts& contexts = *new Contexts;
  clean_up_flint_at_thread_exit();
  return &contexts.context[static_cast<std::size_t>(variables)];
}

MultivariatePolynomial::MultivariatePolynomial() : MultivariatePolynomial(0) {}
MultivariatePolynomial::MultivariatePolynomial(int variables) : impl_(std::make_unique<Impl>(variables)) {}

MultivariatePolynomial MultivariatePolynomial::constant(int variables, const Rational& c) {
  MultivariatePolynomial result(variables);
  const FlintRational value(c);
  fmpq_mpoly_set_fmpq(result.impl_->poly, value.data, result.impl_->context);
  return result;
}

MultivariatePolynomial MultivariatePolynomial::variable(int variables, int index) {
  require_index(index, variables);
  MultivariatePolynomial result(variables);
  fmpq_mpoly_gen(result.impl_->poly, index, result.impl_->context);
  return result;
}

MultivariatePolynomial MultivariatePolynomial::from_terms(int variables, const std::vector<Term>& terms) {
  MultivariatePolynomial result(variables);
  auto& [count, context, p] = *result.impl_;
  // Integers over one common denominator: pushing fractions one by one would rescale the whole polynomial each time.
  Integer common = 1;
  for (const Term& term : terms) {
    mpz_lcm(common.backend().data(), common.backend().data(), mpq_denref(term.coefficient.backend().data()));
  }
  std::array<ulong, max_variables> exponents{};
  for (const Term& term : terms) {
    require_same(static_cast<int>(term.exponents.size()), count);
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] < 0) throw DomainError("a negative exponent in a polynomial");
      exponents[i] = static_cast<ulong>(term.exponents[i]);
    }
    Integer value;
    mpz_divexact(value.backend().data(), common.backend().data(), mpq_denref(term.coefficient.backend().data()));
    mpz_mul(value.backend().data(), value.backend().data(), mpq_numref(term.coefficient.backend().data()));
    const FlintInteger coefficient(value);
    fmpq_mpoly_push_term_fmpz_ui(p, coefficient.data, exponents.data(), context);
  }
  fmpq_mpoly_sort_terms(p, context);
  fmpq_mpoly_combine_like_terms(p, context);
  const FlintInteger denominator(common);
  fmpq_mpoly_scalar_div_fmpz(p, p, denominator.data, context);
  return result;
}

MultivariatePolynomial::MultivariatePolynomial(const MultivariatePolynomial& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {}
MultivariatePolynomial::MultivariatePolynomial(MultivariatePolynomial&&) noexcept = default;
MultivariatePolynomial& MultivariatePolynomial::operator=(MultivariatePolynomial&&) noexcept = default;
MultivariatePolynomial::~MultivariatePolynomial() = default;

MultivariatePolynomial& MultivariatePolynomial::operator=(const MultivariatePolynomial& other) {
  if (impl_ && impl_->context == other.impl_->context) {
    fmpq_mpoly_set(impl_->poly, other.impl_->poly, impl_->context);
  } else {
    impl_ = std::make_unique<Impl>(*other.impl_);
  }
  return *this;
}

int MultivariatePolynomial::variables() const { return impl_->variables; }
bool MultivariatePolynomial::is_zero() const { return fmpq_mpoly_is_zero(impl_->poly, impl_->context) != 0; }
bool MultivariatePolynomial::is_constant() const { return fmpq_mpoly_is_fmpq(impl_->poly, impl_->context) != 0; }
std::size_t MultivariatePolynomial::term_count() const {
  return static_cast<std::size_t>(fmpq_mpoly_length(impl_->poly, impl_->context));
}

Rational MultivariatePolynomial::constant_value() const {
  if (!is_constant()) throw DomainError("the polynomial is not constant");
  FlintRational value;
  fmpq_mpoly_get_fmpq(value.data, impl_->poly, impl_->context);
  return from_fmpq(value.data);
}

int MultivariatePolynomial::degree(int index) const {
  require_index(index, impl_->variables);
  if (is_zero()) return -1;
  require_small_degrees(*impl_);
  return static_cast<int>(fmpq_mpoly_degree_si(impl_->poly, index, impl_->context));
}

std::vector<int> MultivariatePolynomial::degrees() const {
  std::vector<int> result(static_cast<std::size_t>(impl_->variables));
  if (is_zero()) return result;
  require_small_degrees(*impl_);
  std::array<slong, max_variables> degrees;
  fmpq_mpoly_degrees_si(degrees.data(), impl_->poly, impl_->context);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<int>(degrees[i]);
  return result;
}

std::vector<MultivariatePolynomial::Term> MultivariatePolynomial::terms() const {
  if (is_zero()) return {};
  require_small_degrees(*impl_);
  std::vector<Term> result(term_count());
  std::array<ulong, max_variables> exponents;
  FlintRational coefficient;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto position = static_cast<slong>(i);
    fmpq_mpoly_get_term_exp_ui(exponents.data(), impl_->poly, position, impl_->context);
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.data, impl_->poly, position, impl_->context);
    result[i].exponents.assign(exponents.begin(), exponents.begin() + impl_->variables);
    result[i].coefficient = from_fmpq(coefficient.data);
  }
  return result;
}

Rational MultivariatePolynomial::operator()(std::span<const Rational> point) const {
  require_same(static_cast<int>(point.size()), impl_->variables);
  std::array<fmpq, max_variables> values;
  std::array<fmpq*, max_variables> pointers;
  const std::size_t count = std::max<std::size_t>(point.size(), 1);
  for (std::size_t i = 0; i < count; ++i) {
    fmpq_init(&values[i]);
    if (i < point.size()) to_fmpq(&values[i], point[i]);
    pointers[i] = &values[i];
  }
  FlintRational value;
  const int done = fmpq_mpoly_evaluate_all_fmpq(value.data, impl_->poly, pointers.data(), impl_->context);
  for (std::size_t i = 0; i < count; ++i) fmpq_clear(&values[i]);
  if (!done) fail("evaluation");
  return from_fmpq(value.data);
}

MultivariatePolynomial MultivariatePolynomial::substitute(int index, const Rational& value) const {
  require_index(index, impl_->variables);
  MultivariatePolynomial result(impl_->variables);
  const FlintRational at(value);
  const auto* context = impl_->context;
  if (!fmpq_mpoly_evaluate_one_fmpq(result.impl_->poly, impl_->poly, index, at.data, context)) fail("substitution");
  return result;
}

MultivariatePolynomial MultivariatePolynomial::substitute(int index, const MultivariatePolynomial& q) const {
  require_same(impl_->variables, q.impl_->variables);
  const std::vector<MultivariatePolynomial> parts = coefficients(index);
  MultivariatePolynomial result(impl_->variables);
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    result *= q;
    result += *part;
  }
  return result;
}

MultivariatePolynomial MultivariatePolynomial::mapped(int variables, std::span<const int> map) const {
  MultivariatePolynomial result(variables);
  const int count = impl_->variables;
  std::array<int, max_variables> used{};
  fmpq_mpoly_used_vars(used.data(), impl_->poly, impl_->context);
  // FLINT's image -1 means 0; it is given only to variables that do not occur.
  std::array<slong, max_variables> images;
  images.fill(-1);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (k < map.size() && map[k] >= 0 && map[k] < variables) {
      images[k] = map[k];
    } else if (used[k]) {
      throw DomainError("the variable x_" + std::to_string(i) + " occurs but has no image");
    }
  }
  fmpq_mpoly_compose_fmpq_mpoly_gen(result.impl_->poly, impl_->poly, images.data(), impl_->context,
                                    result.impl_->context);
  return result;
}

std::vector<MultivariatePolynomial> MultivariatePolynomial::coefficients(int index) const {
  const int n = degree(index);
  if (n > 10000000) throw LimitError("the coefficients of a polynomial of degree " + std::to_string(n));
  std::vector<MultivariatePolynomial> result(static_cast<std::size_t>(n + 1), MultivariatePolynomial(impl_->variables));
  const auto* context = impl_->context;
  fmpq_mpoly_univar_t parts;
  fmpq_mpoly_univar_init(parts, context);
  fmpq_mpoly_to_univar(parts, impl_->poly, index, context);
  for (slong i = 0; i < fmpq_mpoly_univar_length(parts, context); ++i) {
    const auto exponent = static_cast<std::size_t>(fmpq_mpoly_univar_get_term_exp_si(parts, i, context));
    fmpq_mpoly_univar_swap_term_coeff(result[exponent].impl_->poly, parts, i, context);
  }
  fmpq_mpoly_univar_clear(parts, context);
  return result;
}

Polynomial MultivariatePolynomial::univariate(int index) const {
  require_index(index, impl_->variables);
  // FLINT 2.9 ignores other variables where its manual promises failure.
  const std::vector<int> powers = degrees();
  for (int i = 0; i < impl_->variables; ++i) {
    if (i != index && powers[static_cast<std::size_t>(i)] > 0) {
      throw DomainError("the polynomial contains other variables than x_" + std::to_string(index));
    }
  }
  Polynomial result;
  if (!fmpq_mpoly_get_fmpq_poly(result.impl().poly, impl_->poly, index, impl_->context)) fail("one variable");
  return result;
}

MultivariatePolynomial MultivariatePolynomial::from_univariate(int variables, int index, const Polynomial& p) {
  require_index(index, variables);
  MultivariatePolynomial result(variables);
  fmpq_mpoly_set_fmpq_poly(result.impl_->poly, p.impl().poly, index, result.impl_->context);
  return result;
}

MultivariatePolynomial MultivariatePolynomial::operator-() const {
  MultivariatePolynomial result(impl_->variables);
  fmpq_mpoly_neg(result.impl_->poly, impl_->poly, impl_->context);
  return result;
}

MultivariatePolynomial& MultivariatePolynomial::operator+=(const MultivariatePolynomial& other) {
  require_same(impl_->variables, other.impl_->variables);
  fmpq_mpoly_add(impl_->poly, impl_->poly, other.impl_->poly, impl_->context);
  return *this;
}

MultivariatePolynomial& MultivariatePolynomial::operator-=(const MultivariatePolynomial& other) {
  require_same(impl_->variables, other.impl_->variables);
  fmpq_mpoly_sub(impl_->poly, impl_->poly, other.impl_->poly, impl_->context);
  return *this;
}

MultivariatePolynomial& MultivariatePolynomial::operator*=(const MultivariatePolynomial& other) {
  require_same(impl_->variables, other.impl_->variables);
  fmpq_mpoly_mul(impl_->poly, impl_->poly, other.impl_->poly, impl_->context);
  return *this;
}

MultivariatePolynomial& MultivariatePolynomial::operator*=(const Rational& c) {
  const FlintRational factor(c);
  fmpq_mpoly_scalar_mul_fmpq(impl_->poly, impl_->poly, factor.data, impl_->context);
  return *this;
}

bool operator==(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
  require_same(a.impl_->variables, b.impl_->variables);
  return fmpq_mpoly_equal(a.impl_->poly, b.impl_->poly, a.impl_->context) != 0;
}

}  // namespace limes
