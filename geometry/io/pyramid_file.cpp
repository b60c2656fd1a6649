#include "geometry/io/pyramid_file.hpp"

#include "algebra/error.hpp"
#include "schemes/unity/filter_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

namespace limes {
namespace {

constexpr std::string_view beginning = R"({"format":"limes-pyramid",)";
constexpr std::size_t max_header = std::size_t{16} << 20;
constexpr double max_numbers = 2147483648.0;
constexpr const char* kinds[] = {"curve", "heights", "image"};
constexpr const char* boundaries[] = {"periodic", "half-sample", "whole-sample"};

/// Between the file's byte order and this machine's.
std::uint64_t little_endian(std::uint64_t x) {
  if constexpr (std::endian::native == std::endian::little) return x;
  std::uint64_t result = 0;
  for (int i = 0; i < 8; ++i, x >>= 8) result = result << 8 | (x & 255);
  return result;
}

std::size_t choice(const nlohmann::json& json, const char* key, const auto& names, const SourcePosition& where) {
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (json.contains(key) && json[key] == names[i]) return i;
  }
  throw InputError(fmt::format("the pyramid's header lacks a known \"{}\"", key), where);
}

std::size_t integer(const nlohmann::json& json, const char* key, std::uint64_t low, std::uint64_t high,
                    const SourcePosition& where) {
  if (!json.contains(key) || !json[key].is_number_unsigned() || json[key].get<std::uint64_t>() < low ||
      json[key].get<std::uint64_t>() > high)
    throw InputError(fmt::format("the pyramid's header needs \"{}\" from {} to {}", key, low, high), where);
  return json[key].get<std::size_t>();
}

}  // namespace

std::string to_bytes(const PyramidFile& file) {
  const Grid& grid = file.pyramid.grid;
  const nlohmann::ordered_json header{{"format", "limes-pyramid"},
                                      {"version", 1},
                                      {"kind", kinds[int(file.kind)]},
                                      {"rows", grid.rows},
                                      {"columns", grid.columns},
                                      {"channels", grid.channels},
                                      {"levels", file.pyramid.levels},
                                      {"boundary", boundaries[int(file.pyramid.boundary)]},
                                      {"bits", file.bits},
                                      {"homogeneous", file.homogeneous},
                                      {"filters", nlohmann::ordered_json::parse(filters_to_json(file.filters, ""))}};
  std::string bytes = header.dump() + "\n";
  const std::size_t begin = bytes.size();
  bytes.resize(begin + 8 * grid.values.size());
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    const std::uint64_t number = little_endian(std::bit_cast<std::uint64_t>(grid.values[i]));
    std::memcpy(bytes.data() + begin + 8 * i, &number, 8);
  }
  return bytes;
}

bool is_pyramid_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(beginning.size(), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  return stream && text == beginning;
}

PyramidFile read_pyramid_file(const std::filesystem::path& file) {
  const SourcePosition where{file.string(), 0, 0};
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !is_pyramid_file(file)) throw InputError("no pyramid that limes decompose has written", where);
  std::string line;
  for (char c; line.size() < max_header && stream.get(c) && c != '\n';) line += c;
  const nlohmann::json json = nlohmann::json::parse(line, [&](int depth, auto, auto&) {
    if (depth > 8) throw InputError("a damaged pyramid: its header is nested too deep", where);
    return true;
  }, false);
  if (!json.is_object()) throw InputError("the pyramid's header is no JSON", where);
  integer(json, "version", 1, 1, where);
  PyramidFile result;
  result.kind = static_cast<DataKind>(choice(json, "kind", kinds, where));
  result.pyramid.boundary = static_cast<Boundary>(choice(json, "boundary", boundaries, where));
  result.pyramid.levels = static_cast<int>(integer(json, "levels", 0, max_pyramid_levels, where));
  result.bits = static_cast<int>(integer(json, "bits", 8, 16, where));
  if (!json.contains("homogeneous") || !json["homogeneous"].is_boolean())
    throw InputError("the pyramid's header lacks \"homogeneous\"", where);
  result.homogeneous = json["homogeneous"].get<bool>();
  Grid& grid = result.pyramid.grid;
  grid.rows = integer(json, "rows", 1, 1u << 31, where);
  grid.columns = integer(json, "columns", 1, 1u << 31, where);
  grid.channels = integer(json, "channels", 1, 64, where);
  const double numbers = double(grid.rows) * double(grid.columns) * double(grid.channels);
  std::error_code error;
  const auto size = static_cast<double>(std::filesystem::file_size(file, error));
  if (error || numbers > max_numbers || size != static_cast<double>(line.size()) + 1 + 8 * numbers)
    throw InputError(
        fmt::format("a damaged pyramid: its header announces {:.0f} numbers, the file has another size", numbers),
        where);
  for (const std::size_t length : {grid.rows, grid.columns}) {
    if (length != 1 && length % (std::size_t{1} << result.pyramid.levels) != 0)
      throw InputError(fmt::format("a damaged pyramid: {} levels of {}", result.pyramid.levels, length), where);
  }
  const std::size_t color_channels = grid.channels - (result.homogeneous ? 1 : 0);
  const bool fits = result.kind == DataKind::curve     ? grid.rows == 1 && color_channels >= 1
                    : result.kind == DataKind::heights ? color_channels == 1
                                                       : color_channels >= 1 && color_channels <= 4;
  if (!fits) throw InputError("a damaged pyramid: the number of channels does not fit its kind", where);
  if (!json.contains("filters")) throw InputError("the pyramid's header lacks \"filters\"", where);
  result.filters = read_filters(json["filters"].dump(), file);
  grid.values.resize(static_cast<std::size_t>(numbers));
  stream.read(reinterpret_cast<char*>(grid.values.data()), static_cast<std::streamsize>(8 * grid.values.size()));
  if (!stream) throw InputError("the pyramid cannot be read to its end", where);
  for (double& x : grid.values) {
    x = std::bit_cast<double>(little_endian(std::bit_cast<std::uint64_t>(x)));
    if (!std::isfinite(x)) throw InputError("the pyramid holds a number that is not finite", where);
  }
  return result;
}

}  // namespace limes
