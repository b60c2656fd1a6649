#pragma once

#include "reports/plot/layout_impl.hpp"

namespace limes::plot_impl {

/// Where a text is fixed: its left end, middle or right end, on the base line.
enum class TextAlign { start, middle, end };

/// What a picture can be drawn on. Units are points of paper, x to the right, y downwards, colours are opaque.
class Canvas {
 public:
  virtual ~Canvas() = default;
  /// From here on only the inside of the rectangle is drawn to, until the next call; without sizes everywhere.
  virtual void clip(double x, double y, double width, double height) = 0;
  virtual void unclip() = 0;
  virtual void polyline(const std::vector<PlotPoint>& points, bool closed, const Stroke& stroke) = 0;
  /// Separate segments, points 0-1, 2-3, ..
  virtual void segments(const std::vector<PlotPoint>& ends, const Stroke& stroke) = 0;
  virtual void fill(const std::vector<std::vector<PlotPoint>>& outlines, Color color) = 0;
  virtual void discs(const std::vector<PlotPoint>& centres, double radius, Color color) = 0;
  virtual void text(PlotPoint at, const std::string& text, double size, TextAlign align, bool upwards) = 0;
};

/// Sizes of what stands around the area, in points.
struct PageStyle {
  double text = 11, title = 13, border = 8, line = 0.75;
};

/// Size of the whole picture, with title, ticks, labels and legend around the area, and the corner of the area in it.
struct Page {
  double width = 0, height = 0;
  double left = 0, top = 0;
  PageStyle style = {};
};
Page page(const Plot& plot, const Layout& layout, const PageStyle& style = {});

void draw(const Plot& plot, const Layout& layout, const Page& page, Canvas& canvas);

}  // namespace limes::plot_impl
