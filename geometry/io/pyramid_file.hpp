#pragma once

#include "geometry/pyramid.hpp"

#include <filesystem>
#include <string>

namespace limes {

/// What the data of a pyramid were made from, and become again.
enum class DataKind { curve, heights, image };

/// A pyramid in a file (docs/multiresolution.md): one line of JSON, then the numbers of Pyramid::grid as IEEE doubles, least
/// byte first.
struct PyramidFile {
  Pyramid pyramid;
  DataKind kind = DataKind::curve;
  /// Of an image: 8 or 16.
  int bits = 8;
  /// The last channel is a weight by which the others are multiplied.
  bool homogeneous = false;
  /// The filters that made it.
  FilterBank filters;
};

std::string to_bytes(const PyramidFile& file);

/// Whether a file begins as a pyramid does.
bool is_pyramid_file(const std::filesystem::path& file);
/// \throws InputError: the file cannot be read, is no pyramid, is too short or too long, has a number that is not finite
PyramidFile read_pyramid_file(const std::filesystem::path& file);

}  // namespace limes
