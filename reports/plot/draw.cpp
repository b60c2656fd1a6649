#include "reports/plot/canvas_impl.hpp"
#include "reports/plot/vector_font_impl.hpp"

#include <algorithm>

namespace limes::plot_impl {
namespace {

constexpr double tick_length = 4, gap = 4, sample_width = 22;
constexpr Color ink{40, 40, 40};
/// Fonts that may show an SVG are wider than ours.
constexpr double safety = 1.2;

double widest(const std::vector<PlotTick>& ticks, double text_size) {
  double width = 0;
  for (const PlotTick& tick : ticks) width = std::max(width, text_width(plain_text(tick.text, false), text_size));
  return safety * width;
}

double legend_width(const Plot& plot, double text_size) {
  double width = 0;
  for (const LegendEntry& entry : legend(plot)) {
    width = std::max(width, sample_width + gap + safety * text_width(plain_text(entry.text, false), text_size));
  }
  return width;
}

/// Draws the items of one plot.
class Painter {
 public:
  Painter(const Layout& layout, const Page& page, Canvas& canvas) : layout_(layout), page_(page), canvas_(canvas) {}

  /// What is very far outside of the picture is moved nearer: no number becomes long and no loop either.
  PlotPoint place(const PlotPoint& p) const {
    const auto near = [](double value) { return std::clamp(value, -1e6, 1e6); };
    return {near(page_.left + layout_.width * layout_.x.place(p.x)),
            near(page_.top + layout_.height * (1 - layout_.y.place(p.y)))};
  }
  std::vector<PlotPoint> places(const std::vector<PlotPoint>& points) const {
    std::vector<PlotPoint> result;
    for (const PlotPoint& p : points) result.push_back(place(p));
    return result;
  }

  void operator()(const PlotCurve& curve) const {
    canvas_.polyline(places(simplified(curve.points, layout_, curve.closed)), curve.closed, curve.stroke);
  }
  void operator()(const PlotMarkers& markers) const {
    canvas_.discs(places(markers.points), markers.radius, markers.color);
  }
  void operator()(const PlotRegion& region) const {
    std::vector<std::vector<PlotPoint>> outlines;
    for (const auto& outline : region.outlines) outlines.push_back(places(outline));
    canvas_.fill(outlines, region.fill);
  }
  void operator()(const PlotComb& comb) const {
    std::vector<PlotPoint> ends;
    for (std::size_t i = 0; i < comb.feet.size(); i += std::max<std::size_t>(comb.every, 1)) {
      ends.push_back(place(comb.feet[i]));
      ends.push_back(place(comb.tips[i]));
    }
    canvas_.segments(ends, {lighter(comb.stroke.color, 0.5), comb.stroke.width / 2, Dash::solid});
    canvas_.polyline(places(simplified(comb.tips, layout_, comb.closed)), comb.closed, comb.stroke);
  }
  void operator()(const PlotLabel& label) const {
    PlotPoint at = place(label.at);
    TextAlign align = TextAlign::middle;
    using Anchor = PlotLabel::Anchor;
    const double text_size = page_.style.text;
    if (label.anchor == Anchor::left) align = TextAlign::end, at.x -= gap;
    if (label.anchor == Anchor::right) align = TextAlign::start, at.x += gap;
    if (label.anchor == Anchor::above)
      at.y -= gap;
    else
      at.y += label.anchor == Anchor::below ? gap + 0.7 * text_size : 0.35 * text_size;
    canvas_.text(at, label.text, text_size, align, false);
  }

