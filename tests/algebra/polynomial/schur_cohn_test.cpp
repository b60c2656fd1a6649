#include "algebra/polynomial/schur_cohn.hpp"

#include "algebra/error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

Polynomial linear(const Rational& root) { return Polynomial({-root, 1}); }
// The pair of roots r (c +- i s), c = cosine, as z^2 - 2 r c z + r^2.
Polynomial conjugate_pair(const Rational& modulus, const Rational& cosine) {
  return Polynomial({modulus * modulus, -2 * modulus * cosine, 1});
}

void expect_count(const Polynomial& a, const Rational& radius, int inside, int on, int outside) {
  const CircleCount count = count_roots_by_circle(a, radius);
  EXPECT_EQ(count.inside, inside) << to_string(a, "z");
  EXPECT_EQ(count.on, on) << to_string(a, "z");
  EXPECT_EQ(count.outside, outside) << to_string(a, "z");
  EXPECT_EQ(roots_inside_circle(a, radius), on == 0 && outside == 0) << to_string(a, "z");
}

TEST(SchurCohn, SmallCases) {
  expect_count(Polynomial::constant(-7), 1, 0, 0, 0);
  expect_count(linear(Rational(1, 2)), 1, 1, 0, 0);
  expect_count(linear(1), 1, 0, 1, 0);
  expect_count(linear(-1), 1, 0, 1, 0);
  expect_count(linear(-3), 1, 0, 0, 1);
  expect_count(linear(-3), 4, 1, 0, 0);
  expect_count(linear(-3), 3, 0, 1, 0);
  expect_count(Polynomial::monomial(5, 6), Rational(1, 1000), 6, 0, 0);
  expect_count(Polynomial({-2, 0, 1}), Rational(1414, 1000), 0, 0, 2);
  expect_count(Polynomial({-2, 0, 1}), Rational(1415, 1000), 2, 0, 0);
}

TEST(SchurCohn, ReciprocalPairsAreNeitherOnTheCircle) {
  expect_count(linear(2) * linear(Rational(1, 2)), 1, 1, 0, 1);
  expect_count(linear(2) * linear(Rational(-1, 2)), 1, 1, 0, 1);
  expect_count(power(linear(2), 3) * linear(Rational(1, 2)), 1, 1, 0, 3);
  expect_count(linear(6) * linear(Rational(2, 3)), 2, 1, 0, 1);
  // The quartic z^4 + 3 z^3 + 3 z^2 + 3 z + 1: x^2 + 3 x + 1 with x = z + 1/z has one root in (-2, 2).
  expect_count(Polynomial({1, 3, 3, 3, 1}), 1, 1, 2, 1);
  // z^4 + 3 z^2 + 1: purely imaginary reciprocal pairs, x^2 + 1.
  expect_count(Polynomial({1, 0, 3, 0, 1}), 1, 2, 0, 2);
  // Lehmer's polynomial: one root outside, one inside, eight on the circle.
  expect_count(Polynomial({1, 1, 0, -1, -1, -1, -1, -1, 0, 1, 1}), 1, 1, 8, 1);
}

TEST(SchurCohn, CyclotomicsLieOnTheCircle) {
  for (int n = 1; n <= 40; ++n) {
    const Polynomial phi = cyclotomic(n);
    expect_count(phi, 1, 0, phi.degree(), 0);
    expect_count(phi, Rational(999, 1000), 0, 0, phi.degree());
    expect_count(phi, Rational(1001, 1000), phi.degree(), 0, 0);
    expect_count(power(phi, 2) * linear(Rational(1, 3)), 1, 1, 2 * phi.degree(), 0);
  }
}

TEST(SchurCohn, RootsCloseToTheCircle) {
  const Rational epsilon(1, Integer(1) << 300);
  expect_count(linear(1 - epsilon), 1, 1, 0, 0);
  expect_count(linear(1 + epsilon) * linear(1 - epsilon), 1, 1, 0, 1);
  expect_count(conjugate_pair(1 - epsilon, Rational(3, 5)) * conjugate_pair(1, Rational(3, 5)), 1, 2, 2, 0);
}

