#include "reports/plot/layout_impl.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace limes {

Color palette(std::size_t k) {
  constexpr std::array<Color, 8> colors{{{0, 0, 0},
                                         {0, 114, 178},
                                         {213, 94, 0},
                                         {0, 158, 115},
                                         {204, 121, 167},
                                         {230, 159, 0},
                                         {86, 180, 233},
                                         {240, 228, 66}}};
  return colors[k % colors.size()];
}

Color lighter(Color color, double strength) {
  const auto mix = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::lround(255 - strength * (255 - c))); };
  return {mix(color.red), mix(color.green), mix(color.blue)};
}

namespace plot_impl {
namespace {

/// The least and the greatest number seen.
struct Extent {
  double lower = std::numeric_limits<double>::infinity(), upper = -std::numeric_limits<double>::infinity();
  void add(double value, const PlotAxis& axis) {
    if (!std::isfinite(value)) throw DomainError("a plot has a point that is not finite");
    if (axis.logarithmic && value <= 0)
      throw DomainError("a logarithmic axis has no place for numbers that are not positive");
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
};

/// Calls visit(point) for every point of the plot.
template <class Visit>
void for_each_point(const Plot& plot, Visit visit) {
  const auto all = [&](const std::vector<PlotPoint>& points) {
    for (const PlotPoint& p : points) visit(p);
  };
  for (const PlotItem& item : plot.items) {
    if (const auto* curve = std::get_if<PlotCurve>(&item)) all(curve->points);
    if (const auto* markers = std::get_if<PlotMarkers>(&item)) all(markers->points);
    if (const auto* label = std::get_if<PlotLabel>(&item)) visit(label->at);
    if (const auto* region = std::get_if<PlotRegion>(&item))
      for (const auto& outline : region->outlines) all(outline);
    if (const auto* comb = std::get_if<PlotComb>(&item)) {
      if (comb->feet.size() != comb->tips.size()) throw DomainError("a comb needs one tip for each foot");
      all(comb->feet);
      all(comb->tips);
    }
  }
}

/// Ends as given, the others from the extent, widened by a twentieth.
Scale ends(const PlotAxis& axis, const Extent& extent) {
  Scale scale{axis.logarithmic ? 1.0 : 0.0, axis.logarithmic ? 10.0 : 1.0, axis.logarithmic, {}};
  if (extent.lower <= extent.upper) {
    double lower = extent.lower, upper = extent.upper;
    if (axis.logarithmic) {
      const double factor = std::max(std::pow(upper / lower, 0.05), 1.1);
      scale.lower = lower / factor;
      scale.upper = upper * factor;
    } else {
      const double size = std::max(std::abs(lower), std::abs(upper));
      const double margin = std::max(0.05 * (upper - lower), upper - lower > 1e-12 * size ? 0.0
                                                             : size > 0                   ? 0.1 * size
                                                                                          : 1.0);
      scale.lower = lower - margin;
      scale.upper = upper + margin;
    }
  }
  if (axis.lower) scale.lower = *axis.lower;
  if (axis.upper) scale.upper = *axis.upper;
  const bool positive = !axis.logarithmic || scale.lower > 0;
  if (!std::isfinite(scale.lower) || !std::isfinite(scale.upper) || !(scale.lower < scale.upper) || !positive ||
      !std::isfinite(scale.upper - scale.lower)) {
    throw DomainError(fmt::format("an axis cannot go from {} to {}", scale.lower, scale.upper));
  }
  return scale;
}

/// Multiples of 1, 2 or 5 times a power of ten; `wanted` of them, more or less.
void linear_ticks(Scale& scale, double wanted) {
  const double span = scale.upper - scale.lower;
  double step = std::pow(10, std::floor(std::log10(span / wanted)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (span / step > wanted) step *= factor;
  }
  const double first = std::ceil(scale.lower / step - 1e-9), last = std::floor(scale.upper / step + 1e-9);
  if (!(step > 0) || !(last - first < 100) || std::abs(first) > 1e15) return;  // too narrow for double precision
  const double largest = std::max(std::abs(scale.lower), std::abs(scale.upper));
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  for (double k = first; k <= last; ++k) {
    const double value = k * step;
    scale.ticks.push_back(
        {value, largest >= 1e5 || digits > 5 ? fmt::format("{:.6g}", value + 0.0) : decimals(value, digits)});
  }
}

/// Powers of ten, not all of them over many decades; within less than one decade also 2 and 5 times them.
void logarithmic_ticks(Scale& scale) {
  const double lower = std::log10(scale.lower), upper = std::log10(scale.upper);
  const double stride = std::max(1.0, std::ceil((upper - lower) / 8));
  for (double decade = std::floor(lower); decade <= upper + 1e-9; ++decade) {
    if (std::fmod(decade, stride) != 0) continue;
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor > 1 && upper - lower > 1.5) continue;
      const double value = factor * std::pow(10, decade);
      if (value < scale.lower * (1 - 1e-9) || value > scale.upper * (1 + 1e-9)) continue;
      scale.ticks.push_back({value, fmt::format("{:.6g}", value)});
    }
  }
}

}  // namespace

double Scale::place(double value) const {
  if (logarithmic) return std::log(value / lower) / std::log(upper / lower);
  return (value - lower) / (upper - lower);
}

Layout layout(const Plot& plot) {
  if (!(plot.width >= 10 && plot.width <= 10000 && plot.height >= 10 && plot.height <= 10000)) {
    throw DomainError("the size of a plot must lie between 10 and 10000 points");
  }
  if (plot.equal_aspect && (plot.x.logarithmic || plot.y.logarithmic)) {
    throw DomainError("equal units need two linear axes");
  }
  Extent x, y;
  for_each_point(plot, [&](const PlotPoint& p) {
    x.add(p.x, plot.x);
    y.add(p.y, plot.y);
  });
  Layout result{ends(plot.x, x), ends(plot.y, y), plot.width, plot.height};
  if (plot.equal_aspect) {
    // The longer side fills the area, the other one shrinks, but not to less than an eighth: then its axis grows
    // instead.
    const double unit =
        std::min(plot.width / (result.x.upper - result.x.lower), plot.height / (result.y.upper - result.y.lower));
    const auto fit = [&](Scale& scale, double& size) {
      const double least = size / 8, used = unit * (scale.upper - scale.lower);
      size = std::max(least, used);
      if (used >= least) return;
      const double more = (least / unit - (scale.upper - scale.lower)) / 2;
      scale.lower -= more;
      scale.upper += more;
    };
    fit(result.x, result.width);
    fit(result.y, result.height);
  }
  for (Scale* scale : {&result.x, &result.y}) {
    if (const auto& given = scale == &result.x ? plot.x.ticks : plot.y.ticks)
      scale->ticks = *given;
    else if (scale->logarithmic)
      logarithmic_ticks(*scale);
    else {
      const double wanted = scale == &result.x ? std::max(4.0, result.width / 60) : std::max(5.0, result.height / 45);
      linear_ticks(*scale, wanted);
      if (scale->ticks.size() < 2) {  // one tick tells no scale
        scale->ticks.clear();
        linear_ticks(*scale, 2 * wanted);
      }
    }
  }
  return result;
}

std::vector<PlotPoint> simplified(const std::vector<PlotPoint>& points, const Layout& layout, bool closed,
                                  double tolerance) {
  if (points.size() < 3) return points;
  std::vector<PlotPoint> places;
  for (const PlotPoint& p : points)
    places.push_back({layout.width * layout.x.place(p.x), layout.height * layout.y.place(p.y)});
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  // A closed curve is cut into two at its middle, so that the first chord is not a point.
  std::vector<std::pair<std::size_t, std::size_t>> work{{0, points.size() - 1}};
  if (closed) {
    kept[points.size() / 2] = true;
    work = {{points.size() / 2, points.size() - 1}, {0, points.size() / 2}};
  }
  while (!work.empty()) {
    const auto [first, last] = work.back();
    work.pop_back();
    const PlotPoint a = places[first], b = places[last];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      // Distance from the segment, not the line: where a curve turns back the turning point stays.
      const double px = places[i].x - a.x, py = places[i].y - a.y;
      const double t = length > 0 ? std::clamp((px * dx + py * dy) / (length * length), 0.0, 1.0) : 0.0;
      const double gap = std::hypot(px - t * dx, py - t * dy);
      if (gap > worst) {
        worst = gap;
        at = i;
      }
    }
    if (at == first) continue;
    kept[at] = true;
    work.push_back({at, last});
    work.push_back({first, at});
  }
  std::vector<PlotPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) result.push_back(points[i]);
  }
  return result;
}

