// The splines of Karciauskas & Peters 2013, section 2: smoothness at the knots, interpolation and polynomial
// reproduction.
#include "algebra/error.hpp"
#include "schemes/nonuniform/bezier_maps.hpp"
#include "tests/schemes/nonuniform/rules.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

using namespace test;

const std::vector<std::pair<std::string, std::string>> splines{
    {"cr1", "hermite(1, f(2,0), f(2,1))"},
    {"cr1w", "tension(w, cr1)"},
    {"cr12", "split(1, cr1w)"},
    {"cr2", "join(2, degree(4, cr1w))"},
    {"cr23", "split(2, cr2, 2)"},
    {"cr2_three", "split(2, cr2)"},
    {"cu24", "join(2, degree(4, f(3,0)))"},
    {"cu23", "split(2, cu24, 2)"},
    {"cr3", "join(3, degree(6, cr2))"},
    {"cr34", "split(3, cr3)"},
    {"quintic", "hermite(2, f(4,0), f(4,1))"},
    {"quintic_split", "split(2, quintic)"},
    {"quintic_tense", "tension(w, quintic)"},
    {"cr1_direct", "join(3, degree(6, cr1w))"},
};

const InsertionRule& rule() {
  static const InsertionRule made = make_rule(10, splines, "at(f(1,0),1/2)", {"w"});
  return made;
}

template <class K>
K scaled(const Rational& factor, const K& x) {
  if constexpr (std::is_same_v<K, Rational>)
    return factor * x;
  else
    return RationalFunction::constant(x.variables(), factor) * x;
}

/// The derivative of order k of a piece at its left or right end, with respect to u of the whole interval, as weights
/// of the points.
template <class K>
std::vector<K> end_derivative(const BezierSegment<K>& s, int piece, bool right, int k) {
  std::vector<K> result(s.coefficients[0].size(), scaled(0, s.coefficients[0][0]));
  if (k > s.degree) return result;
  Rational scale = power(Rational(s.pieces), k);
  for (int j = 0; j < k; ++j) scale *= s.degree - j;
  for (int j = 0; j <= k; ++j) {
    const auto& c = s.coefficient(piece, right ? s.degree - k + j : j);
    for (std::size_t p = 0; p < result.size(); ++p)
      result[p] += scaled(scale * binomial(k, j) * ((k - j) % 2 == 0 ? 1 : -1), c[p]);
  }
  return result;
}

/// The number of derivatives in which two ends agree, -1 for none, at most 8: D^k left / h_left^k = D^k right /
/// h_right^k.
template <class K>
int smoothness(const BezierSegment<K>& a, int piece_a, const K& length_a, const BezierSegment<K>& b, int piece_b,
               const K& length_b) {
  K factor_a = length_a / length_a, factor_b = factor_a;
  for (int k = 0; k <= 8; ++k) {
    const auto left = end_derivative(a, piece_a, true, k), right = end_derivative(b, piece_b, false, k);
    for (std::size_t p = 0; p < left.size(); ++p) {
      if (!(left[p] * factor_b == right[p] * factor_a)) return k - 1;
    }
    factor_a *= length_a;
    factor_b *= length_b;
  }
  return 8;
}

struct Claimed {
  const char* name;
  int at_knots;
  int inside;  // between its pieces
};

const Claimed claimed[] = {{"cr1", 1, 0},          {"cr1w", 1, 0},      {"cr12", 1, 1},    {"cr2", 2, 0},
                           {"cr23", 2, 2},         {"cr2_three", 2, 2}, {"cu24", 2, 0},    {"cu23", 2, 2},
                           {"cr3", 3, 0},          {"cr34", 3, 3},      {"quintic", 2, 0}, {"quintic_split", 2, 2},
                           {"quintic_tense", 2, 0}};

