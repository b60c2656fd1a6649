#include "apps/limes/outputs.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limes::app {

std::string kind_by_ending(const std::string& option, const std::filesystem::path& file, const std::vector<std::string>& kinds) {
  const std::string ending = file.extension().string();
  for (const std::string& kind : kinds) {
    if (ending == "." + kind) return kind;
  }
  const std::vector<std::string> others(kinds.begin(), kinds.end() - 1);
  throw InputError(
      fmt::format("{} {}: the ending must be .{} or .{}", option, file.string(), fmt::join(others, ", ."), kinds.back()));
}

std::vector<OutputFile> outputs_by_ending(const std::vector<std::filesystem::path>& files, const std::vector<std::string>& kinds) {
  std::vector<OutputFile> outputs;
  for (const std::filesystem::path& file : files) outputs.push_back({file.string(), kind_by_ending("-o", file, kinds)});
  return outputs;
}

std::string picture(const std::string& kind, const Plot& plot) {
  if (kind == "svg") return to_svg(plot);
  return kind == "pgf" ? to_pgf(plot) : to_png(plot);
}

}  // namespace limes::app
