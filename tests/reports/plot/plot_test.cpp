#include "reports/plot/plot.hpp"

#include "algebra/error.hpp"
#include "reports/plot/layout_impl.hpp"
#include "reports/plot/polygon_plot.hpp"
#include "reports/plot/vector_font_impl.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <clocale>
#include <cmath>

namespace limes {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// One of everything.
Plot example() {
  Plot plot{.title = "Title & <more> of $\\gamma$ 100%", .x = {"x_1"}, .y = {"y"}, .items = {}};
  plot.items.push_back(PlotRegion{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, lighter(palette(3), 0.4), "cell"});
  plot.items.push_back(PlotCurve{{{0, 0}, {0.5, 1}, {1, 0.25}}, {palette(1), 1.5, Dash::dashed}, false, "curve"});
  plot.items.push_back(
      PlotComb{{{0, 0}, {1, 0}}, {{0, 0.5}, {1, 0.25}}, {palette(2), 1, Dash::solid}, false, 1, "comb"});
  plot.items.push_back(PlotMarkers{{{0.5, 0.5}}, palette(0), 3, "points"});
  plot.items.push_back(PlotLabel{{0.5, 0.5}, "here"});
  return plot;
}

struct Picture {
  int width = 0, height = 0;
  std::vector<Color> pixels;
  Color at(double x, double y) const {
    return pixels[static_cast<std::size_t>(y * height) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x * width)];
  }
};

/// What libpng reads back.
Picture decoded(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, png.data(), png.size())) throw InternalError(image.message);
  image.format = PNG_FORMAT_RGB;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.pixels.resize(image.width * image.height);
  if (!png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr)) throw InternalError(image.message);
  return picture;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Plot, EqualPlotsGiveEqualBytesInEveryLocale) {
  const auto all = [] { return to_svg(example()) + to_pgf(example()) + to_tex_page(example()) + to_png(example()); };
  const std::string first = all();
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(all(), first);
  std::setlocale(LC_ALL, "C");
}

TEST(Plot, SvgHasEveryItemAndEscapesTexts) {
  const std::string svg = to_svg(example());
  EXPECT_THAT(svg, HasSubstr("Title &amp; &lt;more&gt; of γ 100%"));
  for (const char* part :
       {">cell<", ">curve<", ">comb<", ">points<", ">here<", ">x_1<", "stroke-dasharray", "<circle"}) {
    EXPECT_THAT(svg, HasSubstr(part));
  }
  EXPECT_EQ(count(svg, "<g"), count(svg, "</g>"));
  EXPECT_EQ(count(svg, "<text"), count(svg, "</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Plot, PgfHasEveryItemAndEscapesTexts) {
  const std::string pgf = to_pgf(example());
  EXPECT_THAT(pgf, HasSubstr("title={Title \\& \\textless{}more\\textgreater{} of $\\gamma$ 100\\%}"));
  EXPECT_THAT(pgf, HasSubstr("xlabel={x\\_1}"));
  for (const char* part : {"\\addlegendentry{cell}", "\\addlegendentry{curve}", "\\addlegendentry{comb}", "only marks",
                           "{here}", "dashed"}) {
    EXPECT_THAT(pgf, HasSubstr(part));
  }
  EXPECT_EQ(count(pgf, "{"), count(pgf, "}"));
  EXPECT_EQ(count(pgf, "\\begin{"), count(pgf, "\\end{"));
}

TEST(Plot, TexPageHasEveryItemAndEscapesTexts) {
  const std::string page = to_tex_page(example());
  EXPECT_THAT(page, HasSubstr("{\\limestitle Title \\& \\textless{}more\\textgreater{} of $\\gamma$ 100\\%}"));
  for (const char* part : {"\\limespage{", "{cell}", "{curve}", "{comb}", "{here}", "[4 3] 0 d", " rg\n", " RG\n", "\\limesupwards"}) {
    EXPECT_THAT(page, HasSubstr(part));
  }
  EXPECT_EQ(count(page, "{"), count(page, "}"));
  EXPECT_EQ(count(page, "q "), count(page, "Q\n"));
  EXPECT_GT(depth_below_area(example()), 0);
}

TEST(Plot, TicksAsGiven) {
  Plot plot;
  plot.y.lower = 0;
  plot.y.upper = 2;
  plot.y.ticks.emplace();
  plot.y.ticks->push_back({1, "$C^{1}$"});
  EXPECT_THAT(to_pgf(plot), HasSubstr("ytick={1}, yticklabels={$C^{1}$}"));
  EXPECT_THAT(to_svg(plot), HasSubstr(">C^1<"));
  EXPECT_THAT(to_tex_page(plot), HasSubstr("{$C^{1}$}"));
}

TEST(Plot, PngShowsRegionsWithoutSeams) {
  // Cells of one colour side by side, cut at places that are no pixels: the inside has that colour everywhere.
  Plot plot{.title = {},
            .x = {.lower = 0, .upper = 1},
            .y = {.lower = 0, .upper = 1},
            .items = {},
            .frame = false,
            .width = 90,
            .height = 70};
  const Color blue = palette(1);
  PlotRegion cells{{}, blue};
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 13; ++j) {
      const double a = i / 7.0, b = (i + 1) / 7.0, c = j / 13.0, d = (j + 1) / 13.0;
      cells.outlines.push_back({{a, c}, {b, c}, {b, d}, {a, d}});
    }
  }
  plot.items.push_back(cells);
  const Picture picture = decoded(to_png(plot, 3));
  EXPECT_EQ(picture.width, 3 * (90 + 16));
  EXPECT_EQ(picture.height, 3 * (70 + 16));
  for (double x = 0.1; x < 0.9; x += 0.003) {
    for (double y = 0.12; y < 0.88; y += 0.005) ASSERT_EQ(picture.at(x, y), blue);
  }
  EXPECT_EQ(picture.at(0.01, 0.01), (Color{255, 255, 255}));
  EXPECT_THROW(to_png(plot, 1000), LimitError);
}

