// Random rationals, polynomials and boxes with fixed seeds, for property tests.
#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"
#include "algebra/polynomial/rational_function.hpp"

#include <random>

namespace limes::test {

class Generator {
 public:
  explicit Generator(unsigned seed) : engine_(seed) {}

  /// Uniform in [low, high]. The standard distributions differ between libraries, this does not.
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  bool coin() { return integer(0, 1) == 1; }
  Rational rational(int size = 9) { return Rational(Integer(integer(-size, size)), Integer(integer(1, size))); }
  Rational non_zero_rational(int size = 9) {
    const int n = integer(1, size);
    return Rational(Integer(coin() ? n : -n), Integer(integer(1, size)));
  }
  std::vector<Rational> point(int dimension, int size = 9) {
    std::vector<Rational> result;
    for (int i = 0; i < dimension; ++i) result.push_back(rational(size));
    return result;
  }

  Polynomial polynomial(int max_degree) {
    std::vector<Rational> coefficients;
    for (int n = integer(0, max_degree + 1); n > 0; --n) coefficients.push_back(rational());
    return Polynomial(coefficients);
  }

  MultivariatePolynomial multivariate(int variables, int max_degree, int max_terms) {
    std::vector<MultivariatePolynomial::Term> terms;
    for (int n = integer(0, max_terms); n > 0; --n) {
      MultivariatePolynomial::Term term{{}, rational()};
      for (int i = 0; i < variables; ++i) term.exponents.push_back(integer(0, max_degree));
      terms.push_back(term);
    }
    return MultivariatePolynomial::from_terms(variables, terms);
  }

  RationalFunction rational_function(int variables, int max_degree, int max_terms) {
    MultivariatePolynomial denominator(variables);
    while (denominator.is_zero()) denominator = multivariate(variables, max_degree, max_terms);
    return {multivariate(variables, max_degree, max_terms), denominator};
  }

  /// Some ends open, some axes points if asked.
  Box box(int dimension, bool points = false) {
    Box result;
    for (int i = 0; i < dimension; ++i) {
      const Rational lower = rational();
      if (points && integer(0, 2) == 0) {
        result.push_back(Interval::point(lower));
      } else {
        result.push_back({lower, lower + abs(non_zero_rational()), coin(), coin()});
      }
    }
    return result;
  }

  /// A point of the closed box.
  std::vector<Rational> point_in(const Box& box) {
    std::vector<Rational> result;
    for (const Interval& interval : box) {
      result.push_back(interval.lower + interval.width() * Rational(Integer(integer(0, 16)), Integer(16)));
    }
    return result;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace limes::test
