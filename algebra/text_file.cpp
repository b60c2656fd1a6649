#include "algebra/text_file.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace limes {

std::string read_text_file(const std::filesystem::path& file, std::size_t max_bytes) {
  const SourcePosition where{file.string(), 0, 0};
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (error || !std::filesystem::exists(status)) throw InputError("cannot read the file" + (error ? ": " + error.message() : ""), where);
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(status)) throw InputError("cannot read the file", where);
  std::string text;
  for (std::size_t chunk = 1 << 16; stream && text.size() <= max_bytes; chunk *= 2) {
    const std::size_t begin = text.size();
    text.resize(begin + std::min(chunk, max_bytes + 1 - begin));
    stream.read(text.data() + begin, static_cast<std::streamsize>(text.size() - begin));
    text.resize(begin + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError("cannot read the file", where);
  if (text.size() > max_bytes) {
    const bool large = max_bytes >= std::size_t{1} << 20;
    throw LimitError(fmt::format("the file has more than {} {}", max_bytes >> (large ? 20 : 10), large ? "MiB" : "KiB"), where);
  }
  return text;
}

}  // namespace limes
