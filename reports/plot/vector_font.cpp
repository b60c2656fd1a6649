#include "reports/plot/vector_font_impl.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace limes::plot_impl {
namespace {

// A glyph is a list of polylines, separated by blanks; a point is a digit x and a letter y on a grid where 'c' is the
// base line, 'h' the height of small letters, 'k' of capitals, 'a' the end of descenders. From ' ' to '~'.
// clang-format off
constexpr std::array<std::string_view, 95> glyphs{
    "", "0k0f 0c0c", "0k0i 2k2i", "1c2k 3c4k 0f4f 0h4h", "4j3k1k0j0h1g3g4f4d3c1c0d 2l2b", "0c4k 0k1k1i0i0k 3e4e4c3c3e",
    "4c0i1k2k3j0e0d1c2c4f", "0k0i", "2k1j0h0e1c2b", "0k1j2h2e1c0b", "2k2g 0j4h 4j0h", "2d2h 0f4f", "1d1c0a", "0f3f",
    "0c0c", "0b4k", "1c0d0j1k3k4j4d3c1c", "0i2k2c 0c4c", "0j1k3k4j4h0d0c4c", "0j1k3k4j4h3g1g 3g4f4d3c1c0d", "3c3k0e4e",
    "4k0k0h3h4g4d3c1c0d", "4j3k1k0j0d1c3c4d4f3g1g0f", "0k4k1c", "1g0h0j1k3k4j4h3g1g0f0d1c3c4d4f3g",
    "0d1c3c4d4j3k1k0j0h1g3g4h", "0c0c 0g0g", "1g1g 1d1c0a", "4i0f4c", "0e4e 0g4g", "0i4f0c", "0j1k3k4j4i2g2e 2c2c",
    "3e3h1h1e4e4j3k1k0j0d1c4c", "0c2k4c 1f3f", "0c0k3k4j4h3g0g 3g4f4d3c0c", "4j3k1k0j0d1c3c4d", "0c0k2k4i4e2c0c",
    "4k0k0c4c 0g3g", "4k0k0c 0g3g", "4j3k1k0j0d1c3c4d4g2g", "0c0k 4c4k 0g4g", "0k2k 1k1c 0c2c", "0d1c2c3d3k",
    "0c0k 4k0f 1g4c", "0k0c4c", "0c0k2f4k4c", "0c0k4c4k", "1c0d0j1k3k4j4d3c1c", "0c0k3k4j4h3g0g",
    "1c0d0j1k3k4j4d3c1c 2e4c", "0c0k3k4j4h3g0g 2g4c", "4j3k1k0j0h1g3g4f4d3c1c0d", "0k4k 2k2c", "0k0d1c3c4d4k", "0k2c4k",
    "0k1c3i5c6k", "0c4k 0k4c", "0k2g4k 2g2c", "0k4k0c4c", "2k0k0b2b", "0k4b", "0k2k2b0b", "0i2k4i", "0a4a", "0k1i",
    "0g1h3h4g4c 4e3f1f0e0d1c3c4d", "0k0c 0d1c3c4d4g3h1h0g", "4g3h1h0g0d1c3c4d", "4k4c 4d3c1c0d0g1h3h4g",
    "0f4f4g3h1h0g0d1c3c4d", "3k2k1j1c 0h3h", "4h4b3a1a0b 4g3h1h0g0d1c3c4d", "0k0c 0g1h3h4g4c", "0h0c 0j0k",
    "1h1b0a 1j1k", "0k0c 3h0e 1f3c", "0k0d1c", "0h0c 0g1h2h3g3c 3g4h5h6g6c", "0h0c 0g1h3h4g4c", "1c0d0g1h3h4g4d3c1c",
    "0h0a 0g1h3h4g4d3c1c0d", "4h4a 4g3h1h0g0d1c3c4d", "0h0c 0f2h3h", "4g3h1h0g1f3e4d3c1c0d", "1k1d2c3c 0h3h",
    "0h0d1c3c4d 4h4c", "0h2c4h", "0h1c3g5c6h", "0c4h 0h4c", "0h2c 4h1a0a", "0h4h0c4c", "2k1j1g0f1e1c2b", "0k0a",
    "0k1j1g2f1e1c0b", "0f1g3f4g"};
// clang-format on
constexpr std::string_view box = "0c0k4k4c0c";
constexpr double unit = 0.088;  // of the font's size

std::string_view glyph(char c) { return c >= ' ' && c <= '~' ? glyphs[static_cast<std::size_t>(c - ' ')] : box; }

double advance(std::string_view strokes) {
  int width = strokes.empty() ? 2 : 0;
  for (const char c : strokes) {
    if (c >= '0' && c <= '9') width = std::max(width, c - '0');
  }
  return width + 2;
}

/// Bytes of UTF-8 that only continue a character.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::vector<std::vector<PlotPoint>> text_strokes(const std::string& text, double size) {
  std::vector<std::vector<PlotPoint>> strokes;
  double x = 0;
  for (const char c : text) {
    if (continues(c)) continue;
    const std::string_view code = glyph(c);
    bool fresh = true;
    for (std::size_t i = 0; i < code.size(); ++i) {
      if (code[i] == ' ') {
        fresh = true;
        continue;
      }
      if (fresh) strokes.emplace_back();
      fresh = false;
      strokes.back().push_back({(x + (code[i] - '0')) * unit * size, ('c' - code[i + 1]) * unit * size});
      ++i;
    }
    x += advance(code);
  }
  return strokes;
}

double text_width(const std::string& text, double size) {
  double width = 0;
  for (const char c : text) {
    if (!continues(c)) width += advance(glyph(c));
  }
  return std::max(width - 2, 0.0) * unit * size;
}

}  // namespace limes::plot_impl
