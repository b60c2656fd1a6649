#pragma once

#include "proofs/map/map_unions.hpp"
#include "reports/plot/plot.hpp"

namespace limes {

/// The picture of a parameter map: certified, refuted and unknown parts of the region in three colours; with one parameter a bar,
/// with two the rectangle of both.
Plot map_plot(const std::vector<MapUnion>& unions, const Box& region, const VariableNames& parameters, const std::string& title);

}  // namespace limes
