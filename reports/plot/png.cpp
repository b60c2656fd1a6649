#include "reports/plot/canvas_impl.hpp"
#include "reports/plot/vector_font_impl.hpp"

#include "algebra/error.hpp"

#include <png.h>

#include <cmath>

namespace limes {
namespace {

using namespace plot_impl;

/// Samples per pixel in each direction. Shapes have hard edges on the finer grid, so neighbouring cells leave no seam,
/// and the mean over each pixel smooths all edges alike.
constexpr int samples = 4;
constexpr double max_pixels = 1 << 23;

class PngCanvas : public Canvas {
 public:
  PngCanvas(const Page& page, double pixels_per_point) : unit_(pixels_per_point * samples) {
    const double width = std::ceil(page.width * pixels_per_point), height = std::ceil(page.height * pixels_per_point);
    if (!(pixels_per_point > 0) || !(width * height <= max_pixels)) throw LimitError("a PNG may have 2^23 pixels");
    width_ = static_cast<int>(width) * samples;
    height_ = static_cast<int>(height) * samples;
    grid_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Color{255, 255, 255});
    unclip();
  }

  void clip(double x, double y, double width, double height) override {
    left_ = std::max(column(x * unit_), 0);
    right_ = std::min(column((x + width) * unit_), width_);
    top_ = std::max(column(y * unit_), 0);
    bottom_ = std::min(column((y + height) * unit_), height_);
  }
  void unclip() override {
    left_ = top_ = 0;
    right_ = width_;
    bottom_ = height_;
  }
  void polyline(const std::vector<PlotPoint>& points, bool closed, const Stroke& stroke) override {
    std::vector<PlotPoint> all = points;
    if (closed && !all.empty()) all.push_back(all.front());
    if (stroke.dash == Dash::solid) return line(all, stroke);
    for (const auto& dash : dashes(all, stroke.dash == Dash::dashed ? 5 : 1, stroke.dash == Dash::dashed ? 3 : 2.5))
      line(dash, stroke);
  }
  void segments(const std::vector<PlotPoint>& ends, const Stroke& stroke) override {
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) line({ends[i], ends[i + 1]}, stroke);
  }
  void fill(const std::vector<std::vector<PlotPoint>>& outlines, Color color) override {
    for (const auto& outline : outlines) polygon(outline, color);
  }
  void discs(const std::vector<PlotPoint>& centres, double radius, Color color) override {
    for (const PlotPoint& c : centres) disc(c, radius, color);
  }
  void text(PlotPoint at, const std::string& text, double size, TextAlign align, bool upwards) override {
    const std::string plain = plain_text(text, false);
    const double width = text_width(plain, size);
    const double start = align == TextAlign::start ? 0 : align == TextAlign::middle ? -width / 2 : -width;
    for (std::vector<PlotPoint> points : text_strokes(plain, size)) {
      for (PlotPoint& p : points)
        p = upwards ? PlotPoint{at.x + p.y, at.y - start - p.x} : PlotPoint{at.x + start + p.x, at.y + p.y};
      line(points, {{40, 40, 40}, 0.085 * size, Dash::solid});
    }
  }

  /// The file: mean colours, compressed.
  std::string finished() const {
    const int width = width_ / samples, height = height_ / samples;
    std::vector<std::uint8_t> pixels;
    pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        int sum[3] = {};
        for (int dy = 0; dy < samples; ++dy) {
          const Color* row = &grid_[index(x * samples, y * samples + dy)];
          for (int dx = 0; dx < samples; ++dx) {
            sum[0] += row[dx].red;
            sum[1] += row[dx].green;
            sum[2] += row[dx].blue;
          }
        }
        constexpr int count = samples * samples;
        for (const int c : sum) pixels.push_back(static_cast<std::uint8_t>((c + count / 2) / count));
      }
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr)) {
      throw InternalError(std::string("libpng: ") + image.message);
    }
    bytes.resize(size);
    return bytes;
  }

 private:
  /// The first sample whose centre is not left of x; so spans of neighbouring shapes neither overlap nor leave a gap.
  static int column(double x) { return static_cast<int>(std::ceil(std::clamp(x, -1e8, 1e8) - 0.5)); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  void span(int y, double from, double to, Color color) {
    const int first = std::max(column(from), left_), last = std::min(column(to), right_);
    if (first < last) std::fill_n(&grid_[index(first, y)], last - first, color);
  }

  void disc(PlotPoint centre, double radius, Color color) {
    const double x = centre.x * unit_, y = centre.y * unit_, r = radius * unit_;
    const int last = std::min(column(y + r), bottom_);
    for (int row = std::max(column(y - r), top_); row < last; ++row) {
      const double up = row + 0.5 - y, half = std::sqrt(std::max(r * r - up * up, 0.0));
      span(row, x - half, x + half, color);
    }
  }

  void polygon(const std::vector<PlotPoint>& points, Color color) {
    crossings_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      PlotPoint a = points[i], b = points[(i + 1) % points.size()];
      if (a.y > b.y) std::swap(a, b);
      const int last = std::min(column(b.y * unit_), bottom_);
      for (int row = std::max(column(a.y * unit_), top_); row < last; ++row) {
        const double t = ((row + 0.5) / unit_ - a.y) / (b.y - a.y);
        crossings_.push_back({row, (a.x + t * (b.x - a.x)) * unit_});
      }
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      if (crossings_[i].first == crossings_[i + 1].first)
        span(crossings_[i].first, crossings_[i].second, crossings_[i + 1].second, color);
    }
  }

  void line(const std::vector<PlotPoint>& points, const Stroke& stroke) {
    const double half = stroke.width / 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
      disc(points[i], half, stroke.color);
      if (i == 0) continue;
      const PlotPoint a = points[i - 1], b = points[i];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (length == 0) continue;
      const double nx = -(b.y - a.y) / length * half, ny = (b.x - a.x) / length * half;
      polygon({{a.x + nx, a.y + ny}, {b.x + nx, b.y + ny}, {b.x - nx, b.y - ny}, {a.x - nx, a.y - ny}}, stroke.color);
    }
  }

  /// The parts of a polyline of length `on`, with gaps of length `off`.
  static std::vector<std::vector<PlotPoint>> dashes(const std::vector<PlotPoint>& points, double on, double off) {
    std::vector<std::vector<PlotPoint>> result;
    if (!points.empty()) result.push_back({points.front()});
    bool drawing = true;
    double left = on;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const PlotPoint a = points[i - 1], b = points[i];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      double done = 0;
      if (length > 1e5) {  // far outside of the picture
        if (drawing) result.push_back({b});
        continue;
      }
      while (length - done > left) {
        done += left;
        const PlotPoint at{a.x + (b.x - a.x) * done / length, a.y + (b.y - a.y) * done / length};
        if (drawing)
          result.back().push_back(at);
        else
          result.push_back({at});
        drawing = !drawing;
        left = drawing ? on : off;
      }
      left -= length - done;
      if (drawing) result.back().push_back(b);
    }
    return result;
  }

  double unit_;
  int width_ = 0, height_ = 0;
  int left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
  std::vector<Color> grid_;
  std::vector<std::pair<int, double>> crossings_;
};

}  // namespace

std::string to_png(const Plot& plot, double pixels_per_point) {
  const Layout area = layout(plot);
  const Page whole = page(plot, area);
  PngCanvas canvas(whole, pixels_per_point);
  draw(plot, area, whole, canvas);
  return canvas.finished();
}

}  // namespace limes
