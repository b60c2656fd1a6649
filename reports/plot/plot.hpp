#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace limes {

/// A colour of the screen, opaque.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Color&, const Color&) = default;
};

/// The k-th of eight colours that also colour-blind readers tell apart (Okabe and Ito), from black on; cyclic.
Color palette(std::size_t k);
/// A mixture with white: strength 1 is the colour, 0 is white.
Color lighter(Color color, double strength);

/// A point in the units of the axes.
struct PlotPoint {
  double x = 0, y = 0;
  friend bool operator==(const PlotPoint&, const PlotPoint&) = default;
};

enum class Dash { solid, dashed, dotted };

struct Stroke {
  Color color;
  /// in points (1/72 inch)
  double width = 1;
  Dash dash = Dash::solid;
};

/// What a plot shows. An entry in the legend needs a text.

/// A polyline.
struct PlotCurve {
  std::vector<PlotPoint> points;
  Stroke stroke;
  bool closed = false;
  std::string legend = {};
};

/// Round markers.
struct PlotMarkers {
  std::vector<PlotPoint> points;
  Color color;
  /// in points (1/72 inch)
  double radius = 2;
  std::string legend = {};
};

/// Filled polygons, for example the cells of a parameter box; without an outline, so that neighbours leave no seam.
struct PlotRegion {
  std::vector<std::vector<PlotPoint>> outlines;
  Color fill;
  std::string legend = {};
};

/// Teeth from feet to tips, and a curve through the tips. Every `every`-th tooth is drawn.
struct PlotComb {
  std::vector<PlotPoint> feet, tips;
  Stroke stroke;
  bool closed = false;
  std::size_t every = 1;
  std::string legend = {};
};

/// A text beside a point. Texts may contain $...$, which PGF sets as mathematics; SVG and PNG show it as plain text
/// with names of Greek letters replaced (SVG) or spelled (PNG).
struct PlotLabel {
  enum class Anchor { left, centre, right, above, below };
  PlotPoint at;
  std::string text;
  /// Where the text lies, seen from the point.
  Anchor anchor = Anchor::above;
};

using PlotItem = std::variant<PlotRegion, PlotCurve, PlotComb, PlotMarkers, PlotLabel>;

struct PlotTick {
  double value = 0;
  /// May contain $...$.
  std::string text;
};

struct PlotAxis {
  std::string label = {};
  /// Ends; without them those of the items, a little widened.
  std::optional<double> lower = {}, upper = {};
  bool logarithmic = false;
  /// Instead of ticks at round numbers.
  std::optional<std::vector<PlotTick>> ticks = {};
};

/// A picture as a value: what is drawn, in this order. Three writers make the same picture of it; equal plots give
/// equal bytes (no clock, no locale, numbers of fixed precision).
struct Plot {
  std::string title;
  PlotAxis x, y;
  std::vector<PlotItem> items;
  /// The frame around the items, with ticks and the axes' labels.
  bool frame = true;
  /// The same unit on both axes. Only for two linear axes.
  bool equal_aspect = false;
  /// Greatest size of the area inside the frame, in points (1/72 inch); with equal_aspect one of the two becomes
  /// smaller.
  double width = 400, height = 300;
};

/// All writers throw DomainError when a point or an end of an axis is not finite, or not positive on a logarithmic
/// axis; when an axis is empty (lower >= upper); when a comb has more feet than tips or the other way round; when
/// equal_aspect meets a logarithmic axis; when the size is not between 10 and 10000 points.

/// A stand-alone SVG file.
std::string to_svg(const Plot& plot);

/// A tikzpicture for an article that says \usepackage{pgfplots}; it is \input there.
std::string to_pgf(const Plot& plot);

/// The same picture for a document that pdfTeX or LuaTeX makes of nothing but pictures, one a page: lines are literals of PDF, which TeX
/// need not draw, texts are set by TeX. See figures_latex(), whose preamble defines \limespage.
std::string to_tex_page(const Plot& plot);
/// How far that page reaches below the area inside of the frame, in points.
double depth_below_area(const Plot& plot);

/// The bytes of a PNG file with `pixels_per_point` pixels per point (2: 144 dpi), antialiased. \throws LimitError above
/// 2^23 pixels.
std::string to_png(const Plot& plot, double pixels_per_point = 2);

}  // namespace limes
