#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace limes {

/// The bytes of a file, a pipe included. \throws InputError when it cannot be read (a directory), LimitError when it has more than
/// `max_bytes`; both name the file.
std::string read_text_file(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace limes
