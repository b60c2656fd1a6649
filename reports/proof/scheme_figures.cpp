// Which figures a scheme's section has, and where they are taken.
#include "algebra/error.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <algorithm>

namespace limes::report_impl {

std::string csv(const std::string& header, const std::vector<PlotPoint>& points) {
  std::string text = header + "\n";
  for (const PlotPoint& p : points) text += fmt::format("{:.12g},{:.12g}\n", p.x, p.y);
  return text;
}

Plot small_plot(const std::string& title) {
  Plot plot{.title = title, .x = {}, .y = {}, .items = {}};
  plot.width = panel_width;
  plot.height = panel_height;
  return plot;
}

std::string at_text(const Scheme& scheme, std::span<const Rational> point) {
  return scheme.parameters.empty() ? "" : fmt::format(" for ${}$", point_latex(scheme.parameter_names(), point));
}

std::vector<Rational> simple_point(const Box& box) {
  std::vector<Rational> point;
  for (const Interval& x : box) {
    const Rational quarter = x.width() / 4;
    point.push_back(x.is_point() ? x.lower : simplest_between(x.lower + quarter, x.upper - quarter));
  }
  return point;
}

std::vector<Rational> shown_point(const ReportedScheme& reported) {
  const Box* best = nullptr;
  int smoothness = -1;
  for (const DecidedClaim& decided : reported.claims) {
    const Claim& claim = decided.claim;
    if (claim.negated || claim.space || claim.subject != ClaimSubject::limits || decided.verdict.outcome != Outcome::certified) continue;
    // Of equal smoothness a region rather than a point, and the larger one.
    const bool wider = best && claim.smoothness == smoothness && !claim.region.empty() && claim.region.front().width() > best->front().width();
    if (claim.smoothness > smoothness || wider) best = &claim.region, smoothness = claim.smoothness;
  }
  // A value that the file itself names is better known.
  for (const DecidedClaim& decided : reported.claims) {
    const Claim& claim = decided.claim;
    if (best && !claim.negated && !claim.space && claim.smoothness == smoothness && decided.verdict.outcome == Outcome::certified && !claim.region.empty() && is_point(claim.region)) return midpoint(claim.region);
  }
  return simple_point(best ? *best : reported.scheme.parameter_box());
}

int certified_smoothness(const ReportedScheme& reported, std::span<const Rational> point) {
  int smoothness = -1;
  for (const DecidedClaim& decided : reported.claims) {
    if (decided.claim.negated || decided.claim.space || decided.claim.subject != ClaimSubject::limits || decided.verdict.outcome != Outcome::certified || !contains(decided.claim.region, point)) continue;
    smoothness = std::max(smoothness, decided.claim.smoothness);
  }
  return smoothness;
}

Blocks scheme_figures(const ReportedScheme& reported, const ProofReportOptions& options, const Stop& stop) {
  const Scheme& scheme = reported.scheme;
  Blocks blocks;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) blocks.push_back(std::move(*figure));
  };
  try {
    if (scheme.surface) {
      add(characteristic_map_figure(scheme));
      add(vertex_surface_figure(scheme, stop));
      if (scheme.surface->virtual_points) append(blocks, surface_figures(scheme, options.nets, stop));
      return blocks;
    }
    if (scheme.sequence) {
      int smoothness = -1;
      for (const DecidedClaim& decided : reported.claims) {
        if (!decided.claim.negated && !decided.claim.space && decided.verdict.outcome == Outcome::certified) smoothness = std::max(smoothness, decided.claim.smoothness);
      }
      add(angles_figure(reported, smoothness, stop));
      return blocks;
    }
    if (scheme.kind != SchemeKind::uniform && !scheme.insertion_rule) return blocks;
    const std::vector<Rational> point = shown_point(reported);
    const int smoothness = certified_smoothness(reported, point);
    add(map_figure(reported));
    add(limit_function_figure(reported, point, smoothness));
    add(eigenvalues_figure(reported, point, smoothness, stop));
    add(norms_figure(reported, point, smoothness, stop));
    // Where nothing converges, or only to zero, there is no curve to look at.
    if (smoothness >= 1) {
      add(comb_figure(reported, point, options.polygons, stop));
      add(square_figure(reported, point, options.polygons, stop));
    }
    add(curvature_figure(reported, options.polygons, stop));
  } catch (const DomainError&) {
    // A pole at the shown point: no further pictures.
  }
  return blocks;
}

}  // namespace limes::report_impl
