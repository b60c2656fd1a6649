#include "reports/plot/characteristic_map_plot.hpp"

#include <cmath>
#include <numbers>

namespace limes {
namespace {

using Complex = std::complex<double>;
using Line = std::vector<Complex>;

/// Lines of the half sector r <= a <= 2r, 0 <= b <= a: those with constant a, then those with constant b, the spoke first.
std::vector<Line> half_sector_lines(const ApproxCharacteristicMap& map, int lines) {
  constexpr int level = 4;
  const std::vector<Line> samples = map.samples(level);
  const int reach = map.reach() << level, last = 2 * reach;
  const auto place = [&](int k) { return reach * k / lines; };
  std::vector<Line> result;
  for (int k = 0; k <= 2 * lines; ++k) {
    const int b = std::min(place(k), last);
    Line line;
    for (int a = std::max(b, reach); a <= last; ++a) line.push_back(samples[std::size_t(a - reach)][std::size_t(b)]);
    if (line.size() > 1) result.push_back(std::move(line));
  }
  for (int k = 0; k <= lines; ++k) result.push_back(samples[std::size_t(place(k))]);
  return result;
}

}  // namespace

Plot characteristic_map_plot(const ApproxCharacteristicMap& map, int valence, const CharacteristicMapPlotOptions& options) {
  Plot plot{.title = options.title, .x = {}, .y = {}, .items = {}, .frame = false, .equal_aspect = true};
  plot.height = plot.width;
  const std::vector<Line> half = half_sector_lines(map, options.lines);
  const Complex omega = std::polar(1., 2 * std::numbers::pi / valence);
  const Stroke thin{lighter(options.color, 0.8), 0.5, Dash::solid}, thick{palette(0), 1.25, Dash::solid};
  const auto add = [&](const Line& line, const Complex& factor, bool mirrored, const Stroke& stroke) {
    PlotCurve curve{{}, stroke};
    for (const Complex& z : line) {
      const Complex w = factor * (mirrored ? omega * std::conj(z) : z);
      curve.points.push_back({w.real(), w.imag()});
    }
    plot.items.push_back(std::move(curve));
  };
  for (const bool spokes : {false, true}) {
    Complex turn = 1;
    for (int sector = 0; sector < valence; ++sector, turn *= omega) {
      Complex factor = turn;
      for (int ring = 0; ring < options.rings; ++ring, factor *= map.eigenvalue().value) {
        if (spokes) {
          add(half.front(), factor, false, thick);
          continue;
        }
        for (std::size_t k = 1; k < half.size(); ++k) {
          add(half[k], factor, false, thin);
          add(half[k], factor, true, thin);
        }
      }
    }
  }
  return plot;
}

}  // namespace limes