TEST(Plot, PngCutsAtTheFrameAndDrawsHugeNumbers) {
  Plot plot{.title = {},
            .x = {.lower = 0, .upper = 1},
            .y = {.lower = 0, .upper = 1},
            .items = {},
            .frame = false,
            .width = 100,
            .height = 100};
  plot.items.push_back(PlotCurve{{{-1e250, 0.5}, {1e250, 0.5}}, {palette(2), 10, Dash::solid}});
  plot.items.push_back(PlotCurve{{{0.5, -1e250}, {0.5, 1e250}}, {palette(1), 10, Dash::dotted}});
  const Picture picture = decoded(to_png(plot));
  EXPECT_EQ(picture.at(0.3, 0.5), palette(2));
  EXPECT_EQ(picture.at(0.02, 0.5), (Color{255, 255, 255}));
  EXPECT_LT(to_svg(plot).size(), 2000u);
}

TEST(Plot, TicksAreRoundAndInside) {
  for (const auto& [lower, upper] : std::vector<std::pair<double, double>>{
           {0, 1}, {-3.7, 12}, {1e-9, 3e-9}, {0.1, 0.1001}, {-1e7, 1e7}, {1e20, 1.5e20}}) {
    Plot plot;
    plot.x.lower = lower;
    plot.x.upper = upper;
    const plot_impl::Layout layout = plot_impl::layout(plot);
    EXPECT_GE(layout.x.ticks.size(), 3u) << lower;
    EXPECT_LE(layout.x.ticks.size(), 12u) << lower;
    for (const PlotTick& tick : layout.x.ticks) {
      EXPECT_NEAR(std::stod(tick.text), tick.value, 1e-5 * std::max(std::abs(lower), std::abs(upper)));
      EXPECT_GE(layout.x.place(tick.value), -1e-6);
      EXPECT_LE(layout.x.place(tick.value), 1 + 1e-6);
    }
  }
}

TEST(Plot, LogarithmicAxes) {
  Plot plot{.title = {}, .x = {.logarithmic = true}, .y = {}, .items = {}};
  plot.items.push_back(PlotCurve{{{1e-3, 1}, {1, 2}, {1e3, 3}}, {}});
  const plot_impl::Layout layout = plot_impl::layout(plot);
  EXPECT_NEAR(layout.x.place(1), 0.5, 1e-12);
  EXPECT_GE(layout.x.ticks.size(), 6u);
  EXPECT_THAT(to_pgf(plot), HasSubstr("xmode=log"));
  plot.items.push_back(PlotMarkers{{{0, 1}}, {}});
  EXPECT_THROW(to_svg(plot), DomainError);
}

