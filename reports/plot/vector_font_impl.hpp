#pragma once

#include "reports/plot/plot.hpp"

#include <string>
#include <vector>

namespace limes::plot_impl {

/// The polylines of a text in ASCII, starting at (0, 0) on its base line, y downwards, in points for a font of `size`
/// points. Other characters are boxes.
std::vector<std::vector<PlotPoint>> text_strokes(const std::string& text, double size);

/// Width of that text; an estimate for the font that shows an SVG.
double text_width(const std::string& text, double size);

}  // namespace limes::plot_impl
