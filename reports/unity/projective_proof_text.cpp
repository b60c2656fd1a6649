#include "reports/unity/projective_proof_text.hpp"

#include "algebra/error.hpp"
#include "reports/proof/formulas.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

constexpr int digits = 9;

std::string near(const Rational& x) { return scientific_latex(to_decimal(x, digits, Rounding::nearest)); }
/// The first digits, for a text that goes on with dots.
std::string truncated(const Rational& x) { return to_decimal(x, digits, x < 0 ? Rounding::up : Rounding::down); }

/// "A_0^2A_1": the product in the order in which it is written, the letter applied first on the right.
std::string product_latex(const std::vector<int>& word) {
  std::string text;
  for (std::size_t k = word.size(); k > 0;) {
    const int letter = word[k - 1];
    std::size_t count = 0;
    while (k > 0 && word[k - 1] == letter) --k, ++count;
    text += fmt::format("A_{}", letter) + (count > 1 ? fmt::format("^{{{}}}", count) : "");
  }
  return text.empty() ? "I" : text;
}

std::vector<Block> zero_limits(const Scheme& scheme, const ZeroLimitProof& proof) {
  Rational sums[2];
  const std::vector<Rational> mask = scheme.mask.symbol.rational_coefficients();
  for (std::size_t k = 0; k < mask.size(); ++k) sums[(static_cast<unsigned>(scheme.mask.symbol.lowest()) + k) % 2] += mask[k];
  std::string text = fmt::format("By [Theorem P0](#theorem-P0): $\\sum_ia_{{2i}}-1={}$ and $\\sum_ia_{{2i+1}}-1={}$.", near(sums[0] - 1), near(sums[1] - 1));
  if (proof.word) {
    const RationalMatrix product = word_product(mask, *proof.word);
    const Rational value = characteristic_polynomial(product)(1);
    text += fmt::format(" The product ${}$ has a real eigenvalue of at least $1$, since $\\det(1-{})={}\\le0$.", product_latex(*proof.word), product_latex(*proof.word), near(value));
  }
  return {Paragraph{rich(text)}};
}

/// The box as a table in columns of i, l_i, u_i.
DataTable cone_table(const WeightCone& cone) {
  DataTable table{.caption = {}, .columns = "r", .header = {mathematics("i")}, .rows = {{mathematics("l_i")}, {mathematics("u_i")}}};
  for (std::size_t k = 0; k < cone.lower.size(); ++k) {
    table.columns += "r";
    table.header.push_back(mathematics(fmt::format("{}", k)));
    table.rows[0].push_back(mathematics(to_decimal(cone.lower[k], 4, Rounding::nearest)));
    table.rows[1].push_back(mathematics(to_decimal(cone.upper[k], 4, Rounding::nearest)));
  }
  return table;
}

std::vector<Block> cone_proof(const ProjectiveContraction& contraction, std::set<std::string>& shown) {
  std::vector<Block> blocks;
  const WeightCone& cone = contraction.cone;
  std::string key = fmt::format("cone {}", contraction.level);
  for (const auto* side : {&cone.lower, &cone.upper}) {
    for (const Rational& x : *side) key += " " + to_string(x);
  }
  if (!shown.insert(key).second) return {Paragraph{rich("The cone above satisfies the conditions of [Theorem P1](#theorem-P1), with the same $L$, $q$ and $B$.")}};
  blocks.push_back(Paragraph{rich(fmt::format("By [Theorem P1](#theorem-P1) with $L={}$ and the cone over the box $l\\le z\\le u$,{}", contraction.level,
                                              cone.lower.size() <= 10 ? " rounded here to" : " whose numbers are in the certificate."))});
  if (cone.lower.size() <= 10) blocks.push_back(cone_table(cone));
  blocks.push_back(Paragraph{rich(fmt::format("Every $L$ steps multiply the oscillation of the points of a window by at most $q={}$; the rows of the matrices that map the points have absolute sums of at most $B={}$.",
                                              to_decimal(contraction.factor, 6, Rounding::up), to_decimal(contraction.norm, 6, Rounding::up)))});
  return blocks;
}

std::vector<Block> roughness_proof(const ProjectiveRoughness& roughness, std::set<std::string>& shown) {
  const double length = static_cast<double>(roughness.word.size());
  const double ratio = std::pow(std::abs(approx_double(roughness.second.value / roughness.dominant.value)), 1 / length);
  std::vector<Block> blocks = cone_proof(roughness.contraction, shown);
  blocks.push_back(Paragraph{rich(fmt::format(
      "By [Theorem P2](#theorem-P2) the word $W$ with $A_W={}$ shows that the limits are not $C^1$: it has the eigenvalues $\\lambda_1={}\\ldots$, with an eigenvector inside of the cone, and "
      "$\\lambda_2={}\\ldots$, hence $|\\lambda_2/\\lambda_1|^{{1/{}}}={:.6f}\\ldots>\\frac12$. The limit in the direction of $\\lambda_2$ does not vanish in the window $A_U={}$. The eigenpairs are enclosed by the "
      "Newton--Kantorovich test.",
      product_latex(roughness.word), truncated(roughness.dominant.value), truncated(roughness.second.value), roughness.word.size(), std::floor(ratio * 1e6) / 1e6,
      product_latex(roughness.window)))});
  return blocks;
}

}  // namespace

std::vector<Block> projective_proof_text(const Scheme& scheme, const Certificate& certificate, std::set<std::string>& shown) {
  if (const auto* zero = std::get_if<ZeroLimitProof>(&certificate.proof)) return zero_limits(scheme, *zero);
  const auto* cone = std::get_if<ConeProof>(&certificate.proof);
  if (!cone) throw InternalError("projective_proof_text: a proof of another theorem");
  return cone->roughness ? roughness_proof(*cone->roughness, shown) : cone_proof(cone->contraction, shown);
}

}  // namespace limes
