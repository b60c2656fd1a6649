#include "reports/plot/layout_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace limes {
namespace {

using namespace plot_impl;

std::string number(double value) { return fmt::format("{:.9g}", value + 0.0); }

std::string rgb(Color c) { return fmt::format("{{rgb,255:red,{};green,{};blue,{}}}", c.red, c.green, c.blue); }

std::string stroke_options(const Stroke& stroke) {
  const char* dash = stroke.dash == Dash::dashed ? ", dashed" : stroke.dash == Dash::dotted ? ", dotted" : "";
  return fmt::format("draw={}, line width={}pt, line join=round{}", rgb(stroke.color), number(stroke.width), dash);
}

/// Lines of several coordinates: TeX reads long lines slowly.
std::string coordinates(const std::vector<PlotPoint>& points) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("{}({},{})", i % 4 == 0 ? "\n    " : " ", number(points[i].x), number(points[i].y));
  }
  return text;
}

/// Writes the items of one plot.
class Writer {
 public:
  Writer(const Layout& area, std::string& text) : area_(area), text_(text) {}

  void operator()(const PlotCurve& curve) {
    add(stroke_options(curve.stroke), curve.points, curve.closed, curve.legend);
  }
  void operator()(const PlotMarkers& markers) {
    const std::string color = rgb(markers.color);
    const std::string options =
        fmt::format("only marks, mark=*, mark size={}pt, mark options={{draw={}, fill={}, line width=0pt}}",
                    number(markers.radius), color, color);
    plot(options, markers.points, "", markers.legend);
  }
  void operator()(const PlotRegion& region) {
    bool first = true;
    for (const auto& outline : region.outlines) {
      plot(fmt::format("fill={}, draw=none, area legend", rgb(region.fill)), outline, " -- cycle",
           first ? region.legend : "");
      first = false;
    }
  }
  void operator()(const PlotComb& comb) {
    const Stroke teeth{lighter(comb.stroke.color, 0.5), comb.stroke.width / 2, Dash::solid};
    // One plot with gaps: much faster in TeX than separate lines.
    if (!comb.feet.empty()) text_ += fmt::format("  \\addplot[{}, unbounded coords=jump, forget plot] coordinates {{", stroke_options(teeth));
    for (std::size_t i = 0; i < comb.feet.size(); i += std::max<std::size_t>(comb.every, 1)) {
      const PlotPoint& a = comb.feet[i];
      const PlotPoint& b = comb.tips[i];
      text_ += fmt::format("\n    ({},{}) ({},{}) (nan,nan)", number(a.x), number(a.y), number(b.x), number(b.y));
    }
    if (!comb.feet.empty()) text_ += "\n  };\n";
    add(stroke_options(comb.stroke), comb.tips, comb.closed, comb.legend);
  }
  void operator()(const PlotLabel& label) {
    using Anchor = PlotLabel::Anchor;
    const char* anchor = label.anchor == Anchor::left    ? "east"
                         : label.anchor == Anchor::right ? "west"
                         : label.anchor == Anchor::above ? "south"
                         : label.anchor == Anchor::below ? "north"
                                                         : "center";
    labels_ += fmt::format("  \\node[anchor={}, font=\\small] at (axis cs:{},{}) {{{}}};\n", anchor, number(label.at.x),
                           number(label.at.y), tex_text(label.text));
  }
  void finish() { text_ += labels_; }

 private:
  void add(const std::string& options, const std::vector<PlotPoint>& points, bool closed, const std::string& legend) {
    plot(options, simplified(points, area_, closed), closed ? " -- cycle" : "", legend);
  }
  void plot(const std::string& options, const std::vector<PlotPoint>& points, const std::string& end,
            const std::string& legend) {
    if (points.empty()) return;
    text_ += fmt::format("  \\addplot[{}{}] coordinates {{{}\n  }}{};\n", options,
                         legend.empty() ? ", forget plot" : "", coordinates(points), end);
    if (!legend.empty()) text_ += fmt::format("  \\addlegendentry{{{}}}\n", tex_text(legend));
  }

  const Layout& area_;
  std::string& text_;
  std::string labels_;
};

/// Ticks as the other writers have them: pgfplots puts powers such as 10^{-0.5} on short logarithmic axes.
std::string tick_options(const char* axis, const Scale& scale) {
  std::vector<std::string> values, texts;
  for (const PlotTick& tick : scale.ticks) {
    values.push_back(number(tick.value));
    texts.push_back(tick.text.find('$') == std::string::npos ? fmt::format("${}$", tick.text) : tick.text);
  }
  return fmt::format("  {0}tick={{{1}}}, {0}ticklabels={{{2}}}, minor {0} tick num=0,\n", axis, fmt::join(values, ","), fmt::join(texts, ","));
}

std::string axis_options(const Plot& plot, const Layout& area) {
  const auto size = [](double points) { return decimals(points, 2); };
  std::string text = fmt::format("  scale only axis, width={}bp, height={}bp,\n  xmin={}, xmax={}, ymin={}, ymax={},\n",
                                 size(area.width), size(area.height), number(area.x.lower), number(area.x.upper),
                                 number(area.y.lower), number(area.y.upper));
  if (plot.x.logarithmic) text += "  xmode=log,\n";
  if (plot.y.logarithmic) text += "  ymode=log,\n";
  if (plot.x.logarithmic || plot.x.ticks) text += tick_options("x", area.x);
  if (plot.y.logarithmic || plot.y.ticks) text += tick_options("y", area.y);
  if (!plot.title.empty()) text += fmt::format("  title={{{}}},\n", tex_text(plot.title));
  if (!plot.frame) return text + "  hide axis,\n";
  if (!plot.x.label.empty()) text += fmt::format("  xlabel={{{}}},\n", tex_text(plot.x.label));
  if (!plot.y.label.empty()) text += fmt::format("  ylabel={{{}}},\n", tex_text(plot.y.label));
  return text;
}

}  // namespace

std::string plot_impl::tex_text(const std::string& text) {
  const bool has_mathematics = std::count(text.begin(), text.end(), '$') % 2 == 0;
  bool mathematics = false;
  std::string result;
  for (const char c : text) {
    if (c == '$' && has_mathematics) {
      mathematics = !mathematics;
      result += c;
    } else if (mathematics || static_cast<unsigned char>(c) < 0x20) {
      if (mathematics) result += c;
    } else if (c == '\\') {
      result += "\\textbackslash{}";
    } else if (c == '<' || c == '>' || c == '|') {
      result += c == '<' ? "\\textless{}" : c == '>' ? "\\textgreater{}" : "\\textbar{}";
    } else if (c == '~' || c == '^') {
      result += fmt::format("\\{}{{}}", c);
    } else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) {
      result += {'\\', c};
    } else {
      result += c;
    }
  }
  return result;
}

std::string to_pgf(const Plot& plot) {
  const Layout area = layout(plot);
  std::string text =
      "% \\usepackage{pgfplots} in the preamble, then \\input this file.\n\\begin{tikzpicture}[baseline=0pt]\n\\begin{axis}[\n";
  text += axis_options(plot, area);
  text += "  tick align=outside, tick pos=left,\n  legend pos=outer north east, legend cell align=left,\n]\n";
  Writer writer(area, text);
  for (const PlotItem& item : plot.items) std::visit(writer, item);
  writer.finish();
  return text + "\\end{axis}\n\\end{tikzpicture}\n";
}

}  // namespace limes
