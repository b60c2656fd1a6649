// Surface schemes: their rules around extraordinary vertices, and proofs by E1 and E2.
#include "algebra/error.hpp"
#include "analysis/surface/characteristic_map.hpp"
#include "analysis/surface/vertex_spectrum.hpp"
#include "reports/plot/characteristic_map_plot.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes::report_impl {
namespace {

/// Rows of the table of eigenvalues.
constexpr int most_valences = 8;

std::string ring_point_latex(const RingPoint& point, int sector) {
  if (point == RingPoint{}) return "p(0,0)";
  return fmt::format("p_{{s{}}}({},{})", sector == 0 ? "" : fmt::format("{:+d}", sector), point.a, point.b);
}

/// The rule of a new point of sector s.
Display::Line ring_rule_line(const RingPoint& point, const std::vector<RingTerm>& terms, const VariableNames& names, bool dual) {
  std::vector<std::string> sum;
  for (const RingTerm& term : terms) {
    const std::string old = dual && point == RingPoint{} && term.harmonic < 0 ? fmt::format("p_{{s{}}}({},{})", term.sector == 0 ? "" : fmt::format("{:+d}", term.sector), term.point.a, term.point.b)
                                                                             : ring_point_latex(term.point, term.sector);
    const std::string all = fmt::format("p_t({},{})", term.point.a, term.point.b);
    const std::string what = term.harmonic < 0    ? old
                             : term.harmonic == 0 ? fmt::format("\\tfrac1n\\textstyle\\sum_t {}", all)
                                                  : fmt::format("\\tfrac1n\\textstyle\\sum_t\\cos\\tfrac{{{}\\pi(t-s)}}n\\,{}", 2 * term.harmonic, all);
    sum.push_back(power_sum_terms({{1, term.weight}}, what, names).front());
  }
  return sum_line(fmt::format("q_s({},{})", point.a, point.b), sum);
}

/// The matrix is that of the limit mu = 1.
std::vector<VertexEigenvalue> limit_eigenvalues(const VertexSpectrum& spectrum, int n, const Stop& stop) {
  return spectrum.eigenvalues(n, LevelParameter{.exact = Rational(1), .enclosure = {}}, 64, stop);
}

}  // namespace

std::string valences_latex(const ValenceRange& valences) {
  if (!valences.last) return fmt::format("n\\ge{}", valences.first);
  return *valences.last == valences.first ? fmt::format("n={}", valences.first) : fmt::format("{}\\le n\\le{}", valences.first, *valences.last);
}

std::string vertex_assertion(const Scheme& scheme, const Claim& claim) {
  const char* place = scheme.surface->rings.dual ? "faces" : "vertices";
  const std::string valence = claim.valences ? fmt::format(" of valence ${}$", valences_latex(*claim.valences)) : "";
  const std::string angles = scheme.parameters.empty() ? "" : fmt::format(" for ${}$ ({})", region_latex(scheme, claim.region), to_string(claim.type));
  if (claim.subject == ClaimSubject::vertex_spectrum && scheme.parameters.empty()) return fmt::format("At extraordinary {}{} the scheme satisfies the spectral condition.", place, valence);
  if (claim.subject == ClaimSubject::vertex_spectrum) {
    return fmt::format("At extraordinary {}{} the limit $M$ of the matrices $M_k$ of the steps satisfies the spectral condition, and $\\sum_k2^k\\lVert M_k-M\\rVert<\\infty${}.", place, valence, angles);
  }
  return fmt::format("At extraordinary {}{} the scheme is ${}C^{{{}}}$ for generic control points{}.", place, valence, claim.negated ? "\\text{not }" : "", claim.smoothness, angles);
}

