#pragma once

#include <filesystem>

namespace limes {

/// ../share/limes/NAME seen from the running program: right in a build tree and in an installation, wherever it is moved. It need not exist.
std::filesystem::path data_path(const std::filesystem::path& name);

}  // namespace limes
