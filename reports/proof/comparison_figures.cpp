// Several schemes on the same polygon, side by side in one scale, as in figures 3 and 6 to 8 of Karciauskas & Peters (2013). In double precision.
#include "algebra/error.hpp"
#include "analysis/uniform/stability.hpp"
#include "geometry/io/csv.hpp"
#include "geometry/refine_polygon.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <algorithm>
#include <cmath>

namespace limes::report_impl {
namespace {

/// A scheme at a parameter value.
struct Shown {
  const ReportedScheme* reported = nullptr;
  std::vector<Rational> point;
  int smoothness = -1;
  const Scheme& scheme() const { return reported->scheme; }
};

std::vector<Shown> curve_schemes(const std::vector<ReportedScheme>& schemes) {
  std::vector<Shown> result;
  for (const ReportedScheme& reported : schemes) {
    const SchemeGroup group = group_of(reported.scheme);
    if (group != SchemeGroup::uniform && group != SchemeGroup::nonuniform) continue;
    Shown shown{&reported, shown_point(reported), -1};
    shown.smoothness = certified_smoothness(reported, shown.point);
    if (shown.smoothness >= 1) result.push_back(std::move(shown));
  }
  return result;
}

/// Refined polygons as panels in one scale, with combs of one scale.
struct Panels {
  struct One {
    std::string title;
    Polygon refined;
  };
  const Polygon& data;
  std::vector<One> all;