Blocks surface_definition(const Scheme& scheme) {
  const SurfaceRule& surface = *scheme.surface;
  const RingRule& rule = surface.rings;
  Blocks blocks{paragraph(rich(fmt::format("A scheme for meshes of quadrilaterals: where the mesh is regular, the tensor product of the {} curve scheme ", rule.dual ? "dual" : "primal")) + code(surface.curve) + rich(", whose step is"))};
  blocks.push_back(refinement_rules(rule.curve, {scheme.sequence || !scheme.parameters.empty() ? "mu_k" : "mu", "n"}));
  if (surface.virtual_points) {
    blocks.push_back(paragraph("Lines of the mesh continue through an extraordinary vertex $P$ of valence $n$, with neighbours $L_i$ and the opposite corner $K_i$ of the face between $L_i$ and $L_{i+1}$, by virtual points "
                               "[@Kobbelt1996], [@BariMustafaGhaffarNisarBaleanu2021],"));
    blocks.push_back(Display{{{"V_i", {"=\\tfrac4n\\textstyle\\sum_j L_j-(L_{i-1}+L_i+L_{i+1})", "+\\kappa\\,\\bigl(K_{i-2}+K_{i-1}+K_i+K_{i+1}-\\tfrac4n\\sum_j K_j\\bigr),"}}}});
    blocks.push_back(paragraph("$\\kappa$ being minus the quotient of the outer by the inner weight."));
  }
  if (!surface.virtual_points && !rule.given.empty()) {
    blocks.push_back(paragraph(fmt::format("Around an extraordinary {} of valence $n$ the mesh has $n$ sectors $s$ with points $p_s(a,b)$; the new points with rules of their own are", rule.dual ? "face" : "vertex")));
    Display display;
    for (const auto& [point, terms] : rule.given) display.lines.push_back(ring_rule_line(point, terms, {"mu", "n"}, rule.dual));
    close(display, ".");
    blocks.push_back(std::move(display));
  }
  return blocks;
}

