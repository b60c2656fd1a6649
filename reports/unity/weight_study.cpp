#include "reports/unity/weight_study.hpp"

#include "analysis/uniform/difference_symbol.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/unity/weight_figures_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace limes {
namespace {

constexpr int greatest_order = 8;

/// "1.97400\cdot10^{-3}"
std::string error_latex(double x) {
  if (x == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(x)));
  if (exponent >= -3) return fmt::format("{:.6g}", x);
  return fmt::format("{:.5f}\\cdot10^{{{}}}", x * std::pow(10.0, -exponent), exponent);
}

RichText claims_text(const std::vector<Claim>& claims) {
  RichText text;
  for (const Claim& claim : claims) text = text + rich(text.empty() ? "" : ", ") + prose(statement(claim));
  return text;
}

/// Orders with the same mask share a row.
DataTable cost_table(const std::vector<SmoothnessCost>& costs) {
  DataTable table{.caption = rich("What smoothness costs: the least $E$ under sum rules, bounds of the Hölder exponent ([@Rioul1992], [@GuglielmiProtasov2013]), and what is certified of the mask, rounded such that the rules hold exactly."),
                  .columns = "llll",
                  .header = {rich("sum rules"), mathematics("E"), rich("Hölder exponent"), rich("certified")},
                  .rows = {}};
  for (std::size_t k = 0; k < costs.size();) {
    std::vector<std::string> orders;
    const SmoothnessCost& cost = costs[k];
    for (; k < costs.size() && costs[k].mask == cost.mask; ++k) orders.push_back(fmt::format("{}", costs[k].sum_rules));
    table.rows.push_back({mathematics(fmt::format("{}", fmt::join(orders, ","))), mathematics(error_latex(cost.error)),
                          cost.exponent.lower ? mathematics(exponent_range(cost.exponent, "\\ge", ",")) : RichText{}, claims_text(cost.claims)});
  }
  return table;
}

RichText constraints_text(const WeightProblem& problem) {
  if (problem.constraints.empty()) return {};
  RichText text = rich(", with the constraints ");
  for (std::size_t k = 0; k < problem.constraints.size(); ++k) text = text + rich(k > 0 ? ", " : "") + code(problem.constraints[k]);
  return text;
}

}  // namespace

WeightStudy study_weight(const Scheme& scheme, const Stop& stop) {
  WeightStudy study{.problem = *scheme.weight, .derived = derive_mask(*scheme.weight, stop), .error = 0, .even_sum = 0, .odd_sum = 0, .costs = {}};
  const LaurentPolynomial& symbol = scheme.mask.symbol;
  std::vector<Rational> mask;
  for (int k = 0; k < study.derived.equation.count; ++k) mask.push_back(symbol.coefficient(study.derived.equation.first_index() + k).constant_value());
  study.error = study.derived.error_of(mask);
  for (int i = symbol.lowest(); i <= symbol.highest(); ++i) (i % 2 == 0 ? study.even_sum : study.odd_sum) += symbol.coefficient(i).constant_value();
  study.costs = smoothness_costs(study.problem, greatest_order, stop);
  return study;
}

std::vector<std::pair<std::string, std::string>> exponent_certificates(const Scheme& scheme, const WeightStudy& study) {
  std::vector<std::pair<std::string, std::string>> certificates;
  for (std::size_t k = 0; k < study.costs.size(); ++k) {
    const SmoothnessCost& cost = study.costs[k];
    if (cost.exponent_certificate.empty() || (k > 0 && study.costs[k - 1].mask == cost.mask)) continue;
    certificates.emplace_back(fmt::format("{}.sum-rules-{}.hoelder.json", scheme.name, cost.sum_rules), cost.exponent_certificate);
  }
  return certificates;
}

std::vector<Block> weight_section(const Scheme& scheme, const WeightStudy& study) {
  const RefinementEquation& equation = study.derived.equation;
  const WeightProblem& problem = study.problem;
  std::vector<Block> blocks;
  blocks.push_back(Heading{2, rich("The weight function")});
  blocks.push_back(Paragraph{rich("The mask belongs to the weight function $w$ given by ") + code(describe(problem)) + constraints_text(problem) +
                             rich(fmt::format(". It is a least-squares solution of the refinement equation on $[{},{}]$ {} [@MoltajiRunionsSamavati2016]:", inline_latex(equation.domain.lower),
                                              inline_latex(equation.domain.upper),
                                              problem.integrals ? "in $L^2$" : fmt::format("at ${}$ points", problem.samples)))});
  blocks.push_back(Display{{{"w(u)", {"\\approx\\sum_kc_k\\,w(2u-s_k),",
                                      fmt::format("\\qquad s_k={},\\,\\dots,\\,{},", inline_latex(equation.first_shift), inline_latex(equation.first_shift + equation.count - 1)),
                                      "\\qquad E=\\Bigl\\lVert w-\\sum_kc_kw(2\\,\\cdot\\,-s_k)\\Bigr\\rVert\\Big/\\lVert w\\rVert."}}}});
  std::string text = fmt::format("For the mask above $E={}$; the least value is ${}$. The system has the condition number ${:.4g}$ and the rank ${}$ of ${}$.", error_latex(study.error),
                                 error_latex(study.derived.least_error), study.derived.condition, study.derived.rank, study.derived.unknowns);
  const Rational alternating = study.even_sum - study.odd_sum;
  text += fmt::format(" The sums of the even and of the odd coefficients differ from $1$ by ${}$ and ${}$, exactly, and $a(-1)={}$.", inline_latex(study.even_sum - 1), inline_latex(study.odd_sum - 1), inline_latex(alternating));
  blocks.push_back(Paragraph{rich(text)});
  blocks.push_back(unity_impl::weight_figure(scheme, study));
  blocks.push_back(Paragraph{rich("With the sum rules of an order $k$ as constraints, $a(1)=2$ and $(1+z)^k\\mid a(z)$, the scheme has smooth limits, and $E$ is greater.")});
  blocks.push_back(cost_table(study.costs));
  if (study.costs.size() > 2) blocks.push_back(unity_impl::cost_figure(scheme, study));
  return blocks;
}

}  // namespace limes