TEST(Splines, SmoothnessForAllRatios) {
  const auto knots = KnotRatios::independent(10, 9, 1).knots(9);
  for (const Claimed& c : claimed) {
    const auto before = rule().segment(c.name, knots, -1), here = rule().segment(c.name, knots);
    EXPECT_EQ(smoothness(before, before.pieces - 1, knots[4] - knots[3], here, 0, knots[5] - knots[4]), c.at_knots)
        << c.name;
    const RationalFunction one = RationalFunction::constant(9, 1);
    for (int k = 0; k + 1 < here.pieces; ++k)
      EXPECT_EQ(smoothness(here, k, one, here, k + 1, one), c.inside) << c.name << " piece " << k;
    // Interpolation: p_i at u = 0, p_{i+1} at u = 1.
    for (std::size_t p = 0; p < 10; ++p) {
      EXPECT_EQ(here.coefficients.front()[p], RationalFunction::constant(9, p == 4)) << c.name;
      EXPECT_EQ(here.coefficients.back()[p], RationalFunction::constant(9, p == 5)) << c.name;
    }
  }
}

TEST(Splines, SmoothnessAtRationalKnots) {
  Generator random(11);
  const std::vector<Rational> w{Rational(23) / 20};
  for (const Claimed& c : claimed) {
    const auto knots = random_knots(random, 10);
    const auto before = rule().segment(c.name, knots, w, -1), here = rule().segment(c.name, knots, w);
    EXPECT_EQ(
        smoothness(before, before.pieces - 1, Rational(knots[4] - knots[3]), here, 0, Rational(knots[5] - knots[4])),
        c.at_knots)
        << c.name;
  }
}

// "C^3 if they join C^1": eq. (5) alone, from the C^1 spline.
TEST(Splines, JoinOfOrder3NeedsC1Only) {
  const auto knots = KnotRatios::independent(10, 9, 1).knots(9);
  const auto before = rule().segment("cr1_direct", knots, -1), here = rule().segment("cr1_direct", knots);
  EXPECT_EQ(smoothness(before, 0, knots[4] - knots[3], here, 0, knots[5] - knots[4]), 3);
}

TEST(Splines, JoinOfOrder1IsSmoothButMovesTheEnds) {
  const InsertionRule linear = make_rule(8, {{"quadratic", "join(1, degree(2, f(1,0)))"}}, "at(quadratic, 1/2)");
  const auto knots = KnotRatios::independent(8, 6, 0).knots(6);
  const auto before = linear.segment("quadratic", knots, -1), here = linear.segment("quadratic", knots);
  EXPECT_EQ(smoothness(before, 0, knots[3] - knots[2], here, 0, knots[4] - knots[3]), 1);
  EXPECT_FALSE(here.coefficients.front()[3] == RationalFunction::constant(6, 1));
}

TEST(Splines, ReproducePolynomialsUpToTheirDegreeAndNoFurther) {
  const struct {
    const char* name;
    Rational w;
    int degree;
    // Scaled tangents lose the linear functions, but the join to C^2 brings them back.
  } cases[] = {{"cr1", 1, 2}, {"cr1w", 1, 2}, {"cr1w", 2, 0},   {"cr12", 1, 2}, {"cr12", 2, 0},
               {"cr2", 1, 2}, {"cr2", 2, 1},  {"cr23", 1, 2},   {"cu24", 1, 3}, {"cu23", 1, 3},
               {"cr3", 1, 2}, {"cr34", 1, 2}, {"quintic", 1, 4}};
  Generator random(12);
  for (const auto& c : cases) {
    const auto knots = random_knots(random, 10);
    const std::vector<Rational> w{c.w};
    const auto s = rule().segment(c.name, knots, w);
    // The difference to t^d at more than enough points of each piece.
    const auto reproduces = [&](int d) {
      for (int piece = 0; piece < s.pieces; ++piece) {
        for (int k = 0; k <= std::max(s.degree, d); ++k) {
          const Rational v = Rational(k) / (s.degree + d), u = (piece + v) / s.pieces;
          const auto values = bernstein_values(s.degree, v);
          Rational value = 0;
          for (int j = 0; j <= s.degree; ++j)
            value += values[std::size_t(j)] * combination(s.coefficient(piece, j), powers(knots, d));
          if (value != power(Rational(knots[4] * (1 - u) + knots[5] * u), d)) return false;
        }
      }
      return true;
    };
    for (int d = 1; d <= c.degree; ++d) EXPECT_TRUE(reproduces(d)) << c.name << " degree " << d;
    EXPECT_FALSE(reproduces(c.degree + 1)) << c.name;
  }
}