Blocks vertex_proof_text(const Scheme& scheme, const Certificate& certificate, const Stop& stop) {
  const VertexProof& proof = std::get<VertexProof>(certificate.proof);
  const RingRule& rule = scheme.surface->rings;
  const ValenceRange& valences = *certificate.claim.valences;
  Blocks blocks;
  std::string text = fmt::format("The rules map the points on ${}$ ring{} to those on as many; rotations split this matrix into Fourier blocks $j=0,\\dots,n-1$, whose entries depend on $\\mathrm{{e}}^{{2\\pi\\mathrm{{i}}j/n}}$.", proof.rings,
                                 proof.rings == 1 ? "" : "s");
  if (!scheme.parameters.empty()) text += " The matrices of the steps tend to that of $\\mu=1$ like $4^{-k}$; the eigenvalues are those of this limit.";
  text += fmt::format(" The curve scheme is $C^1$ by [Theorem U1](#theorem-U1) with level $l={}$.", proof.level);
  if (!proof.separators.empty()) {
    text += " For each single valence Schur's recursion counts the roots of the blocks' characteristic polynomials outside of a circle that separates $1$ and $\\lambda$ from the others:";
    blocks.push_back(paragraph(text));
    DataTable table{.caption = {}, .columns = "rlll", .header = {rich("$n$"), rich("subdominant eigenvalue $\\lambda$"), rich("next modulus"), rich("circle of radius")}, .rows = {}};
    const VertexSpectrum spectrum(rule, proof.rings);
    const int shown = std::min<int>(most_valences, static_cast<int>(proof.separators.size()));
    for (int k = 0; k < shown; ++k) {
      stop.check();
      const int n = valences.first + k;
      const std::vector<VertexEigenvalue> eigenvalues = limit_eigenvalues(spectrum, n, stop);
      const auto lambda = std::find_if(eigenvalues.begin(), eigenvalues.end(), [](const VertexEigenvalue& e) { return e.fourier == 1; });
      const auto next = std::find_if(eigenvalues.begin(), eigenvalues.end(), [&](const VertexEigenvalue& e) { return e.modulus.upper < proof.separators[static_cast<std::size_t>(k)]; });
      table.rows.push_back({mathematics(std::to_string(n)), lambda == eigenvalues.end() ? RichText{} : mathematics(digits_latex(lambda->re)),
                            next == eigenvalues.end() ? RichText{} : mathematics(digits_latex(next->modulus)), mathematics(inline_latex(proof.separators[static_cast<std::size_t>(k)]))});
    }
    blocks.push_back(std::move(table));
    text.clear();
    if (shown < static_cast<int>(proof.separators.size())) text = fmt::format("The certificate has the circles of the valences up to ${}$. ", valences.first + static_cast<int>(proof.separators.size()) - 1);
  }
  if (proof.all) {
    const bool harmonic = std::any_of(rule.given.begin(), rule.given.end(), [](const auto& own) {
      return std::any_of(own.second.begin(), own.second.end(), [](const RingTerm& term) { return term.harmonic == 1; });
    });
    text += fmt::format(" For all $n\\ge{}$ the characteristic polynomials of the blocks $j$ have coefficients that are polynomials in $c=\\cos(2\\pi j/n)$ (of block $0$, in $1/n$, too): on ${}$ interval{} that cover $c\\in[{},1]$ exactly one root of block $1$ is outside of a circle{}, and block $0$ has its other roots there{}.",
                        proof.all->from, proof.all->cells.size(), proof.all->cells.size() == 1 ? "" : "s", inline_latex(proof.all->start),
                        (harmonic ? "; the blocks $2\\le j\\le n-2$ have their roots in $|\\lambda|<" : " and grows with $c$; for the other $c$ all roots are in $|\\lambda|<") + inline_latex(proof.all->bound) + "$",
                        proof.all->touch ? ", but for one, which meets $\\lambda$ in the limit only" : "");
  }
  if (proof.map) {
    text += " The characteristic map has a positive Jacobian, and in the sector it stays in the half-plane about its middle, on the closed annulus whose images under $\\lambda^k$ fill the rest: by enclosures of its control points";
    if (!proof.map->levels.empty()) text += fmt::format(" after up to ${}$ subdivisions for single valences", *std::max_element(proof.map->levels.begin(), proof.map->levels.end()));
    if (!proof.map->pieces.empty()) text += fmt::format("{} on ${}$ intervals of $\\cos(\\pi/n)$ from ${}$ to $1$ for all others", proof.map->levels.empty() ? "" : ", and", proof.map->pieces.size(), inline_latex(proof.map->start));
    text += ".";
  }
  text += fmt::format(" [Theorem {0}](#theorem-{0}) applies.", to_string(certificate.theorem));
  blocks.push_back(paragraph(text));
  return blocks;
}

std::optional<Figure> characteristic_map_figure(const Scheme& scheme) {
  const RingRule& rule = scheme.surface->rings;
  Figure figure{.name = scheme.name + "-characteristic", .panels = {}, .caption = {}};
  std::string shown;
  for (const int n : {3, 5, 8}) {
    try {
      const int rings = rule.invariant_rings(rule.curve.symbol.highest());
      const ApproxCharacteristicMap map(rule, rings, n, std::cos(std::numbers::pi / n));
      Plot plot = characteristic_map_plot(map, n, {.title = fmt::format("$n={}$", n)});
      plot.width = plot.height = 125;
      std::string data = "a,b,re,im\n";
      const int level = 2;
      const auto samples = map.samples(level);
      for (std::size_t a = 0; a < samples.size(); ++a) {
        for (std::size_t b = 0; b < samples[a].size(); ++b) data += fmt::format("{},{},{:.9g},{:.9g}\n", map.reach() + double(a) / (1 << level), double(b) / (1 << level), samples[a][b].real(), samples[a][b].imag());
      }
      figure.panels.push_back({std::move(plot), data});
      shown += fmt::format("{}${}$", shown.empty() ? "" : ", ", n);
    } catch (const DomainError&) {
    } catch (const InputError&) {
    }
  }
  if (figure.panels.empty()) return std::nullopt;
  figure.caption = rich(fmt::format("Grid lines under the characteristic map for the valences {}: three rings of the repeating annulus.", shown));
  return figure;
}

}  // namespace limes::report_impl