  void add_to(Figure& figure, double width, double height) const {
    std::vector<double> typical;
    for (const One& one : all) {
      if (const double size = typical_curvature(one.refined); size > 0) typical.push_back(size);
    }
    if (typical.empty()) return;
    std::nth_element(typical.begin(), typical.begin() + static_cast<std::ptrdiff_t>(typical.size() / 2), typical.end());
    const double common = typical[typical.size() / 2];
    const std::size_t first = figure.panels.size();
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (const One& one : all) {
      Figure::Panel panel = comb_panel(data, one.refined, common);
      panel.plot.title = one.title;
      panel.plot.width = width;
      panel.plot.height = height;
      const auto see = [&](const std::vector<PlotPoint>& points) {
        for (const PlotPoint& p : points) {
          low[0] = std::min(low[0], p.x), high[0] = std::max(high[0], p.x);
          low[1] = std::min(low[1], p.y), high[1] = std::max(high[1], p.y);
        }
      };
      for (const PlotItem& item : panel.plot.items) {
        if (const auto* curve = std::get_if<PlotCurve>(&item)) see(curve->points);
        if (const auto* comb = std::get_if<PlotComb>(&item)) see(comb->tips);
      }
      figure.panels.push_back(std::move(panel));
    }
    for (std::size_t k = first; k < figure.panels.size(); ++k) {
      Plot& plot = figure.panels[k].plot;
      plot.x.lower = low[0], plot.x.upper = high[0];
      plot.y.lower = low[1], plot.y.upper = high[1];
    }
  }
};

std::string title_of(const Scheme& scheme, const std::vector<Rational>& point) {
  return scheme.parameters.empty() ? scheme.name : fmt::format("{}, ${}$", scheme.name, point_latex(scheme.parameter_names(), point));
}

constexpr const char* comb_words = "The combs have one scale; teeth beyond $2.5$ times a typical length are cut off.";

/// Uniform schemes on one polygon, a page of them at most in a figure.
Blocks gallery(const std::vector<Shown>& shown, const std::filesystem::path& polygons, const Stop& stop) {
  const std::optional<Polygon> data = polygon_of(polygons, "beetle.csv", true);
  std::vector<const Shown*> uniform;
  for (const Shown& one : shown) {
    if (!one.scheme().insertion_rule) uniform.push_back(&one);
  }
  constexpr std::size_t most = 15;
  Blocks blocks;
  if (!data || uniform.size() < 2) return blocks;
  for (std::size_t begin = 0; begin < uniform.size(); begin += most) {
    const std::size_t end = std::min(begin + most, uniform.size());
    Panels panels{*data, {}};
    for (std::size_t k = begin; k < end; ++k) {
      const Shown& one = *uniform[k];
      panels.all.push_back({title_of(one.scheme(), one.point), refined_at(one.scheme(), one.point, *data, levels_of(one.scheme()), stop)});
    }
    Figure figure{.name = fmt::format("comparison-uniform-{}", begin / most + 1), .panels = {}, .caption = {}, .columns = 3};
    panels.add_to(figure, 140, 92);
    if (figure.panels.empty()) continue;
    figure.caption = rich(fmt::format("One closed polygon by uniform schemes, with curvature combs. {}", comb_words));
    blocks.push_back(std::move(figure));
  }
  return blocks;
}

/// Schemes whose rules are the same for equal knot intervals.
struct Family {
  std::vector<const Shown*> members;
  /// The member that is uniform, if there is one.
  const Shown* uniform = nullptr;
};

std::vector<Family> families_of(const std::vector<Shown>& shown) {
  std::vector<Family> families;
  for (const Shown& one : shown) {
    const auto same = [&](const Family& family) {
      const Scheme& other = family.members.front()->scheme();
      return other.parameters.size() == one.scheme().parameters.size() && other.mask.arity == one.scheme().mask.arity && other.mask.symbol == one.scheme().mask.symbol;
    };
    auto family = std::find_if(families.begin(), families.end(), same);
    if (family == families.end()) family = families.insert(families.end(), Family{});
    family->members.push_back(&one);
    if (!one.scheme().insertion_rule && !family->uniform) family->uniform = &one;
  }
  std::erase_if(families, [](const Family& family) {
    return std::none_of(family.members.begin(), family.members.end(), [](const Shown* one) { return one->scheme().insertion_rule.has_value(); });
  });
  return families;
}

/// The value at which the members are smoothest, all in all.
std::vector<Rational> common_point(const Family& family) {
  const std::vector<Rational>* best = nullptr;
  int most = -1;
  for (const Shown* candidate : family.members) {
    int sum = 0;
    for (const Shown* one : family.members) {
      // Of two such values rather the one that files name.
      sum += 100 * certified_smoothness(*one->reported, candidate->point);
      sum += static_cast<int>(std::count_if(one->reported->claims.begin(), one->reported->claims.end(), [&](const DecidedClaim& decided) {
        return is_point(decided.claim.region) && midpoint(decided.claim.region) == candidate->point;
      }));
    }
    if (sum > most) most = sum, best = &candidate->point;
  }
  return *best;
}

Figure family_figure(const Family& family, const std::string& name, const std::vector<const char*>& files, const std::filesystem::path& polygons, const Stop& stop) {
  const std::vector<Rational> point = common_point(family);
  const Scheme& first = family.members.front()->scheme();
  Figure figure{.name = name, .panels = {}, .caption = {}, .columns = 3};
  for (const char* file : files) {
    const std::optional<Polygon> data = polygon_of(polygons, file, true);
    if (!data) continue;
    Panels panels{*data, {}};
    panels.all.push_back({family.uniform ? family.uniform->scheme().name : "equal intervals", refine_polygon(*data, approx_uniform_rule(first.mask, point), {.levels = levels_of(first)}, stop)});
    for (const Shown* one : family.members) {
      if (!one->scheme().insertion_rule || certified_smoothness(*one->reported, point) < 1) continue;
      panels.all.push_back({one->scheme().name, refined_at(one->scheme(), point, *data, levels_of(one->scheme()), stop)});
    }
    if (panels.all.size() == 2) figure.columns = 2;
    const bool small = panels.all.size() <= 3;  // two figures on a page
    panels.add_to(figure, small ? 122 : 140, small ? 66 : 80);
  }
  const std::string where = first.parameters.empty() ? "" : fmt::format(" for ${}$", point_latex(first.parameter_names(), point));
  figure.caption = rich(fmt::format("Uniform and non-uniform schemes with the same rule for equal intervals{}; the non-uniform ones over centripetal knots. {}", where, comb_words));
  return figure;
}

/// The side of a square by interpolatory schemes.
std::optional<Figure> square_sides(const std::vector<Shown>& shown, const std::filesystem::path& polygons, const Stop& stop) {
  const std::optional<Polygon> data = polygon_of(polygons, "square.csv", true);
  if (!data) return std::nullopt;
  Plot whole, side;
  whole.frame = false;
  whole.equal_aspect = true;
  whole.width = whole.height = 130;
  side.width = 200;
  side.height = 130;
  side.x.label = "$x$";
  side.y.label = "$y$";
  std::vector<PlotPoint> corners;
  for (std::size_t i = 0; i < data->size(); ++i) corners.push_back({(*data)[i][0], (*data)[i][1]});
  whole.items.push_back(PlotCurve{corners, {{150, 150, 150}, 0.4, Dash::dashed}, true});
  std::string curves = "scheme,x,y\n", sides = "scheme,x,y\n";
  std::vector<LaurentPolynomial> masks;
  std::size_t colour = 0;
  constexpr std::size_t most = 6;
  for (const Shown& one : shown) {
    if (one.scheme().insertion_rule || one.scheme().mask.arity != 2 || colour == most) continue;
    const Mask mask = at(one.scheme().mask, one.point);
    if (prove_stability(mask) != Stability::interpolatory || std::find(masks.begin(), masks.end(), mask.symbol) != masks.end()) continue;
    masks.push_back(mask.symbol);
    const Polygon refined = refined_at(one.scheme(), one.point, *data, 6, stop);
    std::vector<PlotPoint> curve, middle;
    for (std::size_t i = 0; i < refined.size(); ++i) {
      curve.push_back({refined[i][0], refined[i][1]});
      curves += fmt::format("{},{:.9g},{:.9g}\n", one.scheme().name, curve.back().x, curve.back().y);
      const double length = corners[1].x - corners[0].x, x = curve.back().x - corners[0].x;
      if (i > refined.size() / data->size() || x < length / 5 || x > length * 4 / 5) continue;
      middle.push_back(curve.back());
      sides += fmt::format("{},{:.9g},{:.9g}\n", one.scheme().name, middle.back().x, middle.back().y);
    }
    if (middle.empty()) continue;
    const Stroke stroke{palette(++colour), 0.8, Dash::solid};
    whole.items.push_back(PlotCurve{std::move(curve), stroke, true});
    side.items.push_back(PlotCurve{std::move(middle), stroke, false, title_of(one.scheme(), one.point)});
  }
  if (colour < 2) return std::nullopt;
  return Figure{.name = "comparison-square",
                .panels = {{std::move(whole), curves}, {std::move(side), sides}},
                .caption = rich("A square after six steps of interpolatory schemes, and the middle of its lower side with the vertical scale stretched.")};
}

}  // namespace

Blocks comparisons(const std::vector<ReportedScheme>& schemes, const ProofReportOptions& options, const Stop& stop) {
  if (options.polygons.empty()) return {};
  const std::vector<Shown> shown = curve_schemes(schemes);
  if (shown.size() < 2) return {};
  Blocks blocks = gallery(shown, options.polygons, stop);
  if (auto figure = square_sides(shown, options.polygons, stop)) blocks.push_back(std::move(*figure));
  for (const Family& family : families_of(shown)) {
    try {
      const std::string name = "comparison-" + (family.uniform ? family.uniform : family.members.front())->scheme().name;
      Figure figure = family_figure(family, name, {"beetle.csv", "letter-t.csv", "letter-t-bevelled.csv"}, options.polygons, stop);
      if (!figure.panels.empty()) blocks.push_back(std::move(figure));
    } catch (const DomainError&) {
      // A pole at the common value.
    }
  }
  if (blocks.empty()) return {};
  Blocks section{Heading{1, rich("Comparisons"), "comparisons"},
                 paragraph("The same polygons by several schemes, at parameter values for which the smoothness is certified. The curves are computed in floating point; nothing is proved by them.")};
  append(section, std::move(blocks));
  return section;
}

}  // namespace limes::report_impl
