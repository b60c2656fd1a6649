#include "reports/unity/decided_filters.hpp"

#include "algebra/error.hpp"
#include "reports/document/sha256.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

/// Length and error of every extension tried.
std::vector<PlotPoint> errors(const Multiresolution& result) {
  std::vector<PlotPoint> points;
  for (const ExtensionStep& step : result.steps) {
    if (step.squared_error == 0) continue;
    points.push_back({static_cast<double>(result.bank.length() - result.bank.extension + step.extension), std::sqrt(approx_double(step.squared_error))});
  }
  return points;
}

/// "0.530330085..", or both ends.
std::string bounds_latex(const RationalBounds& bounds) {
  const std::string low = to_decimal(bounds.lower, 8, Rounding::down), high = to_decimal(bounds.upper, 8, Rounding::up);
  if (bounds.lower == bounds.upper && to_string(bounds.lower).size() <= 12) return "=" + inline_latex(bounds.lower);
  return low == high ? "=" + low : fmt::format("\\in[{},{}]", low, high);
}

/// Rationals that fit are exact, others have nine digits.
std::string entry(const Rational& x) {
  const std::string exact = to_string(x);
  return exact.size() <= 12 ? exact : to_decimal(x, 9, Rounding::nearest);
}

DataTable filter_table(const FilterBank& bank) {
  DataTable table{.caption = {}, .columns = "rrrrr", .header = {mathematics("m"), mathematics("p_m"), mathematics("a_m"), mathematics("b_m"), mathematics("q_m")}, .rows = {}};
  for (std::size_t m = 0; m < bank.p.size(); ++m) {
    std::vector<RichText> row{mathematics(fmt::format("{}", m))};
    for (const auto* filter : {&bank.p, &bank.a, &bank.b, &bank.q}) row.push_back(mathematics(entry((*filter)[m])));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::optional<DecidedFilters> decide_filters(const Scheme& scheme, int extension, const Stop& stop) {
  if (scheme.kind != SchemeKind::uniform || !scheme.parameters.empty() || scheme.mask.arity != 2) return std::nullopt;
  const std::vector<Rational> mask = scheme.mask.symbol.rational_coefficients();
  DecidedFilters filters;
  try {
    filters.shortest = find_multiresolution(mask, {}, stop);
    filters.extended = find_multiresolution(mask, {.extension = extension, .threshold = {}, .shift = {}}, stop);
  } catch (const InputError&) {  // no filters: the parts of the mask have a common zero, or it is too long
    return std::nullopt;
  }
  filters.proof = prove_biorthogonality(scheme.name, scheme.mask, filters.shortest.bank);
  filters.extended_proof = prove_biorthogonality(scheme.name, scheme.mask, filters.extended.bank);
  filters.certificate = scheme.name + ".multiresolution.json";
  return filters;
}

std::vector<Block> filter_section(const Scheme& scheme, const DecidedFilters& filters) {
  const FilterBank& bank = filters.shortest.bank;
  std::vector<Block> blocks;
  blocks.push_back(Heading{2, rich("Multiresolution filters")});
  blocks.push_back(Paragraph{rich(fmt::format("The scheme in reverse [@MoltajiRunionsSamavati2017]: $c=Af$ are coarse points of the fine points $f$, $d=Bf$ details, and $f=Pc+Qd$. The filters of the least length ${}$ with the least "
                                              "orthogonality error $\\lVert P^{{\\mathsf T}}q\\rVert_2$ have the shift $s={}$;{} $p$ is the mask{}.",
                                              bank.length(), bank.shift, bank.length() > 12 ? " long numbers are rounded here;" : "", scheme.mask.symbol.coefficients().size() % 2 != 0 ? " with a zero appended" : ""))});
  blocks.push_back(filter_table(bank));
  blocks.push_back(Statement{.kind = Statement::Kind::proposition,
                             .title = {},
                             .body = {Paragraph{rich("These filters are biorthogonal, $AP=I$, $AQ=0$, $BP=0$, $BQ=I$ and $PA+QB=I$, for circulant matrices of every size. In $\\ell^2$")},
                                      Display{{{"\\lVert P^{\\mathsf T}q\\rVert", {bounds_latex(filters.proof.orthogonality_error) + ",", "\\quad\\sigma_{\\min}(P)" + bounds_latex(filters.proof.sigma_min_p) + ","}},
                                               {"\\lVert A\\rVert", {bounds_latex(filters.proof.norm_a) + ",", "\\quad\\lVert B\\rVert" + bounds_latex(filters.proof.norm_b) + "."}}}}}});
  const Rational constants = exact_detail_of_constants(bank);
  std::string text = constants == 0 ? "Constants have no details."
                                    : fmt::format("Constants have details: every entry of $B1$ is ${}$, so that homogeneous weights are needed for details that do not change when data are translated.", inline_latex(constants));
  blocks.push_back(Statement{.kind = Statement::Kind::proof,
                             .title = {},
                             .body = {Paragraph{rich(fmt::format("By [Theorem B1](#theorem-B1), exactly; the bounds are those of trigonometric polynomials on the circle. Certificate `{}` (SHA-256 `{}`).", filters.certificate,
                                                                 sha256(filters.proof.certificate_json).substr(0, 12)))}}});
  const std::vector<PlotPoint> points = errors(filters.extended);
  if (points.size() > 1) {
    text += fmt::format(" Longer filters have a smaller error: with length ${}$ it is $\\lVert P^{{\\mathsf T}}q\\rVert{}$. But they are not more stable than the mask allows: $\\lVert A\\rVert\\ge1/\\sigma_{{\\min}}(P)$ whatever their length; here "
                        "$\\lVert A\\rVert{}$.",
                        filters.extended.bank.length(), bounds_latex(filters.extended_proof.orthogonality_error), bounds_latex(filters.extended_proof.norm_a));
  }
  blocks.push_back(Paragraph{rich(text)});
  if (points.size() > 1) {
    const std::vector<ErrorCurve> curves{{scheme.name, filters.extended}};
    Plot plot = report_impl::small_plot("");
    plot.x.label = "filter length";
    plot.y.label = "error";
    plot.y.logarithmic = true;
    plot.items = {PlotCurve{points, {palette(1), 1, Dash::solid}}, PlotMarkers{points, palette(1), 1.6}};
    blocks.push_back(Figure{.name = scheme.name + "-filters", .panels = {{plot, error_csv(curves)}}, .caption = rich("The orthogonality error against the length of the filters.")});
  }
  return blocks;
}

std::vector<Block> biorthogonality_theorem() {
  const char* const words =
      "Let the columns of $P$ and $Q$ be the filters $p$ and $q$, column $j$ beginning at row $2j$, and the rows of $A$ and $B$ the filters $a$ and $b$, row $i$ beginning at column $2i+s$, $s$ even. If "
                        "$\\sum_ma_mp_{m+s+2d}=\\sum_mb_mq_{m+s+2d}=\\delta_{d0}$ and $\\sum_ma_mq_{m+s+2d}=\\sum_mb_mp_{m+s+2d}=0$ for all integers $d$, then $AP=I$, $AQ=0$, $BP=0$, $BQ=I$ and "
                        "$PA+QB=I$ on the integers and for circulant matrices of every size.";
  return {Statement{.kind = Statement::Kind::theorem, .title = rich("Theorem B1"), .body = {Paragraph{rich(words)}}, .label = "theorem-B1"}};
}

Plot error_plot(const std::vector<ErrorCurve>& curves) {
  Plot plot{.title = "Orthogonality error against filter length", .x = {.label = "filter length"}, .y = {.label = "||P^T q||", .lower = {}, .upper = {}, .logarithmic = true}, .items = {}};
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::vector<PlotPoint> points = errors(curves[c].result);
    plot.items.push_back(PlotMarkers{points, palette(c), 2});
    plot.items.push_back(PlotCurve{points, {palette(c), 1, Dash::solid}, false, curves[c].name});
  }
  return plot;
}

std::string error_csv(const std::vector<ErrorCurve>& curves) {
  std::string text = "scheme,length,error\n";
  for (const ErrorCurve& curve : curves) {
    for (const PlotPoint& point : errors(curve.result)) text += fmt::format("{},{},{:.12g}\n", curve.name, point.x, point.y);
  }
  return text;
}

}  // namespace limes
