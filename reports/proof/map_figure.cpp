// Where a scheme with one parameter is C^m and where not, by the certificates of its claims.
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <algorithm>

namespace limes::report_impl {
namespace {

constexpr Color certified{0, 158, 115}, refuted{213, 94, 0}, unknown{242, 240, 228};

struct Piece {
  int smoothness = 0;
  bool smooth = true;
  Interval range;
};

std::vector<Piece> pieces_of(const ReportedScheme& reported) {
  std::vector<Piece> pieces;
  for (const DecidedClaim& decided : reported.claims) {
    const Claim& claim = decided.claim;
    if (!decided.verdict.certificate || claim.space || claim.subject != ClaimSubject::limits) continue;
    if (decided.verdict.outcome == Outcome::certified) {
      pieces.push_back({claim.smoothness, !claim.negated, claim.region.front()});
    } else if (const auto* proof = std::get_if<LeafProof>(&decided.verdict.certificate->proof)) {
      for (const ProofLeaf& leaf : proof->leaves) pieces.push_back({claim.smoothness, claim.negated, leaf.region.front()});
    }
  }
  return pieces;
}

}  // namespace

std::optional<Figure> map_figure(const ReportedScheme& reported) {
  const Scheme& scheme = reported.scheme;
  if (scheme.parameters.size() != 1 || scheme.sequence) return std::nullopt;
  const std::vector<Piece> pieces = pieces_of(reported);
  if (std::none_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return !piece.range.is_point(); })) return std::nullopt;
  int lowest = pieces.front().smoothness, highest = lowest;
  for (const Piece& piece : pieces) {
    lowest = std::min(lowest, piece.smoothness);
    highest = std::max(highest, piece.smoothness);
  }
  const double left = approx_double(scheme.parameters[0].range.lower), right = approx_double(scheme.parameters[0].range.upper);
  Plot plot = small_plot("");
  plot.width = 330;
  plot.height = 17.0 * (highest - lowest + 1);
  plot.x = {parameter_latex(scheme.parameters[0].name), left, right};
  plot.x.label = "$" + plot.x.label + "$";
  plot.y = {"", lowest - 0.5, highest + 0.5, false, std::vector<PlotTick>{}};
  std::string data = "smoothness,verdict,lower,upper,lower end,upper end\n";
  const auto bar = [](int m, double from, double to) { return std::vector<PlotPoint>{{from, m - 0.36}, {to, m - 0.36}, {to, m + 0.36}, {from, m + 0.36}}; };
  for (int m = lowest; m <= highest; ++m) {
    PlotRegion open{{bar(m, left, right)}, unknown}, smooth{{}, certified}, rough{{}, refuted};
    std::vector<PlotPoint> smooth_points, rough_points;
    for (const Piece& piece : pieces) {
      // C^m implies less, not C^m implies not more.
      if (piece.smooth ? piece.smoothness < m : piece.smoothness > m) continue;
      const double from = approx_double(piece.range.lower), to = approx_double(piece.range.upper);
      const bool covered = std::any_of(pieces.begin(), pieces.end(), [&](const Piece& other) {
        return !other.range.is_point() && other.smooth == piece.smooth && (piece.smooth ? other.smoothness >= m : other.smoothness <= m) && other.range.contains(piece.range.lower);
      });
      if (piece.range.is_point() && covered) continue;
      if (piece.range.is_point()) (piece.smooth ? smooth_points : rough_points).push_back({from, double(m)});
      else (piece.smooth ? smooth : rough).outlines.push_back(bar(m, from, to));
      data += fmt::format("{},{},{},{},{},{}\n", m, piece.smooth ? "certified" : "refuted", to_string(piece.range.lower), to_string(piece.range.upper), piece.range.lower_open ? "open" : "closed",
                          piece.range.upper_open ? "open" : "closed");
    }
    plot.items.push_back(std::move(open));
    for (PlotRegion* region : {&smooth, &rough}) {
      if (!region->outlines.empty()) plot.items.push_back(std::move(*region));
    }
    if (!smooth_points.empty()) plot.items.push_back(PlotMarkers{smooth_points, {0, 96, 70}, 2});
    if (!rough_points.empty()) plot.items.push_back(PlotMarkers{rough_points, {150, 50, 0}, 2});
    plot.y.ticks->push_back({double(m), fmt::format("$C^{{{}}}$", m)});
  }
  return Figure{.name = scheme.name + "-map",
                .panels = {{plot, data}},
                .caption = rich("Where the propositions of this section prove the scheme to be $C^m$ (green) and not $C^m$ (red); dots are single values. Nothing is proved where it is pale.")};
}

}  // namespace limes::report_impl