// Karciauskas & Peters 2013, eq. (10): the common point of the two cubics of a quartic.
TEST(Splines, TwoCubicsOfAQuarticMeetAtM4) {
  const std::vector<std::pair<std::string, std::string>> let{{"s", "join(2, degree(4, f(3,0)))"}};
  EXPECT_EQ(make_rule(6, let, "at(split(2, s, 2), 1/2)").symbolic_stencil(),
            make_rule(6, let, "dot([1/12, 1/6, 1/2, 1/6, 1/12], s)").symbolic_stencil());
}

// Section 2.2: the two quadratics of a cubic meet at its value at 1/2.
TEST(Splines, TwoQuadraticsOfACubicMeetAtItsMiddle) {
  EXPECT_EQ(make_rule(4, {}, "at(split(1, f(3,0)), 1/2)").symbolic_stencil(),
            make_rule(4, {}, "at(f(3,0), 1/2)").symbolic_stencil());
}

// Section 4.3: m5 is the value at 1/2 of a degree-raised cubic.
TEST(Splines, M5OfADegreeRaisedCubicIsItsMiddle) {
  EXPECT_EQ(make_rule(4, {}, "dot([1/12, 0, 5/12, 5/12, 0, 1/12], degree(5, f(3,0)))").symbolic_stencil(),
            make_rule(4, {}, "at(f(3,0), 1/2)").symbolic_stencil());
}

TEST(Splines, BezierFormAndLagrangeFormAgree) {
  for (const char* u : {"0", "1/3", "1", "-2"}) {
    for (const char* f : {"f(0,1)", "f(1,-1)", "f(2,0)", "f(3,1)", "f(4,0)"}) {
      const std::string first = std::string("at(") + f + "," + u + ")",
                        second = std::string("at(1*") + f + "," + u + ")";
      EXPECT_EQ(make_rule(8, {}, first).symbolic_stencil(), make_rule(8, {}, second).symbolic_stencil()) << first;
    }
  }
}

TEST(Splines, SegmentsBeyondTheKnotsAreRefused) {
  const auto knots = KnotRatios::uniform(10, 1).knots(1);
  EXPECT_THROW(rule().segment("cr3", knots, 2), DomainError);
  EXPECT_THROW(rule().segment("cr4", knots), DomainError);
  EXPECT_NO_THROW(rule().segment("cr1", knots, 3));
}

TEST(BezierMaps, SplitKeepsTheJetsAndPiecesSuffice) {
  EXPECT_EQ(split_in_pieces(4, 2, 2).rows(), 2 * 4);
  EXPECT_EQ(split_in_pieces(5, 2, 2).rows(), 0);
  EXPECT_EQ(split_in_pieces(6, 3, 3).rows(), 0);
  EXPECT_EQ(split_in_pieces(6, 3, 4).rows(), 4 * 5);
  for (int r = 1; r <= 5; ++r) {
    // A polynomial of degree r+1 stays what it is: degree raised in the jets, cut into pieces.
    const RationalMatrix map = split_in_pieces(2 * r + 1, r, r + 1) * degree_raising(r + 1, 2 * r + 1);
    for (int j = 0; j <= r + 1; ++j) {
      const Rational middle = Rational(1) / 2;
      Rational value = 0;
      const int piece = (r + 1) / 2;
      const auto values = bernstein_values(r + 1, middle * (r + 1) - piece);
      for (int i = 0; i <= r + 1; ++i) value += values[std::size_t(i)] * map(piece * (r + 2) + i, j);
      EXPECT_EQ(value, bernstein_values(r + 1, middle)[std::size_t(j)]) << r << " " << j;
    }
  }
}

}  // namespace
}  // namespace limes