std::vector<LegendEntry> legend(const Plot& plot) {
  std::vector<LegendEntry> entries;
  for (const PlotItem& item : plot.items) {
    const std::string* text = std::visit(
        [](const auto& what) -> const std::string* {
          if constexpr (requires { what.points; })
            return what.points.empty() ? nullptr : &what.legend;
          else if constexpr (requires { what.feet; })
            return what.feet.empty() ? nullptr : &what.legend;
          else if constexpr (requires { what.outlines; })
            return what.outlines.empty() ? nullptr : &what.legend;
          else
            return nullptr;
        },
        item);
    if (text && !text->empty()) entries.push_back({*text, &item});
  }
  return entries;
}

std::string plain_text(const std::string& text, bool greek) {
  static const std::vector<std::pair<std::string, std::string>> letters{
      {"alpha", "α"},  {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"}, {"theta", "θ"}, {"kappa", "κ"},
      {"lambda", "λ"}, {"mu", "μ"},   {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"},   {"phi", "φ"},   {"omega", "ω"},
      {"varphi", "φ"}};
  std::string result;
  bool mathematics = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '$') {
      mathematics = !mathematics;
      continue;
    }
    if (mathematics && (text[i] == '{' || text[i] == '}')) continue;  // of exponents
    if (text[i] != '\\') {
      result += text[i];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') || (text[end] >= 'A' && text[end] <= 'Z')))
      ++end;
    const std::string name = text.substr(i + 1, end - i - 1);
    const auto letter =
        std::find_if(letters.begin(), letters.end(), [&](const auto& entry) { return entry.first == name; });
    result += greek && letter != letters.end() ? letter->second : name;
    if (end > i + 1) i = end - 1;
  }
  return result;
}

std::string decimals(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace plot_impl
}  // namespace limes
