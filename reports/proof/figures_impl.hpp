// Figures of a proof report. Included by sources of reports/proof and reports/unity only.
#pragma once

#include "geometry/polygon.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

namespace limes::report_impl {

constexpr double panel_width = 112, panel_height = 86;
/// Where something is positive or negative, or where roots may be.
constexpr Color pale_blue{226, 237, 247}, pale_red{250, 229, 219}, pale_grey{238, 243, 248};

/// A third or so of a page wide.
Plot small_plot(const std::string& title);
/// "x,name\n1,2\n"
std::string csv(const std::string& header, const std::vector<PlotPoint>& points);
/// " for $w=1/16$"
std::string at_text(const Scheme& scheme, std::span<const Rational> point);

/// phi, its last continuous derivative, and what happens to the next one.
std::optional<Figure> limit_function_figure(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness);
/// Limits for a point's data at several angles, and a regular polygon.
std::optional<Figure> angles_figure(const ReportedScheme& reported, int smoothness, const Stop& stop);
/// Exact norms by level.
std::optional<Figure> norms_figure(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness, const Stop& stop);
/// Eigenvalues in the disc of radius 2^{-m}; signs and zeros of the characteristic polynomial's factors over (gamma, lambda).
std::optional<Figure> eigenvalues_figure(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness, const Stop& stop);
/// Where C^m is certified and where not, by what the claims prove, for one parameter.
std::optional<Figure> map_figure(const ReportedScheme& reported);
/// Refined polygons with curvature combs.
std::optional<Figure> comb_figure(const ReportedScheme& reported, const std::vector<Rational>& point, const std::filesystem::path& polygons, const Stop& stop);
/// Curvatures for several parameter values [Karciauskas & Peters 2013, Fig. 5], the side of a square magnified [Fig. 3].
std::optional<Figure> curvature_figure(const ReportedScheme& reported, const std::filesystem::path& polygons, const Stop& stop);
std::optional<Figure> square_figure(const ReportedScheme& reported, const std::vector<Rational>& point, const std::filesystem::path& polygons, const Stop& stop);
/// A polygon of the folder; nothing without the file.
std::optional<Polygon> polygon_of(const std::filesystem::path& folder, const std::string& name, bool closed);
/// Non-uniform schemes take centripetal knots.
Polygon refined_at(const Scheme& scheme, const std::vector<Rational>& point, const Polygon& data, int levels, const Stop& stop);
int levels_of(const Scheme& scheme);
/// What 95 of 100 curvatures do not exceed, 0 where the curvature vanishes or explodes.
double typical_curvature(const Polygon& refined);
/// A refined polygon with a comb on which the typical curvature is a tooth of a tenth of the polygon's size.
Figure::Panel comb_panel(const Polygon& data, const Polygon& refined, double typical);
/// Grid lines under the characteristic map for a few valences.
std::optional<Figure> characteristic_map_figure(const Scheme& scheme);
std::optional<Figure> vertex_surface_figure(const Scheme& scheme, const Stop& stop);
/// Shaded pictures of nets that surfaces.json in the folder describes.
Blocks surface_figures(const Scheme& scheme, const std::filesystem::path& nets, const Stop& stop);

}  // namespace limes::report_impl
