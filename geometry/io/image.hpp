#pragma once

#include "geometry/grid.hpp"

#include <filesystem>
#include <string>

namespace limes {

/// An image as numbers: one channel (grey), two (grey and opacity), three (red, green, blue) or four (and opacity), the
/// samples as the file has them, from 0 to 2^bits - 1.
struct Image {
  Grid grid;
  /// 8 or 16
  int bits = 8;
};

/// Reads a PNG file without changing a sample: no gamma, no background. Palettes become colours, 1 to 4 bits of grey become
/// 8 bits (0 to 255). \throws InputError: the file cannot be read, is no PNG, is damaged; LimitError above 2^28 samples
Image read_png_file(const std::filesystem::path& file);

/// The bytes of a PNG file: samples rounded to the nearest integer and clamped. \throws DomainError: not 1 to 4 channels, not
/// 8 or 16 bits, an empty image
std::string to_png(const Image& image);

/// 0.299 red + 0.587 green + 0.114 blue (ITU-R BT.601); the first channel of a grey image.
Grid luminosity(const Grid& image);

}  // namespace limes
