// Nonstationary schemes: their definition, and proofs by S1 and S2.
#include "algebra/number/read_rational.hpp"
#include "analysis/nonstationary/space_moments.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limes::report_impl {
namespace {

std::string function_latex(const ExponentialFunction& f) {
  using Wave = ExponentialFunction::Wave;
  std::string text = f.degree == 0 ? "" : f.degree == 1 ? "y" : fmt::format("y^{{{}}}", f.degree);
  if (f.wave == Wave::none) return text.empty() ? "1" : text;
  const char* wave = f.wave == Wave::cos ? "\\cos" : f.wave == Wave::sin ? "\\sin" : f.wave == Wave::cosh ? "\\cosh" : "\\sinh";
  return text + (text.empty() ? "" : "\\,") + fmt::format("{} {}\\theta y", wave, f.frequency == 1 ? "" : std::to_string(f.frequency));
}

std::string mean_latex(const MaskSequence& sequence, AngleType type) {
  return fmt::format("{}(\\theta\\,{}^{{-(k+1)}})", type == AngleType::trigonometric ? "\\cos" : "\\cosh", sequence.mask.arity);
}

}  // namespace

std::string functions_latex(const std::vector<ExponentialFunction>& functions) {
  std::vector<std::string> texts;
  for (const ExponentialFunction& f : functions) texts.push_back(function_latex(f));
  return fmt::format("\\{{{}\\}}", fmt::join(texts, ",\\,"));
}

Blocks nonstationary_definition(const Scheme& scheme) {
  const MaskSequence& sequence = *scheme.sequence;
  std::vector<std::string> means;
  for (const MaskSequence::Range& range : sequence.types) {
    means.push_back(fmt::format("$\\mu_k={}$ for {} angles ${}$", mean_latex(sequence, range.type), to_string(range.type), region_latex(scheme, {range.angles})));
  }
  Blocks blocks{paragraph(fmt::format("Step $k=0,1,\\dots$ makes from points $p_j$ the points $q_j$ below, with {}. The angle $\\theta$ belongs to an edge of the first polygon.",
                                      fmt::join(means, ", and ")))};
  blocks.push_back(refinement_rules(sequence.mask, {"mu_k"}));
  if (!sequence.first_levels.empty()) blocks.push_back(paragraph(fmt::format("The masks of the first ${}$ steps are others, given in the scheme's file.", sequence.first_levels.size())));
  if (!sequence.interpolated.empty()) {
    blocks.push_back(paragraph(fmt::format("The mask was derived by interpolation from the space spanned by ${}$.", functions_latex(sequence.interpolated))));
  }
  const std::vector<ExponentialFunction> space = reproduced_space(sequence, sequence.types.front().type, false);
  if (!space.empty()) blocks.push_back(paragraph(fmt::format("Every step reproduces ${}$ at every angle.", functions_latex(space))));
  return blocks;
}

Blocks asymptotic_proof(const Scheme& scheme, const Certificate& certificate) {
  const AsymptoticProof& proof = std::get<AsymptoticProof>(certificate.proof);
  const AsymptoticBound& bound = proof.bound;
  const int m = certificate.claim.smoothness, p = scheme.mask.arity;
  const std::string difference = bound.factors == 0 ? "" : fmt::format(", where $c=p^{{{0}}}a/\\sigma^{{{0}}}$", bound.factors);
  const char* c = bound.factors == 0 ? "a" : "c";
  Blocks blocks{paragraph(fmt::format("For $k\\to\\infty$ the masks tend to the mask $a$ for $\\mu=1$, whose scheme is $C^{{{}}}$ by [Theorem U1](#theorem-U1) with level $l={}$. "
                                      "With $x_k=\\theta\\,{}^{{-(k+1)}}$,", m, proof.limit_level, p))};
  const Rational rounded = bound.constant;
  const std::string decimal = to_decimal(rounded, 10, Rounding::nearest), exact = read_rational(decimal) == rounded ? decimal : inline_latex(rounded);
  blocks.push_back(Display{{{"", {fmt::format("\\lVert S_{{{0}^{{(k)}}}}-S_{0}\\rVert_\\infty\\le C\\,x_k^{{{1}}},\\qquad C{2},", c, bound.order,
                                             exact.size() <= 20 ? "=" + exact : fmt::format("\\le{}", to_decimal(rounded, 6, Rounding::up)))}}}});
  blocks.push_back(paragraph(fmt::format("for all $k\\ge{}$ and all angles of the region{}. Since ${}>{}$, the sum over $k$ of ${}$ times these norms is finite, and [Theorem S1](#theorem-S1) applies.",
                                         bound.from_level, difference, bound.order, m - bound.factors,
                                         m == bound.factors ? "1" : fmt::format("{}^{{{}k}}", p, m - bound.factors == 1 ? "" : std::to_string(m - bound.factors)))));
  return blocks;
}

Blocks space_proof(const Scheme&, const Certificate& certificate) {
  const SpaceProof& proof = std::get<SpaceProof>(certificate.proof);
  const SpaceStatement& space = *certificate.claim.space;
  const char* verb = space.generates ? "generated" : "reproduced";
  if (proof.function) {
    return {paragraph(fmt::format("The opposite holds for ${}$; [Theorem S2](#theorem-S2) applies.", function_latex(space.functions[static_cast<std::size_t>(*proof.function)])))};
  }
  if (!certificate.claim.negated) {
    return {paragraph(fmt::format("For each of the functions the moments of the mask are, in every residue class, those that [Theorem S2](#theorem-S2) asks for: identities of rational functions "
                                  "in $c=\\{}$ of the angle of a step, which hold at every level.", certificate.claim.type == AngleType::trigonometric ? "cos" : "cosh"))};
  }
  Blocks blocks{paragraph(fmt::format("For each of the functions a moment differs from what [Theorem S2](#theorem-S2) asks for, by a function of $c=\\{}$ of the angle of a step that has no zero "
                                      "at the angles of the region; so none is {}:", certificate.claim.type == AngleType::trigonometric ? "cos" : "cosh", verb))};
  DataTable table{.caption = {}, .columns = "lrrl", .header = {rich("function"), rich("residue"), rich("moment"), rich("defect")}, .rows = {}};
  for (std::size_t k = 0; k < proof.defects.size() && k < space.functions.size(); ++k) {
    const MomentDefect& defect = proof.defects[k];
    // On one line: rows are low.
    const auto part = [](const MultivariatePolynomial& p) {
      const std::string latex = to_latex(RationalFunction(p), {"c"});
      return p.term_count() > 1 ? "(" + latex + ")" : latex;
    };
    const std::string value = defect.value.is_polynomial() ? to_latex(defect.value, {"c"}) : part(defect.value.numerator()) + "/" + part(defect.value.denominator());
    table.rows.push_back({mathematics(function_latex(space.functions[k])), mathematics(std::to_string(defect.residue)), mathematics(std::to_string(defect.moment)),
                          estimated_width(value) <= 45 ? mathematics(value) : rich("in the certificate")});
  }
  blocks.push_back(std::move(table));
  return blocks;
}

}  // namespace limes::report_impl
