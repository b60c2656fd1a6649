// Surface schemes at extraordinary points: claims, proofs by E1 and E2, and pictures of characteristic maps.
#include "algebra/error.hpp"
#include "analysis/surface/characteristic_map.hpp"
#include "reports/plot/characteristic_map_plot.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace limes::report_impl {
namespace {

const char* points_of(const Scheme& scheme) { return scheme.surface->rings.dual ? "faces" : "vertices"; }

std::string valences_words(const ValenceRange& valences) {
  if (!valences.last) return fmt::format("every valence $n\\ge{}$", valences.first);
  if (*valences.last == valences.first) return fmt::format("valence ${}$", valences.first);
  return fmt::format("the valences $n={},\\dots,{}$", valences.first, *valences.last);
}

std::string angles_words(const Scheme& scheme, const Claim& claim) {
  if (scheme.parameters.empty()) return "";
  return fmt::format("${}$ ({})", region_latex(scheme, claim.region), to_string(claim.type));
}

std::string all_or_each(std::size_t count) { return count == 1 ? "this valence" : "each of these valences"; }

}  // namespace

std::string valences_latex(const ValenceRange& valences) {
  if (!valences.last) return fmt::format("n\\ge{}", valences.first);
  return *valences.last == valences.first ? fmt::format("n={}", valences.first) : fmt::format("{}\\le n\\le{}", valences.first, *valences.last);
}

RichText vertex_assertion(const Scheme& scheme, const Claim& claim) {
  const std::string where = fmt::format("isolated extraordinary {} of {}", points_of(scheme), valences_words(*claim.valences));
  const std::string angles = angles_words(scheme, claim);
  if (claim.subject == ClaimSubject::vertex_spectrum) {
    if (angles.empty()) return rich(fmt::format("The spectral condition holds at {}.", where));
    return rich(fmt::format("At {} the limit matrix $M$ satisfies the spectral condition, and $\\sum_k2^k\\lVert M_k-M\\rVert<\\infty$ for the matrices $M_k$ of the steps at every angle {}.",
                            where, angles));
  }
  return rich(fmt::format("{}Near {} the limit surface of almost every control net is {}$C^{{{}}}$.", angles.empty() ? "" : fmt::format("For {}: ", angles), where,
                          claim.negated ? "not " : "", claim.smoothness));
}

Blocks vertex_proof(const Scheme& scheme, const Certificate& certificate) {
  const VertexProof& proof = std::get<VertexProof>(certificate.proof);
  std::string text = fmt::format(
      "By [Theorem {0}](#theorem-{0}), on the control points of ${1}$ {2} around the {3}. The curve scheme is $C^1$ by [Theorem U1](#theorem-U1), level ${4}$.", to_string(certificate.theorem),
      proof.rings, proof.rings == 1 ? "ring" : "rings", scheme.surface->rings.dual ? "face" : "vertex", proof.level);
  if (!proof.separators.empty()) {
    text += fmt::format(" A separator between $\\lambda$ and the other eigenvalues besides $1$ is proved, by counting roots, for $n={}$.",
                        proof.separators.size() == 1 ? std::to_string(certificate.claim.valences->first)
                                                     : fmt::format("{},\\dots,{}", certificate.claim.valences->first,
                                                                   certificate.claim.valences->first + static_cast<int>(proof.separators.size()) - 1));
  }
  if (proof.all) {
    text += fmt::format(" For all $n\\ge{}$, ${}$ intervals of $c=\\cos(2\\pi j/n)$ separate $\\lambda$ as a function of $c$ from the other eigenvalues.", proof.all->from, proof.all->cells.size());
  }
  if (proof.map) {
    const CharacteristicMapProof& map = *proof.map;
    if (!map.levels.empty()) {
      text += fmt::format(" The characteristic map is enclosed for {} after at most ${}$ subdivisions of an annulus.", all_or_each(map.levels.size()),
                          *std::max_element(map.levels.begin(), map.levels.end()));
    }
    if (!map.pieces.empty()) {
      int level = 0;
      for (const auto& piece : map.pieces) level = std::max(level, piece.level);
      text += fmt::format(" For all $n\\ge{}$, ${}$ intervals that cover the values of $\\cos(\\pi/n)$ have it enclosed, for all their points at once, after at most ${}$ subdivisions.",
                          proof.all->from, map.pieces.size(), level);
    }
  }
  return {paragraph(text)};
}

Blocks surface_figures(const ReportedScheme& reported) {
  const RingRule& rule = reported.scheme.surface->rings;
  Figure figure{.name = reported.scheme.name + "-characteristic-maps", .panels = {}, .caption = {}};
  std::string eigenvalues;
  try {
    const int rings = rule.invariant_rings(rule.curve.symbol.highest());
    for (const int n : {3, 5, 8}) {
      const ApproxCharacteristicMap map(rule, rings, n, std::cos(std::numbers::pi / n));
      Plot plot = characteristic_map_plot(map, n, {.title = fmt::format("$n={}$", n), .rings = 2, .level = 3});
      plot.width = plot.height = 120;
      std::string data = "line,x,y\n";
      int line = 0;
      for (PlotItem& item : plot.items) {
        auto& curve = std::get<PlotCurve>(item);
        curve.stroke.width *= 0.6;
        for (const PlotPoint& p : curve.points) data += fmt::format("{},{:.9g},{:.9g}\n", line, p.x, p.y);
        ++line;
      }
      figure.panels.push_back({plot, data});
      eigenvalues += fmt::format("{}{:.6f}", eigenvalues.empty() ? "" : ",\\ ", map.eigenvalue().value);
    }
  } catch (const Error&) {
    return {};  // no map: no picture
  }
  figure.caption = rich(fmt::format("Characteristic maps of the limit rules at the valences $3$, $5$ and $8$: images of grid lines on two self-similar rings, $\\lambda={}$.", eigenvalues));
  return {std::move(figure)};
}

}  // namespace limes::report_impl
