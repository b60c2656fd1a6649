#pragma once

#include <string>
#include <utility>
#include <vector>

namespace limes {

/// What a report was made from and what it consists of.
struct Manifest {
  std::string limes_version;
  /// Words of the command line.
  std::vector<std::string> command;
  /// Names and contents.
  using Files = std::vector<std::pair<std::string, std::string>>;
  Files schemes;
  Files outputs;
};

/// JSON with the libraries' versions and the files' SHA-256; no clock, no path of this machine.
std::string manifest_json(const Manifest& manifest);

}  // namespace limes