 private:
  const Layout& layout_;
  const Page& page_;
  Canvas& canvas_;
};

void draw_frame(const Plot& plot, const Layout& layout, const Page& page, Canvas& canvas) {
  const double right = page.left + layout.width, bottom = page.top + layout.height, text_size = page.style.text;
  const Stroke line{ink, page.style.line, Dash::solid};
  canvas.polyline({{page.left, page.top}, {right, page.top}, {right, bottom}, {page.left, bottom}}, true, line);
  std::vector<PlotPoint> marks;
  for (const PlotTick& tick : layout.x.ticks) {
    const double x = page.left + layout.width * layout.x.place(tick.value);
    marks.insert(marks.end(), {{x, bottom}, {x, bottom + tick_length}});
    canvas.text({x, bottom + tick_length + gap + 0.7 * text_size}, tick.text, text_size, TextAlign::middle, false);
  }
  for (const PlotTick& tick : layout.y.ticks) {
    const double y = page.top + layout.height * (1 - layout.y.place(tick.value));
    marks.insert(marks.end(), {{page.left - tick_length, y}, {page.left, y}});
    canvas.text({page.left - tick_length - gap, y + 0.35 * text_size}, tick.text, text_size, TextAlign::end, false);
  }
  canvas.segments(marks, line);
  const double x_label = bottom + tick_length + 2 * gap + 1.7 * text_size;
  if (!plot.x.label.empty())
    canvas.text({page.left + layout.width / 2, x_label}, plot.x.label, text_size, TextAlign::middle, false);
  if (!plot.y.label.empty()) {
    canvas.text({page.style.border + 0.8 * text_size, page.top + layout.height / 2}, plot.y.label, text_size, TextAlign::middle,
                true);
  }
}

void draw_legend(const Plot& plot, const Layout& layout, const Page& page, Canvas& canvas) {
  const double left = page.left + layout.width + 3 * gap, text_size = page.style.text;
  double y = page.top + text_size;
  for (const LegendEntry& entry : legend(plot)) {
    const std::vector<PlotPoint> sample{{left, y - 0.35 * text_size}, {left + sample_width, y - 0.35 * text_size}};
    if (const auto* curve = std::get_if<PlotCurve>(entry.item)) canvas.polyline(sample, false, curve->stroke);
    if (const auto* comb = std::get_if<PlotComb>(entry.item)) canvas.polyline(sample, false, comb->stroke);
    if (const auto* markers = std::get_if<PlotMarkers>(entry.item)) {
      canvas.discs({{left + sample_width / 2, sample[0].y}}, markers->radius, markers->color);
    }
    if (const auto* region = std::get_if<PlotRegion>(entry.item)) {
      const double top = y - 0.8 * text_size, right = left + sample_width;
      canvas.fill({{{left, top}, {right, top}, {right, y}, {left, y}}}, region->fill);
    }
    canvas.text({left + sample_width + gap, y}, entry.text, text_size, TextAlign::start, false);
    y += 1.4 * text_size;
  }
}

}  // namespace

Page page(const Plot& plot, const Layout& layout, const PageStyle& style) {
  const double text_size = style.text, title_size = style.title, border = style.border;
  Page result{2 * border + layout.width, 2 * border + layout.height, border, border, style};
  double right = 0;
  if (plot.frame) {
    const double below = tick_length + gap + text_size + (plot.x.label.empty() ? 0 : gap + text_size);
    const double beside =
        tick_length + gap + widest(layout.y.ticks, text_size) + (plot.y.label.empty() ? 0 : gap + 1.2 * text_size);
    result.left += beside;
    result.width += beside;
    result.height += below;
    // The last tick's text may reach beyond the frame.
    if (!layout.x.ticks.empty()) {
      const double reach = layout.width * layout.x.place(layout.x.ticks.back().value) +
                           safety * text_width(plain_text(layout.x.ticks.back().text, false), text_size) / 2;
      right = std::max(0.0, reach - layout.width);
    }
  }
  if (!plot.title.empty()) {
    result.top += title_size + 2 * gap;
    result.height += title_size + 2 * gap;
    // The title stands over the middle of the area.
    const double beyond = (safety * text_width(plain_text(plot.title, false), title_size) - layout.width) / 2;
    right = std::max(right, beyond);
    if (beyond > result.left - border) {
      result.width += beyond - (result.left - border);
      result.left = border + beyond;
    }
  }
  if (const double width = legend_width(plot, text_size); width > 0) {
    right = std::max(right, 3 * gap + width);
    result.height =
        std::max(result.height, result.top + 1.4 * text_size * static_cast<double>(legend(plot).size()) + border);
  }
  result.width += right;
  return result;
}

void draw(const Plot& plot, const Layout& layout, const Page& page, Canvas& canvas) {
  canvas.clip(page.left, page.top, layout.width, layout.height);
  const Painter painter(layout, page, canvas);
  for (const PlotItem& item : plot.items) {
    if (!std::holds_alternative<PlotLabel>(item)) std::visit(painter, item);
  }
  canvas.unclip();
  for (const PlotItem& item : plot.items) {
    if (std::holds_alternative<PlotLabel>(item)) std::visit(painter, item);
  }
  if (plot.frame) draw_frame(plot, layout, page, canvas);
  if (!plot.title.empty()) {
    canvas.text({page.left + layout.width / 2, page.top - 2 * gap}, plot.title, page.style.title, TextAlign::middle, false);
  }
  draw_legend(plot, layout, page, canvas);
}

}  // namespace limes::plot_impl
