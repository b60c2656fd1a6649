#include "analysis/nonuniform/root_dominance.hpp"

#include "algebra/expression/expression.hpp"
#include "algebra/polynomial/schur_cohn.hpp"
#include "analysis/nonuniform/spectrum_dominance.hpp"
#include "tests/analysis/nonuniform/rules.hpp"

#include <gtest/gtest.h>

#include <random>

namespace limes {
namespace {

using enum DominanceMethod;
const std::vector<DominanceMethod> all_methods{rouche, boundary, circle, sign_separation};

LambdaPolynomial polynomial(const std::string& text, const VariableNames& names) {
  VariableNames all{"lambda"};
  all.insert(all.end(), names.begin(), names.end());
  return primitive_part(LambdaPolynomial::from_expanded(read_rational_function(text, all).numerator())).part;
}

Box box(const std::vector<std::string>& intervals) {
  Box result;
  for (const auto& text : intervals) result.push_back(read_interval(text));
  return result;
}

RootDominance prove(const LambdaPolynomial& r, const Rational& rho, const Box& region, DominanceMethod method,
                    int boxes = 200) {
  RootDominanceOptions options;
  options.methods = {method};
  options.max_boxes = boxes;
  return prove_root_dominance(r, rho, region, options);
}

Rational volume(const Box& region) {
  Rational result = 1;
  for (const auto& interval : region) result *= interval.is_point() ? Rational(1) : interval.width();
  return result;
}

// A point of a / 2^12-grid in the box, off its faces.
std::vector<Rational> random_point(std::mt19937& random, const Box& region) {
  std::vector<Rational> point;
  for (const auto& interval : region) {
    point.push_back(interval.lower + interval.width() * Rational(static_cast<int>(1 + random() % 4095)) / 4096);
  }
  return point;
}

TEST(RootDominance, NeverClaimsMoreThanIsTrueAtRandomPoints) {
  std::mt19937 random(20130202);
  const Box region = box({"[0, 1]", "(0, 1]"});
  const Rational rho = Rational(1) / 2;
  std::map<DominanceMethod, int> proved, refuted;
  for (int trial = 0; trial < 160; ++trial) {
    const int p = 1 + static_cast<int>(random() % 5);
    std::vector<MultivariatePolynomial> d;
    for (int s = 0; s <= p; ++s) {
      std::vector<MultivariatePolynomial::Term> terms;
      for (int i = 0; i <= 1; ++i) {
        for (int j = 0; j <= 2; ++j) terms.push_back({{i, j}, Rational(static_cast<int>(random() % 21)) - 10});
      }
      // Roots of modulus about 1/2 or a little less, a leading coefficient without zero.
      d.push_back(power(Rational(2), s) / (trial % 3 == 0 ? 1 : 3) * MultivariatePolynomial::from_terms(2, terms));
      if (s == p) d.back() += MultivariatePolynomial::constant(2, power(Rational(2), p) * 16);
    }
    const LambdaPolynomial r(2, d);
    if (r.degree() < 1) continue;
    for (const auto method : all_methods) {
      const RootDominance found = prove(r, rho, region, method, 30);
      Rational tiled = 0;
      for (const auto& leaf : found.leaves) tiled += volume(leaf.box);
      if (found.counterexample) {
        ++refuted[method];
        const Polynomial at = r.at(*found.counterexample);
        const CircleCount count = count_roots_by_circle(at, rho);
        EXPECT_TRUE(at.degree() < p || count.on + count.outside > 0);
      }
      if (!found.proved) continue;
      ++proved[method];
      EXPECT_EQ(tiled, volume(region));
      for (int k = 0; k < 12; ++k) {
        const Polynomial at = r.at(random_point(random, region));
        ASSERT_EQ(at.degree(), p);
        ASSERT_EQ(count_roots_by_circle(at, rho).inside, p) << to_string(method) << " trial " << trial;
      }
      for (const Rational& x : {Rational(0), Rational(1)})
        ASSERT_TRUE(roots_inside_circle(r.at(std::vector<Rational>{x, 1}), rho));
    }
  }
  for (const auto method : all_methods) {
    EXPECT_GE(proved[method], 5) << to_string(method);
    EXPECT_GE(refuted[method], 10) << to_string(method);
  }
  // Complete on closed boxes and far from the circle.
  EXPECT_GE(proved[circle], proved[rouche]);
}

TEST(RootDominance, ThePowerOfRhoBelongsToTheLeadingCoefficient) {
  // sum_{s<p} |d_s| rho^s = 3/4 < d_p, but not < d_p rho^p.
  const LambdaPolynomial r = polynomial("lambda - 3/4", {"gamma"});
  for (const auto method : all_methods) {
    EXPECT_FALSE(make_rouche_test(r, Rational(1) / 2)->prove(box({"(0,1]"}), {1}));
    EXPECT_FALSE(prove(r, Rational(1) / 2, box({"(0, 1]"}), method).proved) << to_string(method);
    EXPECT_TRUE(prove(r, Rational(7) / 8, box({"(0, 1]"}), method).proved) << to_string(method);
  }
}

TEST(RootDominance, ARootOnTheCircleIsNotInside) {
  for (const std::string text :
       {"lambda-1", "lambda+1", "lambda^2+1", "lambda^3+gamma*lambda-1-gamma", "5*lambda^2-6*lambda+5"}) {
    for (const auto method : all_methods) {
      EXPECT_FALSE(prove(polynomial(text, {"gamma"}), 1, box({"(0, 1]"}), method).proved)
          << text << ' ' << to_string(method);
    }
  }
}

TEST(RootDominance, OnlyExcludedFacesMayTouchTheCircle) {
  // The root 1 - gamma reaches the circle at gamma = 0.
  const LambdaPolynomial r = polynomial("lambda-1+gamma", {"gamma"});
  EXPECT_TRUE(prove(r, 1, box({"(0, 1]"}), boundary).proved);
  EXPECT_TRUE(prove(r, 1, box({"(0, 1]"}), sign_separation).proved);
  EXPECT_FALSE(prove(r, 1, box({"(0, 1]"}), circle).proved);
  EXPECT_FALSE(prove(r, 1, box({"(0, 1]"}), rouche).proved);
  for (const auto method : all_methods) EXPECT_FALSE(prove(r, 1, box({"[0, 1]"}), method).proved) << to_string(method);
  // The same with a pair of complex roots, which only D sees.
  const LambdaPolynomial pair = polynomial("lambda^2-lambda+1-gamma/2", {"gamma"});
  EXPECT_TRUE(prove(pair, 1, box({"(0, 1]"}), boundary).proved);
  EXPECT_FALSE(prove(pair, 1, box({"[0, 1]"}), boundary).proved);
  // A pole of the root on a face: the leading coefficient vanishes there.
  EXPECT_FALSE(prove_root_dominance(polynomial("gamma*lambda-1/2", {"gamma"}), 1, box({"(0, 1]"})).proved);
}

TEST(RootDominance, ABoxBeyondTheTruthIsRefutedOrUndecided) {
  // Roots w and 2w: inside of 1/2 for w < 1/4 only.
  const LambdaPolynomial r = polynomial("(lambda-2*w)*(lambda-w)", {"w", "gamma"});
  for (const auto method : all_methods) {
    EXPECT_FALSE(prove(r, Rational(1) / 2, box({"[0, 1/4]", "(0, 1]"}), method).proved);
    EXPECT_FALSE(prove(r, Rational(1) / 2, box({"[0, 3/10]", "(0, 1]"}), method).proved);
  }
  EXPECT_TRUE(prove_root_dominance(r, Rational(1) / 2, box({"[0, 1/4)", "(0, 1]"})).proved);
  EXPECT_TRUE(prove_root_dominance(r, Rational(1) / 2, box({"[0, 49/200]", "(0, 1]"})).proved);
  EXPECT_TRUE(prove_root_dominance(r, Rational(1) / 2, box({"[0, 1]", "(0, 1]"})).counterexample);
}

TEST(BoundaryDeterminant, IsTheProductOverPairsOfRoots) {
  // Roots that are Gaussian rationals, closed under conjugation.
  using Complex = std::pair<Rational, Rational>;
  const auto times = [](const Complex& a, const Complex& b) {
    return Complex{a.first * b.first - a.second * b.second, a.first * b.second + a.second * b.first};
  };
  std::mt19937 random(5);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Complex> roots;
    const auto number = [&] {
      return (Rational(static_cast<int>(random() % 13)) - 6) / static_cast<int>(1 + random() % 5);
    };
    for (int k = 0; k < 1 + trial % 3; ++k) roots.push_back({number(), 0});
    for (int k = 0; k < trial % 4 / 2; ++k) {
      const Complex z{number(), number()};
      roots.push_back(z);
      roots.push_back({z.first, -z.second});
    }
    const Rational leading = 3, rho = Rational(2) / 3;
    std::vector<Complex> s{{leading, 0}};  // leading prod (z - z_i)
    Complex expected{1, 0};
    for (std::size_t i = 0; i < roots.size(); ++i) {
      std::vector<Complex> next(s.size() + 1, Complex{0, 0});
      for (std::size_t k = 0; k < s.size(); ++k) {
        const Complex product = times(s[k], roots[i]);
        next[k + 1].first += s[k].first;
        next[k + 1].second += s[k].second;
        next[k].first -= product.first;
        next[k].second -= product.second;
      }
      s = next;
      if (i > 0) expected = times(expected, {leading, 0});
      for (std::size_t j = 0; j < i; ++j) {
        const Complex product = times(roots[i], roots[j]);
        expected = times(expected, {1 - product.first, -product.second});
      }
    }
    std::vector<MultivariatePolynomial> d;
    for (std::size_t k = 0; k < s.size(); ++k) {
      ASSERT_EQ(s[k].second, 0);
      d.push_back(MultivariatePolynomial::constant(0, s[k].first * power(rho, -static_cast<int>(k))));
    }
    EXPECT_EQ(expected.second, 0);
    EXPECT_EQ(boundary_determinant(LambdaPolynomial(0, d), rho).constant_value(), expected.first);
  }
}

TEST(CirclePolynomial, IsTheSquaredModulus) {
  const LambdaPolynomial r = polynomial("3*lambda^4-gamma*lambda^3+(2+gamma^2)*lambda^2-5*lambda+7", {"gamma"});
  const Rational rho = Rational(1) / 4, gamma = Rational(2) / 3;
  const MultivariatePolynomial f = circle_polynomial(r, rho);
  const Polynomial at = r.at(std::vector<Rational>{gamma});
  for (const int sign : {1, -1}) {
    const Rational value = at(rho * sign);
    EXPECT_EQ(f(std::vector<Rational>{gamma, sign}), value * value);
  }
  // z = (3 + 4i)/5
  Rational re = 0, im = 0, x = 1, y = 0;
  for (int k = 0; k <= 4; ++k) {
    re += at.coefficient(k) * x;
    im += at.coefficient(k) * y;
    const Rational next = rho * (3 * x - 4 * y) / 5;
    y = rho * (4 * x + 3 * y) / 5;
    x = next;
  }
  EXPECT_EQ(f(std::vector<Rational>{gamma, Rational(3) / 5}), re * re + im * im);
}

SplitCharacteristicPolynomial split(const InsertionRule& rule, int smoothness) {
  return split_characteristic_polynomial(SubdivisionMatrix(rule), smoothness);
}

TEST(SpectrumDominance, SchemesOfKarciauskasAndPeters2013) {
  EXPECT_TRUE(prove_spectrum_dominance(split(test::cr1(), 1), box({"(0, 19273/100000]"}), false).proved);
  EXPECT_TRUE(prove_spectrum_dominance(split(test::repeated_a1_3_1(), 2), {}, false).proved);
  EXPECT_TRUE(prove_spectrum_dominance(split(test::cr2(), 2), box({"(0, 21/500]"}), false).proved);
  EXPECT_TRUE(prove_spectrum_dominance(split(test::cu2_4(), 2), box({"1/288"}), false).proved);
  EXPECT_TRUE(prove_spectrum_dominance(split(test::a2_5_3(), 2), box({"[1/1000, 1/50]"}), false).proved);
  EXPECT_TRUE(prove_spectrum_dominance(split(test::a3_5_3_3(), 3), box({"141/10000"}), false).proved);
  EXPECT_TRUE(prove_spectrum_dominance(split(test::a3_5(), 3), box({"141/10000"}), false).proved);
}

TEST(SpectrumDominance, FailsWhereItShould) {
  EXPECT_FALSE(prove_spectrum_dominance(split(test::a1_3_1(), 1), box({"13/100"}), false).proved);
  EXPECT_FALSE(prove_spectrum_dominance(split(test::a2_5_3(), 3), box({"3/256"}), false).proved);
  // One power of 1/2 too many: missing, or left in ell.
  EXPECT_FALSE(prove_spectrum_dominance(split(test::cr1(), 2), box({"1/16"}), false).proved);
  EXPECT_FALSE(prove_spectrum_dominance(split(test::cr2(), 3), box({"1/96"}), false).proved);
  EXPECT_FALSE(prove_spectrum_dominance(split(test::rule("at(f(1,0),1/2)", {}, 4), 1), {}, false).proved);
}

TEST(SpectrumDominance, AsymmetricRulesNeedBothSides) {
  const auto factors = split(test::three_point(), 1);
  const auto found = prove_spectrum_dominance(factors, box({"[1/100, 1/50]"}), true);
  ASSERT_TRUE(found.proved) << found.reason;
  std::size_t mirrored_parts = 0;
  for (const auto& part : found.parts) mirrored_parts += part.is_mirrored;
  EXPECT_EQ(mirrored_parts, factors.ell.size() + factors.r.size());
  EXPECT_EQ(found.parts.size(), 2 * mirrored_parts);
  // Where it fails for large ratios only, the point says so.
  const auto right = split(test::rule("21/20*at(f(2,1),1/2) - 1/20*at(f(2,0),1/2)", {}, 4), 1);
  EXPECT_TRUE(prove_spectrum_dominance(right, {}, false).proved);
  const auto fails = prove_spectrum_dominance(right, {}, true);
  EXPECT_FALSE(fails.proved);
  ASSERT_TRUE(fails.counterexample.has_value());
  EXPECT_GT(fails.counterexample->back(), 1);
}

TEST(SpectrumDominance, CoefficientTestFailsInPrincipleForA35) {
  RootDominanceOptions options;
  options.methods = {rouche};
  const auto found = prove_spectrum_dominance(split(test::a3_5(), 3), box({"141/10000"}), false, options);
  EXPECT_FALSE(found.proved);
  EXPECT_NE(found.reason.find("no bisection helps"), std::string::npos) << found.reason;
}

}  // namespace
}  // namespace limes
