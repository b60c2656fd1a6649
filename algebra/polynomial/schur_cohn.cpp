// Roots relative to a circle. After scaling to the unit circle, with p*(z) = z^n p(1/z):
//   g = gcd(p, p*) holds the roots on the circle and the pairs z, 1/z; it is self-reciprocal, and Sturm's theorem in
//   x = z + 1/z counts them (x in (-2, 2) is a pair on the circle);
//   q = p / g has neither, and then the Schur-Cohn form of q is regular, with one positive square per root inside.
// [Schur 1918; Cohn 1922; Marden 1966, chapter X]
#include "algebra/polynomial/schur_cohn.hpp"

#include "algebra/error.hpp"
#include "algebra/matrix/rational_matrix.hpp"
#include "algebra/polynomial/real_roots.hpp"

#include <algorithm>

namespace limes {

namespace {

void check_arguments(const Polynomial& a, const Rational& radius) {
  if (a.is_zero()) throw DomainError("the roots of the zero polynomial were counted by a circle");
  if (radius <= 0) throw DomainError("roots were counted by a circle whose radius is not positive");
}

// a(radius z), whose roots lie about the unit circle as those of a about the given one.
Polynomial scaled_to_unit_circle(const Polynomial& a, const Rational& radius) {
  std::vector<Rational> coefficients = a.coefficients();
  Rational factor = 1;
  for (auto& c : coefficients) {
    c *= factor;
    factor *= radius;
  }
  return Polynomial(coefficients);
}

// Divides by (z - root) as often as possible; returns how often.
int divide_root(Polynomial& p, const Rational& root) {
  const Polynomial factor({-root, 1});
  int times = 0;
  while (p.degree() > 0 && p(root) == 0) {
    p = divide(p, factor).first;
    ++times;
  }
  return times;
}

// H with h(z) = z^m H(z + 1/z). \pre h has even degree 2m and is palindromic
Polynomial in_z_plus_inverse(const Polynomial& h) {
  const int m = h.degree() / 2;
  const Polynomial x = Polynomial::monomial(1, 1);
  // t_k = z^k + z^{-k} as a polynomial in x: t_{k+1} = x t_k - t_{k-1}.
  Polynomial before = Polynomial::constant(2);
  Polynomial now = x;
  Polynomial result = Polynomial::constant(h.coefficient(m));
  for (int k = 1; k <= m; ++k) {
    result += h.coefficient(m + k) * now;
    Polynomial next = x * now - before;
    before = std::move(now);
    now = std::move(next);
  }
  return result;
}

// g = c g*, g(0) != 0.
CircleCount count_self_reciprocal(Polynomial g) {
  CircleCount result;
  result.on = divide_root(g, 1) + divide_root(g, -1);
  // Without the roots 1 and -1 the degree is even and g = g*.
  if (g.degree() % 2 != 0 || g != reversed(g)) throw InternalError("a self-reciprocal polynomial is not palindromic");
  if (g.degree() == 0) return result;
  for (const auto& [factor, multiplicity] : square_free_factorisation(in_z_plus_inverse(g))) {
    const int on = count_real_roots(factor, -2, 2);
    result.on += 2 * multiplicity * on;
    result.inside += multiplicity * (factor.degree() - on);
    result.outside += multiplicity * (factor.degree() - on);
  }
  return result;
}

// gcd(q, q*) = 1. The form is L(q*) L(q*)^T - L(q) L(q)^T with the lower triangular Toeplitz matrices of the first n
// coefficients, L(q)_{ij} = q_{i-j}.
CircleCount count_regular(const Polynomial& q) {
  const int n = q.degree();
  RationalMatrix form(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      // Along a diagonal each entry adds one product to the previous one.
      Rational entry = q.coefficient(n - i) * q.coefficient(n - j) - q.coefficient(i) * q.coefficient(j);
      if (j > 0) entry += form(i - 1, j - 1);
      form(i, j) = form(j, i) = entry;
    }
  }
  // The eigenvalues are real and not zero, so Descartes' rule counts the positive ones exactly.
  int positive = 0;
  int last = 0;
  const Polynomial chi = characteristic_polynomial(form);
  if (chi.coefficient(0) == 0) throw InternalError("a Schur-Cohn form is singular");
  for (int i = 0; i <= n; ++i) {
    const int sign = chi.coefficient(i).sign();
    if (sign == 0) continue;
    if (sign == -last) ++positive;
    last = sign;
  }
  return {positive, 0, n - positive};
}

// Integer coefficients without a common factor.
std::vector<Integer> primitive_coefficients(const Polynomial& a) {
  Integer common = 1;
  for (const auto& c : a.coefficients()) common = lcm(common, denominator(c));
  std::vector<Integer> result;
  for (const auto& c : a.coefficients()) result.push_back(numerator(c) * (common / denominator(c)));
  return result;
}

void divide_content(std::vector<Integer>& coefficients) {
  Integer content = 0;
  for (const auto& c : coefficients) content = gcd(content, c);
  if (content > 1)
    for (auto& c : coefficients) c /= content;
}

}  // namespace

CircleCount count_roots_by_circle(const Polynomial& a, const Rational& radius) {
  check_arguments(a, radius);
  Polynomial p = scaled_to_unit_circle(a, radius);
  const int at_zero = divide_root(p, 0);
  const Polynomial g = gcd(p, reversed(p));
  CircleCount result = count_self_reciprocal(g);
  const CircleCount rest = count_regular(divide(p, g).first);
  result.inside += at_zero + rest.inside;
  result.outside += rest.outside;
  return result;
}

// p of degree n has all its roots inside exactly when |p_0| < |p_n| and (p_n p - p_0 p*) / z, of degree n - 1, has.
bool roots_inside_circle(const Polynomial& a, const Rational& radius) {
  check_arguments(a, radius);
  std::vector<Integer> p = primitive_coefficients(scaled_to_unit_circle(a, radius));
  while (p.size() > 1) {
    divide_content(p);
    const Integer first = p.front();
    const Integer last = p.back();
    if (abs(first) >= abs(last)) return false;
    std::vector<Integer> next;
    for (std::size_t i = 1; i < p.size(); ++i) next.push_back(last * p[i] - first * p[p.size() - 1 - i]);
    p = std::move(next);
  }
  return true;
}

}  // namespace limes
