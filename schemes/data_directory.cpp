#include "schemes/data_directory.hpp"

namespace limes {

std::filesystem::path data_path(const std::filesystem::path& name) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share/limes" / name;
}

}  // namespace limes
