#include "proofs/spectral_radius/norm_json_impl.hpp"

#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/finite_sections.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/polytope.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

using namespace limes;

namespace {

checker::RationalMatrix for_checker(const RationalMatrix& a) {
  checker::RationalMatrix result(std::size_t(a.rows()), std::size_t(a.columns()));
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.columns(); ++j) result.at(std::size_t(i), std::size_t(j)) = mpq_class(to_string(a(i, j)));
  }
  return result;
}

/// What the checker says of a norm; "" when it accepts.
std::string verdict(const MatrixFamily& family, const Rational& bound, const nlohmann::ordered_json& norm) {
  std::vector<checker::RationalMatrix> matrices;
  for (const RationalMatrix& b : family) matrices.push_back(for_checker(b));
  checker::Budget budget;
  try {
    checker::prove_polytope_norm(matrices, mpq_class(to_string(bound)), checker::parse_json(norm.dump()), budget);
  } catch (const checker::Rejected& rejected) {
    return rejected.step + ": " + rejected.reason;
  }
  return "";
}

MatrixFamily sections(const std::string& scheme, const std::vector<Rational>& point, int order) {
  const Mask mask = limes::at(Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(scheme).mask, point);
  const FiniteSections b(*difference_symbol(mask, order), mask.arity);
  MatrixFamily result;
  for (int e = 0; e < mask.arity; ++e) result.push_back(b.product({e}, {}));
  return result;
}

}  // namespace

TEST(NormJson, TheCheckerAcceptsNormsOfDifferenceSchemes) {
  // Radii from the search, raised by 10^-6.
  const auto accepts = [](const MatrixFamily& family, const Rational& bound) {
    const auto norm = find_polytope(family, bound, {}, {});
    ASSERT_TRUE(norm);
    EXPECT_EQ(verdict(family, bound, norm_to_json(*norm)), "");
    EXPECT_NE(verdict(family, bound * Rational(99, 100), norm_to_json(*norm)), "");
  };
  accepts(sections("deslauriers-dubuc-6", {}, 6), Rational(4500005, 1000000));
  // Not the highest order: b has further zeros at -1, and the family is block triangular.
  accepts(sections("deslauriers-dubuc-6", {}, 3), Rational(562501, 1000000));
  accepts(sections("ternary-four-point", {Rational(1, 11)}, 2), Rational(333334, 1000000));
}

TEST(NormJson, OneNormForAnInterval) {
  // C^1 of the four-point scheme for w in [1/100, 19/100]: the bound is below 1, b is affine in w.
  MatrixFamily ends = sections("four-point", {Rational(1, 100)}, 2);
  for (const RationalMatrix& b : sections("four-point", {Rational(19, 100)}, 2)) ends.push_back(b);
  const Rational bound(999, 1000);
  const auto norm = find_polytope(ends, bound, {}, {});
  ASSERT_TRUE(norm);
  EXPECT_EQ(verdict(ends, bound, norm_to_json(*norm)), "");
  // Every matrix in between too, although no certificate says so.
  for (int k = 1; k < 19; ++k) {
    MatrixFamily between = sections("four-point", {Rational(k, 100)}, 2);
    EXPECT_TRUE(find_polytope(between, bound, {}, {}));
  }
}

TEST(NormJson, VectorsThatMoveWithTheParameter) {
  // C^3 of the eight-point scheme up to 0.009362; the radius is 1 at 0.0093622..
  MatrixFamily ends = sections("eight-point", {Rational(92, 10000)}, 4);
  for (const RationalMatrix& b : sections("eight-point", {Rational(9362, 1000000)}, 4)) ends.push_back(b);
  const Rational bound(999999, 1000000);
  const auto norm = find_moving_polytope(ends, bound, {.eagerness = 0.5}, {});
  ASSERT_TRUE(norm);
  const nlohmann::ordered_json good = norm_to_json(*norm);
  const auto verdict_of = [&](const Rational& claimed, const nlohmann::ordered_json& json) -> std::string {
    std::vector<checker::RationalMatrix> matrices;
    for (const RationalMatrix& b : ends) matrices.push_back(for_checker(b));
    checker::Budget budget;
    try {
      checker::prove_moving_norm(matrices, mpq_class(to_string(claimed)), checker::parse_json(json.dump()), budget);
    } catch (const checker::Rejected& rejected) {
      return rejected.step + ": " + rejected.reason;
    }
    return "";
  };
  EXPECT_EQ(verdict_of(bound, good), "");
  EXPECT_NE(verdict_of(Rational(9999, 10000), good), "");
  const std::size_t last = norm->blocks.size() - 1;
  for (std::size_t k : {0, 1, 2}) {
    nlohmann::ordered_json bad = good;
    bad["blocks"][last]["images"][0][5][0][1][k] = "1/7";
    EXPECT_NE(verdict_of(bound, bad), "") << k;
  }
  for (std::size_t end : {0, 1}) {
    nlohmann::ordered_json bad = good;
    bad["blocks"][last]["vectors"][3][end][2] = "7";
    EXPECT_NE(verdict_of(bound, bad), "") << end;
    bad = good;
    bad["form"]["basis"][0][0] = "7";
    EXPECT_NE(verdict_of(bound, bad), "");
  }
  for (std::size_t k = 0; k < norm->blocks.size(); ++k) EXPECT_LE(exact_moving_bound(norm->blocks[k], norm->form.diagonal_block(k)), bound);
}
