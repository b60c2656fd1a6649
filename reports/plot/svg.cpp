#include "reports/plot/canvas_impl.hpp"

#include <fmt/format.h>

#include <iterator>

namespace limes {
namespace {

using namespace plot_impl;

std::string number(double value) { return decimals(value, 2); }

std::string hexadecimal(Color c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) result += c;  // XML has no control characters
    }
  }
  return result;
}

std::string path(const std::vector<PlotPoint>& points, bool closed) {
  std::string data;
  for (std::size_t i = 0; i < points.size(); ++i)
    data += fmt::format("{}{} {}", i == 0 ? "M" : "L", number(points[i].x), number(points[i].y));
  return closed ? data + "Z" : data;
}

class SvgCanvas : public Canvas {
 public:
  explicit SvgCanvas(const Page& page) {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" viewBox=\"0 0 {0} {1}\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        number(page.width), number(page.height));
  }
  std::string finished() && { return std::move(text_) + "</svg>\n"; }

  void clip(double x, double y, double width, double height) override {
    text_ += fmt::format(
        "<clipPath id=\"area\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n<g "
        "clip-path=\"url(#area)\">\n",
        number(x), number(y), number(width), number(height));
  }
  void unclip() override { text_ += "</g>\n"; }
  void polyline(const std::vector<PlotPoint>& points, bool closed, const Stroke& stroke) override {
    if (!points.empty()) stroked(path(points, closed), stroke);
  }
  void segments(const std::vector<PlotPoint>& ends, const Stroke& stroke) override {
    std::string data;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) data += path({ends[i], ends[i + 1]}, false);
    if (!data.empty()) stroked(data, stroke);
  }
  void fill(const std::vector<std::vector<PlotPoint>>& outlines, Color color) override {
    std::string data;
    for (const auto& outline : outlines) data += path(outline, true);
    if (data.empty()) return;
    text_ += fmt::format("<path d=\"{}\" fill=\"{}\" shape-rendering=\"crispEdges\"/>\n", data, hexadecimal(color));
  }
  void discs(const std::vector<PlotPoint>& centres, double radius, Color color) override {
    text_ += fmt::format("<g fill=\"{}\">", hexadecimal(color));
    for (const PlotPoint& c : centres)
      text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", number(c.x), number(c.y), number(radius));
    text_ += "</g>\n";
  }
  void text(PlotPoint at, const std::string& text, double size, TextAlign align, bool upwards) override {
    const char* anchor = align == TextAlign::start ? "start" : align == TextAlign::middle ? "middle" : "end";
    const std::string turn = upwards ? fmt::format(" transform=\"rotate(-90 {} {})\"", number(at.x), number(at.y)) : "";
    text_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
        number(at.x), number(at.y), number(size), anchor, turn, escaped(plain_text(text, true)));
  }

 private:
  void stroked(const std::string& data, const Stroke& stroke) {
    const std::string dashes = stroke.dash == Dash::dashed   ? " stroke-dasharray=\"5 3\""
                               : stroke.dash == Dash::dotted ? " stroke-dasharray=\"1 2.5\""
                                                             : "";
    text_ +=
        fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{}/>\n",
                    data, hexadecimal(stroke.color), number(stroke.width), dashes);
  }
  std::string text_;
};

}  // namespace

std::string to_svg(const Plot& plot) {
  const Layout area = layout(plot);
  const Page whole = page(plot, area);
  SvgCanvas canvas(whole);
  draw(plot, area, whole, canvas);
  return std::move(canvas).finished();
}

}  // namespace limes
