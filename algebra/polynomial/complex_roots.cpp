#include "algebra/polynomial/complex_roots.hpp"

#include "algebra/error.hpp"
#include "algebra/number/arb_conversion.hpp"
#include "algebra/polynomial/polynomial_impl.hpp"

#include <acb.h>
#include <arb_fmpz_poly.h>

#include <algorithm>

namespace limes {
namespace {

/// Integer coefficients of a positive multiple.
class IntegerPolynomial {
 public:
  explicit IntegerPolynomial(const Polynomial& a) {
    fmpz_poly_init(value);
    fmpq_poly_get_numerator(value, a.impl().poly);
  }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value); }
  fmpz_poly_t value;
};

/// Replaces the enclosure of a real root by the root when the simplest rational in it is one.
void make_exact(ComplexRoot& root, const Polynomial& a, int bits) {
  if (!root.is_real()) return;
  const Rational x = simplest_between(root.re.lower, root.re.upper);
  if (denominator(x) >= Integer(1) << (bits / 2) || a(x) != 0) return;
  root.re = Interval::point(x);
  root.modulus = Interval::point(abs(x));
}

std::vector<ComplexRoot> simple_roots(const Polynomial& square_free, int bits) {
  std::vector<ComplexRoot> roots;
  const int degree = square_free.degree();
  if (degree < 1) return roots;
  const IntegerPolynomial integral(square_free);
  const Balls balls(static_cast<std::size_t>(degree));
  arb_fmpz_poly_complex_roots(balls.data(), integral.value, 0, bits);
  RealBall modulus;
  for (std::size_t k = 0; k < balls.count(); ++k) {
    acb_abs(modulus.data, balls[k], bits + 16);
    ComplexRoot root{enclosure(acb_realref(balls[k])), enclosure(acb_imagref(balls[k])), enclosure(modulus.data), 1};
    root.modulus.lower = std::max(root.modulus.lower, Rational(0));
    make_exact(root, square_free, bits);
    roots.push_back(std::move(root));
  }
  return roots;
}

/// Where the enclosures overlap, the order is that of equal numbers. Enclosures are so narrow that chains of overlapping ones
/// that are no cluster of equal moduli do not occur in practice; then the order is still a fixed one.
bool comes_first(const ComplexRoot& a, const ComplexRoot& b) {
  const auto above = [](const Interval& x, const Interval& y) { return x.lower > y.upper; };
  if (above(a.modulus, b.modulus) || above(b.modulus, a.modulus)) return a.modulus.lower > b.modulus.lower;
  if (a.is_real() != b.is_real()) return a.is_real();
  if (above(a.re, b.re) || above(b.re, a.re)) return a.re.lower > b.re.lower;
  return a.im.lower > b.im.lower;
}

}  // namespace

std::vector<ComplexRoot> enclose_complex_roots(const Polynomial& a, int bits) {
  if (bits < 16 || bits > 4096) throw DomainError("complex roots to fewer than 16 or more than 4096 bits");
  clean_up_flint_at_thread_exit();
  std::vector<ComplexRoot> roots;
  for (const auto& [factor, multiplicity] : square_free_factorisation(a)) {
    for (ComplexRoot& root : simple_roots(factor, bits)) {
      root.multiplicity = multiplicity;
      // Insertion keeps the order definite even where comes_first is not transitive.
      const auto place = std::find_if(roots.begin(), roots.end(), [&](const ComplexRoot& other) { return comes_first(root, other); });
      roots.insert(place, std::move(root));
    }
  }
  return roots;
}

}  // namespace limes
