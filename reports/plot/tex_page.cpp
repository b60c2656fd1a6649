#include "reports/plot/canvas_impl.hpp"

#include <fmt/format.h>

#include <cstdlib>


namespace limes {
namespace {

using namespace plot_impl;

constexpr PageStyle style{.text = 8.5, .title = 9.5, .border = 1, .line = 0.45};

std::string number(double value) { return decimals(value, 2); }

std::string colour(Color c, const char* operation) {
  return fmt::format("{} {} {} {}\n", decimals(c.red / 255., 3), decimals(c.green / 255., 3), decimals(c.blue / 255., 3), operation);
}

/// A number of a tick as mathematics: 1e-06 is a power of ten.
std::string tick_text(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return "$" + text + "$";
  const std::string mantissa = text.substr(0, e), exponent = std::to_string(std::atoi(text.c_str() + e + 1));
  return fmt::format("${}10^{{{}}}$", mantissa == "1" ? "" : mantissa + "\\cdot ", exponent);
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.-+e") == std::string::npos && text.find_first_of("0123456789") != std::string::npos;
}

/// Paths as operators of PDF, y upwards from the foot of the page; texts as calls of macros.
class TexCanvas : public Canvas {
 public:
  explicit TexCanvas(const Page& page) : page_(page) {}
  std::string finished() && {
    return fmt::format("\\limespage{{{}}}{{{}}}{{%\n1 j\n{}}}{{%\n{}}}\n", number(page_.width), number(page_.height), paths_, texts_);
  }

  void clip(double x, double y, double width, double height) override {
    paths_ += fmt::format("q {} {} {} {} re W n\n", number(x), number(page_.height - y - height), number(width), number(height));
  }
  void unclip() override { paths_ += "Q\n"; }
  void polyline(const std::vector<PlotPoint>& points, bool closed, const Stroke& stroke) override {
    if (!points.empty()) paths_ += stroked(stroke) + path(points, closed ? "h S\n" : "S\n");
  }
  void segments(const std::vector<PlotPoint>& ends, const Stroke& stroke) override {
    if (ends.size() < 2) return;
    paths_ += stroked(stroke);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) paths_ += path({ends[i], ends[i + 1]}, "\n");
    paths_ += "S\n";
  }
  void fill(const std::vector<std::vector<PlotPoint>>& outlines, Color color) override {
    paths_ += colour(color, "rg");
    for (const auto& outline : outlines) {
      if (!outline.empty()) paths_ += path(outline, "h f\n");
    }
  }
  void discs(const std::vector<PlotPoint>& centres, double radius, Color color) override {
    // Dots of no length with round ends.
    if (centres.empty()) return;
    paths_ += fmt::format("q 1 J {} w {}", number(2 * radius), colour(color, "RG"));
    for (const PlotPoint& c : centres) paths_ += path({c, c}, "\n");
    paths_ += "S Q\n";
  }
  void text(PlotPoint at, const std::string& text, double size, TextAlign align, bool upwards) override {
    const char* side = align == TextAlign::start ? "\\limesleft" : align == TextAlign::middle ? "\\limesmiddle" : "\\limesright";
    texts_ += fmt::format("{}{{{}}}{{{}}}{{{}{}}}%\n", upwards ? "\\limesupwards" : side, number(at.x), number(page_.height - at.y),
                          size > style.text ? "\\limestitle " : "", is_number(text) ? tick_text(text) : tex_text(text));
  }

 private:
  std::string path(const std::vector<PlotPoint>& points, const char* end) const {
    std::string data;
    for (std::size_t i = 0; i < points.size(); ++i) {
      data += fmt::format("{} {} {}{}", number(points[i].x), number(page_.height - points[i].y), i == 0 ? "m" : "l", i % 8 == 7 ? "\n" : " ");
    }
    return data + end;
  }
  std::string stroked(const Stroke& stroke) const {
    const char* dash = stroke.dash == Dash::dashed ? "[4 3] 0 d" : stroke.dash == Dash::dotted ? "[1 2] 0 d" : "[] 0 d";
    return fmt::format("{} w {} {}", number(stroke.width), dash, colour(stroke.color, "RG"));
  }

  const Page& page_;
  std::string paths_, texts_;
};

}  // namespace

std::string to_tex_page(const Plot& plot) {
  const Layout area = layout(plot);
  const Page whole = page(plot, area, style);
  TexCanvas canvas(whole);
  draw(plot, area, whole, canvas);
  return std::move(canvas).finished();
}

double depth_below_area(const Plot& plot) {
  const Layout area = layout(plot);
  const Page whole = page(plot, area, style);
  return whole.height - whole.top - area.height;
}

}  // namespace limes
