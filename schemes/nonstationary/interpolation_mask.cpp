// The masks of interpolatory schemes from the space that their new points are interpolated in.

#include "schemes/nonstationary/mask_sequence.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace limes {
namespace {

using Wave = ExponentialFunction::Wave;

/// n steps of x_{k+1} = 2 x x_k - x_{k-1}.
MultivariatePolynomial chebyshev(int n, MultivariatePolynomial before, MultivariatePolynomial current) {
  const MultivariatePolynomial x2 = Rational(2) * MultivariatePolynomial::variable(1, 0);
  for (int k = 0; k < n; ++k) {
    MultivariatePolynomial next = x2 * current - before;
    before = std::move(current);
    current = std::move(next);
  }
  return current;
}

bool is_cosine(Wave wave) { return wave == Wave::cos || wave == Wave::cosh; }
bool is_even(const ExponentialFunction& f) {
  const bool odd_wave = f.wave != Wave::none && !is_cosine(f.wave);
  return (f.degree % 2 == 0) != odd_wave;
}

/// The value at u half edges, u > 0 odd, of an even function times a constant.
MultivariatePolynomial value(const ExponentialFunction& f, int u) {
  const Rational scale = power(Rational(u), f.degree);
  if (f.wave == Wave::none) return MultivariatePolynomial::constant(1, scale);
  return scale * (is_cosine(f.wave) ? chebyshev_t(f.frequency * u) : chebyshev_u(f.frequency * u - 1));
}

void check_basis(const std::vector<ExponentialFunction>& basis) {
  constexpr std::size_t max_functions = 12;
  if (basis.empty() || basis.size() % 2 != 0 || basis.size() > max_functions) {
    throw InputError(
        fmt::format("a space of interpolation has an even number of functions, from 2 to {}", max_functions));
  }
  const auto partner = [](ExponentialFunction f) {
    constexpr Wave partners[] = {Wave::none, Wave::sin, Wave::cos, Wave::sinh, Wave::cosh};
    f.wave = partners[static_cast<int>(f.wave)];
    return f;
  };
  for (const ExponentialFunction& f : basis) {
    const bool hyperbolic = !fits(f, AngleType::trigonometric);
    if (std::any_of(basis.begin(), basis.end(),
                    [&](const auto& g) { return hyperbolic && !fits(g, AngleType::hyperbolic); })) {
      throw InputError("trigonometric and hyperbolic functions in one space");
    }
    if (f.frequency > 4) throw LimitError(fmt::format("{}: frequencies above 4", to_string(f)));
    for (const ExponentialFunction& g : {partner(f), ExponentialFunction{f.degree - 1, f.frequency, f.wave}}) {
      if (g.degree >= 0 && std::count(basis.begin(), basis.end(), g) == 0) {
        throw InputError(
            fmt::format("a space that contains {} and all its shifts also contains {}", to_string(f), to_string(g)));
      }
    }
  }
  const auto even = std::count_if(basis.begin(), basis.end(), is_even);
  if (2 * even != static_cast<std::ptrdiff_t>(basis.size())) {
    throw InputError(fmt::format("the space has {} even and {} odd functions, but needs as many of both", even,
                                 static_cast<std::ptrdiff_t>(basis.size()) - even));
  }
}

/// Solves the square system whose last column is the right-hand side, by elimination over Q(mu).
std::vector<RationalFunction> solve(std::vector<std::vector<RationalFunction>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                    [&](const auto& row) { return !row[k].is_zero(); });
    if (pivot == rows.end()) throw InputError("the functions do not determine the interpolant");
    std::swap(rows[k], *pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k].is_zero()) continue;
      const RationalFunction factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<RationalFunction> solution;
  for (std::size_t k = 0; k < n; ++k) solution.push_back(rows[k][n] / rows[k][k]);
  return solution;
}

}  // namespace

MultivariatePolynomial chebyshev_t(int n) {
  const MultivariatePolynomial x = MultivariatePolynomial::variable(1, 0);
  return chebyshev(n, x, MultivariatePolynomial::constant(1, 1));
}

MultivariatePolynomial chebyshev_u(int n) {
  return chebyshev(n + 1, MultivariatePolynomial::constant(1, -1), MultivariatePolynomial(1));
}

Mask interpolation_mask(const std::vector<ExponentialFunction>& basis) {
  check_basis(basis);
  // Basis and nodes are symmetric, so the weights are: sum_{j=1..n} c_j (g(u_j) + g(-u_j)) = g(0), u_j = 2j - 1, which odd
  // functions satisfy by themselves.
  const int n = static_cast<int>(basis.size()) / 2;
  std::vector<std::vector<RationalFunction>> rows;
  for (const ExponentialFunction& f : basis) {
    if (!is_even(f)) continue;
    std::vector<RationalFunction>& row = rows.emplace_back();
    for (int j = 1; j <= n; ++j) row.emplace_back(Rational(2) * value(f, 2 * j - 1));
    const bool one_at_zero = f.degree == 0;  // an even function with a sine has an odd power
    row.push_back(RationalFunction::constant(1, one_at_zero ? 1 : 0));
  }
  const std::vector<RationalFunction> weights = solve(std::move(rows));
  std::vector<RationalFunction> coefficients(static_cast<std::size_t>(4 * n - 1), RationalFunction(1));
  for (int j = 1; j <= n; ++j) {
    for (const int i : {2 * n - 2 * j, 2 * n - 2 + 2 * j})
      coefficients[static_cast<std::size_t>(i)] = weights[static_cast<std::size_t>(j - 1)];
  }
  coefficients[static_cast<std::size_t>(2 * n - 1)] = RationalFunction::constant(1, 1);
  return {2, LaurentPolynomial(1, 1 - 2 * n, std::move(coefficients))};
}

}  // namespace limes
