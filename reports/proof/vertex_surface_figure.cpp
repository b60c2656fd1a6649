// Shaded limits around one extraordinary vertex or face, in double precision, by the scheme's own ring rules.
#include "algebra/error.hpp"
#include "algebra/number/rational.hpp"
#include "reports/plot/surface_plot.hpp"
#include "reports/proof/figures_impl.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace limes::report_impl {
namespace {

/// The points of the rings up to some number around one vertex (face), sector by sector.
struct Rings {
  bool dual = false;
  int valence = 0;
  int count = 0;
  Point3 centre;
  std::vector<std::map<RingPoint, Point3>> sectors;

  /// The point (a, b), a, b >= 0, of any sector.
  const Point3& at(int sector, RingPoint point) const {
    if (!dual && point.a == 0 && point.b == 0) return centre;
    const bool next = !dual && point.a == 0;
    const auto s = static_cast<std::size_t>(((sector + next) % valence + valence) % valence);
    return sectors[s].at(next ? RingPoint{point.b, 0} : point);
  }
};

/// A disc of unit squares, n of them at the centre, raised to a saddle with a hill.
Rings control_points(const RingRule& rule, int valence) {
  Rings rings{rule.dual, valence, rule.invariant_rings() + 1, {}, std::vector<std::map<RingPoint, Point3>>(static_cast<std::size_t>(valence))};
  const double radius = rings.count, folds = valence == 3 ? 3 : 2;
  const auto raised = [&](double x, double y) {
    const double r = std::hypot(x, y) / radius;
    return Point3{x, y, radius * (0.3 * r * r * std::cos(folds * std::atan2(y, x)) + 0.25 * (1 - r * r))};
  };
  rings.centre = raised(0, 0);
  for (int s = 0; s < valence; ++s) {
    const double from = 2 * std::numbers::pi * s / valence, to = 2 * std::numbers::pi * (s + 1) / valence;
    for (const RingPoint& point : sector_points(rule.dual, rings.count)) {
      const double shift = rule.dual ? 0.5 : 0, a = point.a + shift, b = point.b + shift;
      // Rings are round, so that sectors of few and of many degrees look alike.
      const double angle = from + (to - from) * b / (a + b), r = std::max(a, b);
      rings.sectors[static_cast<std::size_t>(s)][point] = raised(r * std::cos(angle), r * std::sin(angle));
    }
  }
  return rings;
}

/// One step at mu = 1, as far as the rings suffice.
Rings refined(const RingRule& rule, const Rings& old) {
  const std::vector<Rational> where{1, old.valence};
  using Terms = std::vector<std::pair<RingTerm, double>>;
  const auto weighted = [&](RingPoint point) {
    Terms terms;
    for (RingTerm& term : std::vector<RingTerm>(rule.at(point))) {
      const double weight = approx_double(term.weight(where));
      terms.emplace_back(std::move(term), weight);
    }
    return terms;
  };
  const auto value = [&](const Terms& terms, int sector) {
    Point3 sum;
    for (const auto& [term, weight] : terms) {
      if (term.harmonic < 0) {
        sum += weight * old.at(sector + term.sector, term.point);
        continue;
      }
      for (int t = 0; t < old.valence; ++t) {
        sum += weight / old.valence * std::cos(2 * std::numbers::pi * term.harmonic * (t - sector) / old.valence) * old.at(t, term.point);
      }
    }
    return sum;
  };
  Rings rings{old.dual, old.valence, 0, {}, std::vector<std::map<RingPoint, Point3>>(static_cast<std::size_t>(old.valence))};
  if (!old.dual) rings.centre = value(weighted({0, 0}), 0);
  for (int ring = 1;; ++ring) {
    std::map<RingPoint, Terms> terms;
    for (const RingPoint& point : sector_points(old.dual, ring)) {
      if (ring_of(old.dual, point) == ring) terms[point] = weighted(point);
    }
    for (const auto& [point, list] : terms) {
      for (const auto& [term, weight] : list) {
        if (ring_of(old.dual, term.point) > old.count) return rings;
      }
    }
    rings.count = ring;
    for (int s = 0; s < old.valence; ++s) {
      for (const auto& [point, list] : terms) rings.sectors[static_cast<std::size_t>(s)][point] = value(list, s);
    }
  }
}

PolygonMesh mesh_of(const Rings& rings) {
  PolygonMesh mesh;
  std::map<std::pair<int, RingPoint>, MeshIndex> numbers;
  const auto number = [&](int sector, RingPoint point) {
    if (!rings.dual && point.a == 0) sector = point.b == 0 ? 0 : sector + 1, point = {point.b, 0};
    sector = (sector % rings.valence + rings.valence) % rings.valence;
    const auto [found, added] = numbers.try_emplace({sector, point}, static_cast<MeshIndex>(mesh.points.size()));
    if (added) mesh.points.push_back(rings.at(sector, point));
    return found->second;
  };
  const int last = rings.dual ? rings.count - 1 : rings.count;
  std::vector<MeshIndex> middle;
  for (int s = 0; s < rings.valence; ++s) {
    for (int a = 0; a < last; ++a) {
      for (int b = 0; b < last; ++b) mesh.faces.push_back({number(s, {a, b}), number(s, {a + 1, b}), number(s, {a + 1, b + 1}), number(s, {a, b + 1})});
      if (rings.dual) mesh.faces.push_back({number(s, {a, 0}), number(s - 1, {0, a}), number(s - 1, {0, a + 1}), number(s, {a + 1, 0})});
    }
    if (rings.dual) middle.push_back(number(s, {0, 0}));
  }
  if (rings.dual) mesh.faces.push_back(middle);
  return mesh;
}

}  // namespace

std::optional<Figure> vertex_surface_figure(const Scheme& scheme, const Stop& stop) {
  const RingRule& rule = scheme.surface->rings;
  Figure figure{.name = scheme.name + "-limit-surfaces", .panels = {}, .caption = {}};
  constexpr int levels = 3;
  for (const int n : {3, 5, 8}) {
    try {
      Rings rings = control_points(rule, n), net;
      SurfacePlotOptions options;
      options.title = fmt::format("$n={}$", n);
      options.azimuth = 25;
      options.elevation = 38;
      for (int level = 0; level < levels; ++level) {
        stop.check();
        rings = refined(rule, rings);
        if (level == 0) net = rings;
      }
      // The surface does not reach as far as the control points; the first refined net is drawn over it.
      net.count = std::min(net.count, rings.count / (1 << (levels - 1)) + 1);
      options.lines = edge_lines(mesh_of(net));
      const PolygonMesh mesh = mesh_of(rings);
      Plot plot = surface_plot(mesh, options);
      plot.width = 140;
      plot.height = 110;
      for (PlotItem& item : plot.items) {
        if (auto* curve = std::get_if<PlotCurve>(&item)) curve->stroke.width = 0.3;
      }
      std::string data = "x,y,z\n";
      for (const Point3& p : mesh.points) data += fmt::format("{:.9g},{:.9g},{:.9g}\n", p.x, p.y, p.z);
      figure.panels.push_back({std::move(plot), data});
    } catch (const InputError&) {
      // No number of rings is invariant, or a rule has a pole at this valence.
    } catch (const DomainError&) {
    }
  }
  if (figure.panels.empty()) return std::nullopt;
  figure.caption = rich(fmt::format("Surfaces around an extraordinary {} of valence $n$, after three steps{}, under the net after one step.", rule.dual ? "face" : "vertex", scheme.parameters.empty() ? "" : " with $\\mu=1$"));
  return figure;
}

}  // namespace limes::report_impl
