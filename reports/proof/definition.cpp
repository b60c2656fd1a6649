#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/stability.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

namespace limes::report_impl {
namespace {

RichText parameters_text(const Scheme& scheme) {
  if (scheme.parameters.empty()) return {};
  return rich(fmt::format(" The parameter is taken from the range ${}$.", region_latex(scheme, scheme.parameter_box())));
}

RichText polynomials_text(const Mask& mask, const VariableNames& names) {
  const PolynomialDegrees degrees = polynomial_degrees(mask);
  if (degrees.generation < 0) return rich(fmt::format("Since $a(1)\\ne{}$, not even constants are generated.", mask.arity));
  std::string text = fmt::format("The scheme generates polynomials up to degree ${}$ and reproduces them up to degree ${}$", degrees.generation,
                                 degrees.reproduction);
  if (degrees.reproduction >= 1) {
    const std::string shift = to_latex(degrees.parameter_shift, names);
    if (shift != "0") text += fmt::format(" (data at $t_i=i{}{}$)", shift.starts_with('-') ? "" : "+", shift);
  }
  return rich(text + " [@ContiHormann2011].");
}

RichText stability_text(const Mask& mask) {
  const std::optional<Stability> stability = prove_stability(mask);
  if (!stability) return {};
  if (*stability == Stability::interpolatory) return rich(" It is interpolatory, so the integer shifts of its basic limit function are stable.");
  return rich(" The integer shifts of its basic limit function are linearly independent, hence stable [@JiaWang1993].");
}

/// \param with_range whether the parameters' range is told after the words
Blocks uniform_definition(const Scheme& scheme, const std::string& words, bool with_range) {
  Blocks blocks;
  const Mask& mask = scheme.mask;
  const VariableNames names = scheme.parameter_names();
  const int k = sum_rule_order(mask);
  blocks.push_back(paragraph(words));
  blocks.push_back(refinement_rules(mask, names));
  if (with_range && !scheme.parameters.empty()) blocks.push_back(paragraph(parameters_text(scheme)));
  const LaurentPolynomial b = *difference_symbol(mask, k);
  const std::string factor = k == 0 ? fmt::format("{}\\,b(z)", mask.arity)
                                    : fmt::format("{}{}\\,b(z)", k == 1 ? "" : negative_power(mask.arity, k - 1), sigma_power(mask.arity, k));
  blocks.push_back(paragraph(fmt::format("Its symbol $a(z)=\\sum_i a_i z^i$ satisfies the sum rules of order ${}$,", k)));
  Display display{{{"a(z)", {"=" + factor + ","}}, sum_line("b(z)", laurent_terms(b, names))}};
  close(display, ".");
  blocks.push_back(std::move(display));
  blocks.push_back(paragraph(polynomials_text(mask, names) + stability_text(mask)));
  return blocks;
}

/// The coefficients for independent ratios, where they are short enough to be read.
Blocks coefficients_in_ratios(const Scheme& scheme) {
  const InsertionRule& rule = *scheme.insertion_rule;
  const int points = rule.points(), ratios = points - 2;
  if (points > 6) return {};
  VariableNames names = scheme.parameter_names();
  for (int k = 1; k <= ratios; ++k) names.push_back(fmt::format("beta_{}", k));
  const std::vector<RationalFunction> stencil = rule.symbolic_stencil();
  Display display;
  const bool symmetric = is_mirror_symmetric(isolated_ratio_stencils(rule, {}));
  const int shown = symmetric ? points / 2 : points;
  for (int j = 0; j < shown; ++j) {
    const std::string text = to_latex(stencil[static_cast<std::size_t>(j)], names);
    if (estimated_width(text) > 70) return {};
    display.lines.push_back({fmt::format("e_{{{}}}", j + 1), {"=" + text + (j + 1 < shown ? "," : ".")}});
  }
  return {paragraph(fmt::format("With the ratios $\\beta_k=(t_{{s+1}}-t_s)/(t_s-t_{{s-1}})$, $s=i{:+d}+k$, the new point is $\\sum_j e_j\\,p_{{i-{}+j}}$ with{}",
                                1 - points / 2, points / 2, symmetric ? ", up to symmetry," : "")),
          display};
}

Blocks nonuniform_definition(const Scheme& scheme) {
  const InsertionRule& rule = *scheme.insertion_rule;
  const int n = rule.points() / 2;
  Blocks blocks;
  blocks.push_back(paragraph(
      rich(fmt::format("Between $p_i$ and $p_{{i+1}}$ with knots $t_i<t_{{i+1}}$ the scheme inserts a point at $(t_i+t_{{i+1}})/2$ that depends on the ${}$ points "
                       "$p_{{i-{}}},\\dots,p_{{i+{}}}$ and their knots.", 2 * n, n - 1, n)) +
      parameters_text(scheme)));
  append(blocks, rule_text(rule.text()));
  append(blocks, coefficients_in_ratios(scheme));
  append(blocks, uniform_definition(scheme, "For equal knot intervals the scheme is uniform:", false));
  return blocks;
}

}  // namespace

Display refinement_rules(const Mask& mask, const VariableNames& names) {
  Display display;
  const int p = mask.arity;
  for (int residue = 0; residue < p; ++residue) {
    std::vector<std::pair<int, RationalFunction>> terms;  // offset j: q_{pi+residue} = sum a_{residue - p j} p_{i+j}
    for (int i = mask.symbol.highest(); i >= mask.symbol.lowest(); --i) {
      if ((residue - i) % p != 0) continue;
      if (const RationalFunction c = mask.symbol.coefficient(i); !c.is_zero()) terms.emplace_back((residue - i) / p, c);
    }
    std::vector<std::string> sum;
    for (const auto& [offset, c] : terms) {
      const std::string point = offset == 0 ? "p_{i}" : fmt::format("p_{{i{:+d}}}", offset);
      // A term is written as a coefficient times a "power" of the point.
      sum.push_back(power_sum_terms({{1, c}}, point, names).front());
    }
    if (sum.empty()) sum.emplace_back("+0");
    const std::string left = p == 2 && residue == 0 ? "q_{2i}" : residue == 0 ? fmt::format("q_{{{}i}}", p) : fmt::format("q_{{{}i+{}}}", p, residue);
    display.lines.push_back(sum_line(left, sum));
    display.lines.back().right.back() += residue + 1 < p ? "," : ".";
  }
  return display;
}

Blocks definition(const Scheme& scheme) {
  if (scheme.insertion_rule) return nonuniform_definition(scheme);
  if (scheme.kind == SchemeKind::uniform) return uniform_definition(scheme, "From points $p_j$ one step makes the points", true);
  if (scheme.sequence) return nonstationary_definition(scheme);
  if (scheme.surface) return surface_definition(scheme);
  return {paragraph(rich("The scheme is defined by its file, ") + code(scheme.file.filename().string()) + rich(".") + parameters_text(scheme))};
}

}  // namespace limes::report_impl