TEST(SchurCohn, Errors) {
  EXPECT_THROW(count_roots_by_circle(Polynomial(), 1), DomainError);
  EXPECT_THROW(roots_inside_circle(Polynomial(), 1), DomainError);
  EXPECT_THROW(count_roots_by_circle(linear(1), 0), DomainError);
  EXPECT_THROW(roots_inside_circle(linear(1), -1), DomainError);
}

TEST(SchurCohn, RandomProductsOfKnownRoots) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const Rational radius(1 + int(random() % 5), 1 + int(random() % 5));
    Polynomial a = Polynomial::constant(Rational(int(random() % 5) - 7, 4));
    int inside = 0, on = 0, outside = 0;
    for (unsigned i = 0; i < 1 + random() % 5; ++i) {
      // Few moduli, closed under x -> 1/x, so that reciprocal pairs and multiple roots are frequent.
      const Rational moduli[] = {0, Rational(1, 3), Rational(1, 2), 1, 1, 2, 3};
      const Rational cosines[] = {Rational(3, 5), Rational(-1, 3), 0};
      const Rational modulus = moduli[random() % 7];
      const bool pair = random() % 2 == 0;
      const Rational signed_modulus = random() % 2 == 0 ? modulus : -modulus;
      a *= pair ? conjugate_pair(radius * modulus, cosines[random() % 3]) : linear(radius * signed_modulus);
      (modulus < 1 ? inside : modulus == 1 ? on : outside) += pair ? 2 : 1;
    }
    expect_count(a, radius, inside, on, outside);
  }
}

TEST(SchurCohn, CountAndRecursionAgreeOnRandomPolynomials) {
  std::mt19937 random(6);
  int inside_all = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::vector<Rational> coefficients;
    const int degree = 1 + int(random() % 8);
    for (int i = 0; i < degree; ++i) coefficients.emplace_back(int(random() % 7) - 3);
    coefficients.emplace_back(1 + int(random() % 9));
    const Polynomial a(coefficients);
    const Rational radius(1 + int(random() % 8), 4);
    const CircleCount count = count_roots_by_circle(a, radius);
    EXPECT_EQ(count.inside + count.on + count.outside, degree);
    EXPECT_EQ(count.inside == degree, roots_inside_circle(a, radius));
    inside_all += count.inside == degree ? 1 : 0;
    // z -> 1/z swaps inside and outside; z -> -z keeps them.
    if (a(0) != 0) {
      const CircleCount swapped = count_roots_by_circle(reversed(a), 1 / radius);
      EXPECT_EQ(swapped.inside, count.outside);
      EXPECT_EQ(swapped.on, count.on);
    }
    const CircleCount mirrored = count_roots_by_circle(compose(a, Polynomial({0, -1})), radius);
    EXPECT_EQ(mirrored.inside, count.inside);
    EXPECT_EQ(mirrored.on, count.on);
  }
  EXPECT_GT(inside_all, 100);
  EXPECT_LT(inside_all, 1400);
}

TEST(SchurCohn, RandomPalindromes) {
  // Self-reciprocal polynomials of both signs: as many roots inside as outside.
  std::mt19937 random(7);
  int off_circle = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int degree = 2 + int(random() % 9);
    const int sign = random() % 2 == 0 ? 1 : -1;
    std::vector<Rational> c(std::size_t(degree) + 1);
    for (int i = 0; 2 * i < degree; ++i) {
      c[std::size_t(i)] = int(random() % 11) - 5 + (i == 0 ? 6 : 0);
      c[std::size_t(degree - i)] = sign * c[std::size_t(i)];
    }
    if (degree % 2 == 0 && sign > 0) c[std::size_t(degree / 2)] = int(random() % 21) - 10;
    const CircleCount count = count_roots_by_circle(Polynomial(c), 1);
    EXPECT_EQ(count.inside, count.outside);
    EXPECT_EQ(count.inside + count.on + count.outside, degree);
    EXPECT_FALSE(roots_inside_circle(Polynomial(c), 1));
    // Just inside and just outside of the circle the regular form decides alone.
    const Rational near(1, 1000000);
    EXPECT_EQ(count_roots_by_circle(Polynomial(c), 1 - near).inside, count.inside);
    EXPECT_EQ(count_roots_by_circle(Polynomial(c), 1 + near).outside, count.outside);
    off_circle += count.inside > 0 ? 1 : 0;
  }
  EXPECT_GT(off_circle, 50);
}

}  // namespace
}  // namespace limes
