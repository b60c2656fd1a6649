#include "algebra/matrix/exact_solve.hpp"
#include "algebra/number/read_rational.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/prove.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace limes {
namespace {

Scheme scheme_with(const std::vector<std::string>& mask) {
  Scheme scheme;
  scheme.name = "test";
  std::vector<Rational> coefficients;
  for (const std::string& a : mask) coefficients.push_back(read_rational(a));
  scheme.mask = {2, LaurentPolynomial::from_rationals(0, coefficients)};
  return scheme;
}

Verdict decide(const std::vector<std::string>& mask, const std::string& claim) {
  const Verdict verdict = prove(scheme_with(mask), read_statement(claim), {}, {});
  if (verdict.certificate) {
    std::string name = claim;
    std::replace(name.begin(), name.end(), ' ', '-');
    std::filesystem::create_directories(LIMES_BINARY_DIR "/certificates");
    std::ofstream(std::string(LIMES_BINARY_DIR "/certificates/unity-") + std::to_string(mask.size()) + "-" + name + ".json") << verdict.certificate_json;
  }
  return verdict;
}

const std::vector<std::string> polynomial{"0.353395", "0.397012", "0.436764", "0.418329", "0.226328", "0.170216"};
const std::vector<std::string> symmetric{"0.0232679", "0.339142", "0.638865", "0.638865", "0.339142", "0.0232679"};
const std::vector<std::string> spline{"1/8", "1/2", "3/4", "1/2", "1/8"};
const std::vector<std::string> invisible{"7/20", "5/20", "-4/20", "12/20", "12/20", "-4/20", "5/20", "7/20"};

TEST(ProjectiveProof, MasksOfTheTables) {
  for (const auto& mask : {polynomial, symmetric}) {
    EXPECT_EQ(decide(mask, "only zero limits").outcome, Outcome::certified);
    EXPECT_EQ(decide(mask, "not C0").certificate->theorem, Theorem::p0);
    EXPECT_EQ(decide(mask, "C1").outcome, Outcome::refuted);
    EXPECT_EQ(decide(mask, "projective C0").outcome, Outcome::certified);
    EXPECT_EQ(decide(mask, "not projective C0").outcome, Outcome::refuted);
    EXPECT_EQ(decide(mask, "not projective C1").outcome, Outcome::certified);
    EXPECT_EQ(decide(mask, "projective C2").outcome, Outcome::refuted);
  }
}

TEST(ProjectiveProof, ScalingTheMaskChangesNothing) {
  std::vector<std::string> scaled;
  for (const std::string& a : polynomial) scaled.push_back(to_string(Rational(3 * read_rational(a))));
  EXPECT_EQ(decide(scaled, "projective C0").outcome, Outcome::certified);
  EXPECT_EQ(decide(scaled, "not projective C1").outcome, Outcome::certified);
}

TEST(ProjectiveProof, SmoothSchemesAreNotRefuted) {
  EXPECT_EQ(decide(spline, "projective C0").outcome, Outcome::certified);
  EXPECT_EQ(decide(spline, "not projective C1").outcome, Outcome::undecided);
  EXPECT_EQ(decide(spline, "only zero limits").outcome, Outcome::undecided);
  EXPECT_EQ(decide(spline, "projective C1").outcome, Outcome::undecided);
}

/// C^1 although both sections have an eigenvalue of modulus 4/5: its eigenvector is invisible. (U1 cannot prove C^1: the shifts are not stable.)
TEST(ProjectiveProof, InvisibleEigenvalues) {
  EXPECT_EQ(decide(invisible, "not projective C1").outcome, Outcome::undecided);

  std::vector<Rational> mask;
  for (const std::string& a : invisible) mask.push_back(read_rational(a));
  const auto contraction = find_projective_contraction(mask, 1, 8, {});
  ASSERT_TRUE(contraction);
  const RationalMatrix section = mask_section(mask, 0);
  const int n = section.rows();
  std::optional<Rational> value;
  for (const char* candidate : {"4/5", "-4/5"}) {
    if (characteristic_polynomial(section)(read_rational(candidate)) == 0) value = read_rational(candidate);
  }
  ASSERT_TRUE(value);
  // The eigenvector with one component 1, from the equations but one.
  std::optional<ApproxEigenpair> second;
  for (int fixed = 0; fixed < n && !second; ++fixed) {
    for (int dropped = 0; dropped < n && !second; ++dropped) {
      RationalMatrix a(n - 1, n - 1), b(n - 1, 1);
      for (int i = 0, r = 0; i < n; ++i) {
        if (i == dropped) continue;
        for (int j = 0, c = 0; j < n; ++j) {
          const Rational entry = section(i, j) - (i == j ? *value : Rational(0));
          if (j == fixed) b(r, 0) = -entry;
          else a(r, c++) = entry;
        }
        ++r;
      }
      const auto solution = exact_solve(a, b);
      if (!solution) continue;
      second = ApproxEigenpair{*value, {}};
      for (int j = 0, c = 0; j < n; ++j) second->vector.push_back(j == fixed ? Rational(1) : (*solution)(c++, 0));
    }
  }
  ASSERT_TRUE(second);
  const std::vector<Rational> image = section * second->vector;
  for (int i = 0; i < n; ++i) ASSERT_EQ(image[i], *value * second->vector[i]);

  const Scheme scheme = scheme_with(invisible);
  for (unsigned bits = 0; bits < 8; ++bits) {
    ProjectiveRoughness rough{*contraction, {0}, {1, std::vector<Rational>(n, Rational(1))}, *second, {}};
    for (int k = 0; k < 6 * contraction->level; ++k) rough.window.push_back(static_cast<int>(bits >> (k % 3) & 1));
    Certificate certificate{.scheme = "invisible", .parameters = {}, .definition = scheme.mask, .claim = read_statement("not projective C1"),
                            .verdict = Outcome::certified, .theorem = Theorem::p2, .proof = ConeProof{*contraction, rough}};
    const checker::Result result = checker::check(to_json(certificate));
    EXPECT_FALSE(result.valid);
    EXPECT_EQ(result.step, "visible") << result.reason;
  }
}

TEST(ProjectiveProof, OtherMasksAreUndecided) {
  EXPECT_EQ(decide({"1", "1"}, "projective C0").outcome, Outcome::undecided);
  EXPECT_EQ(decide({"1", "-1", "1", "1"}, "projective C0").outcome, Outcome::undecided);
  EXPECT_EQ(decide({"1"}, "only zero limits").outcome, Outcome::undecided);
}

TEST(ProjectiveProof, MasksWithParametersAndNonuniformSchemesAreUndecided) {
  Scheme scheme = read_scheme("name = 'w'\nkind = 'uniform'\n[parameters]\nw = ['1', '2']\n[uniform]\nmask = ['1', '2', '1']\n", "w.toml");
  for (const std::string claim_text : {"projective C0", "only zero limits", "not C0", "not projective C1"}) {
    Claim claim = read_statement(claim_text);
    claim.region = {Interval::point(1)};
    EXPECT_EQ(prove(scheme, claim, {}, {}).outcome, Outcome::undecided) << claim_text;
  }
  scheme = read_scheme("name = 'n'\nkind = 'nonuniform'\n[nonuniform]\npoints = 2\n[nonuniform.rule]\nnew = 'at(f(1,0),1/2)'\n", "n.toml");
  EXPECT_EQ(prove(scheme, read_statement("projective C0"), {}, {}).outcome, Outcome::undecided);
}

TEST(Claim, StatementsAreReadAsTheyAreWritten) {
  for (const std::string text : {"C2", "not C0", "projective C0", "not projective C1", "only zero limits"}) EXPECT_EQ(statement(read_statement(text)), text);
}

}  // namespace
}  // namespace limes