TEST(Plot, EqualAspectGivesBothAxesOneUnit) {
  for (const auto& [width, height] :
       std::vector<std::pair<double, double>>{{1, 1}, {10, 1}, {1, 10}, {1000, 1}, {0, 1}}) {
    Plot plot{.title = {}, .x = {}, .y = {}, .items = {}, .equal_aspect = true};
    plot.items.push_back(PlotCurve{{{0, 0}, {width, height}}, {}});
    const plot_impl::Layout layout = plot_impl::layout(plot);
    EXPECT_NEAR(layout.width / (layout.x.upper - layout.x.lower), layout.height / (layout.y.upper - layout.y.lower),
                1e-9 * layout.width);
    EXPECT_LE(layout.width, plot.width + 1e-9);
    EXPECT_LE(layout.height, plot.height + 1e-9);
  }
}

TEST(Plot, BadPlotsAreRejected) {
  const auto rejected = [](Plot plot) {
    EXPECT_THROW(to_svg(plot), DomainError);
    EXPECT_THROW(to_pgf(plot), DomainError);
    EXPECT_THROW(to_png(plot), DomainError);
  };
  Plot plot;
  EXPECT_NO_THROW(to_svg(plot)) << "an empty plot is a frame";
  plot.items.push_back(PlotMarkers{{{NAN, 1}}, {}});
  rejected(plot);
  plot.items = {PlotComb{{{0, 0}}, {}, {}}};
  rejected(plot);
  rejected({.title = {}, .x = {.lower = 1, .upper = 1}, .y = {}, .items = {}});
  rejected({.title = {}, .x = {.lower = 0, .upper = INFINITY}, .y = {}, .items = {}});
  rejected({.title = {}, .x = {.lower = -1, .upper = 1, .logarithmic = true}, .y = {}, .items = {}});
  rejected({.title = {}, .x = {.logarithmic = true}, .y = {}, .items = {}, .equal_aspect = true});
  rejected({.title = {}, .x = {}, .y = {}, .items = {}, .width = 1e9});
}

TEST(Plot, SimplifyingKeepsTheCurve) {
  std::vector<PlotPoint> circle;
  for (int i = 0; i < 4096; ++i) circle.push_back({std::cos(i * M_PI / 2048), std::sin(i * M_PI / 2048)});
  Plot plot{.title = {}, .x = {}, .y = {}, .items = {PlotCurve{circle, {}, true}}, .equal_aspect = true};
  const std::vector<PlotPoint> fewer = plot_impl::simplified(circle, plot_impl::layout(plot), true);
  EXPECT_LT(fewer.size(), 400u);
  EXPECT_GT(fewer.size(), 50u);
  // A chord of a circle of radius 1 that stays within e has a length of at most about sqrt(8 e).
  for (std::size_t i = 1; i < fewer.size(); ++i) {
    EXPECT_LT(std::hypot(fewer[i].x - fewer[i - 1].x, fewer[i].y - fewer[i - 1].y), std::sqrt(8 * 0.02 / 100));
  }
  const std::vector<PlotPoint> spike{{0, 0}, {1, 0}, {0.2, 0}};
  EXPECT_EQ(plot_impl::simplified(spike, plot_impl::layout(plot), false), spike);
}

TEST(Plot, FontHasAllOfAscii) {
  for (char c = '!'; c <= '~'; ++c) {
    EXPECT_FALSE(plot_impl::text_strokes(std::string(1, c), 10).empty()) << c;
    EXPECT_GE(plot_impl::text_width(std::string(2, c), 10), 1) << c;
  }
  EXPECT_EQ(plot_impl::text_strokes("γ", 10).size(), 1u);
  EXPECT_EQ(plot_impl::plain_text("$\\lambda_1$ \\foo", true), "λ_1 foo");
  EXPECT_EQ(plot_impl::plain_text("$\\lambda_1$", false), "lambda_1");
}

TEST(PolygonPlot, ShowsDataCurveAndComb) {
  const Polygon data(2, {0, 0, 1, 0, 1, 1, 0, 1}, true);
  const Plot plain = polygon_plot(data, data, {"square", {}}), combed = polygon_plot(data, data, {"square", 0.1});
  EXPECT_EQ(plain.items.size() + 1, combed.items.size());
  EXPECT_TRUE(combed.equal_aspect);
  EXPECT_THAT(to_svg(combed), HasSubstr(">square<"));
  EXPECT_NO_THROW(to_svg(polygon_plot(Polygon(3, {0, 0, 0, 1, 1, 5}), Polygon(3, {0, 0, 0, 1, 1, 5}), {"", 1.0})));
  EXPECT_THROW(polygon_plot(Polygon(1, {0, 1}), Polygon(1, {0, 1}), {}), DomainError);
}

}  // namespace
}  // namespace limes
