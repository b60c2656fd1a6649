#pragma once

#include "apps/limes/json_output.hpp"
#include "reports/plot/plot.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace limes::app {

/// The kind of an output file, one of `kinds`, by its ending: "svg" for "curve.svg".
/// \throws InputError "-o curve.txt: the ending must be .csv, .svg, .pgf or .png"
std::string kind_by_ending(const std::string& option, const std::filesystem::path& file, const std::vector<std::string>& kinds);

/// The same for all files of -o.
std::vector<OutputFile> outputs_by_ending(const std::vector<std::filesystem::path>& files, const std::vector<std::string>& kinds);

/// \param kind svg, pgf or png
std::string picture(const std::string& kind, const Plot& plot);

}  // namespace limes::app
