#pragma once

#include "schemes/scheme.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace limes {

/// The schemes that ship with Limes: one TOML file each, <name>.toml.
class Catalogue {
 public:
  /// \throws InputError when the directory does not exist.
  explicit Catalogue(std::filesystem::path directory);

  /// The first that is a directory: $LIMES_CATALOGUE; ../share/limes/catalogue beside the running program (build tree and
  /// installation). \throws InputError when there is none, or LIMES_CATALOGUE names no directory.
  static Catalogue find();

  const std::filesystem::path& directory() const { return directory_; }
  /// Names of all schemes, ordered with numbers by value (b-spline-8 before b-spline-10).
  std::vector<std::string> names() const;
  /// \throws InputError for an unknown name, with the nearest known one.
  std::filesystem::path file(const std::string& name) const;
  Scheme load(const std::string& name) const;

 private:
  std::filesystem::path directory_;
};

/// The scheme file at a path, when the text ends in ".toml" or contains a '/'; otherwise the catalogue's scheme of that name.
std::filesystem::path scheme_file(const std::string& name_or_path);
Scheme load_scheme(const std::string& name_or_path);

}  // namespace limes
