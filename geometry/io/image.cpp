#include "geometry/io/image.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>

namespace limes {
namespace {

constexpr double max_samples = 1 << 28;

struct Failure {
  char message[160] = "damaged data";
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
  std::snprintf(failure->message, sizeof failure->message, "%s", message);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// What libpng holds; freed in every case.
struct Reading {
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Failure failure;
  ~Reading() {
    png_destroy_read_struct(&png, &info, nullptr);
    if (file) std::fclose(file);
  }
};

struct Writing {
  png_structp png = nullptr;
  png_infop info = nullptr;
  Failure failure;
  ~Writing() { png_destroy_write_struct(&png, &info); }
};

// setjmp lives in functions without objects that have destructors.

bool read_header(Reading& r) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_init_io(r.png, r.file);
  png_set_user_limits(r.png, 1 << 28, 1 << 28);
  png_read_info(r.png, r.info);
  if (png_get_color_type(r.png, r.info) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(r.png);
  if (png_get_valid(r.png, r.info, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(r.png);
  if (png_get_bit_depth(r.png, r.info) < 8) png_set_expand_gray_1_2_4_to_8(r.png);
  png_set_interlace_handling(r.png);
  png_read_update_info(r.png, r.info);
  return true;
}

bool read_rows(Reading& r, png_bytepp rows) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_read_image(r.png, rows);
  png_read_end(r.png, nullptr);
  return true;
}

void append_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

bool write_rows(Writing& w, std::string& out, const Image& image, png_bytepp rows) {
  constexpr int types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                           PNG_COLOR_TYPE_RGB_ALPHA};
  if (setjmp(png_jmpbuf(w.png))) return false;
  png_set_write_fn(w.png, &out, append_bytes, nullptr);
  png_set_IHDR(w.png, w.info, static_cast<png_uint_32>(image.grid.columns), static_cast<png_uint_32>(image.grid.rows),
               image.bits, types[image.grid.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(w.png, w.info);
  png_write_image(w.png, rows);
  png_write_end(w.png, nullptr);
  return true;
}

}  // namespace

Image read_png_file(const std::filesystem::path& file) {
  const SourcePosition where{file.string(), 0, 0};
  Reading r;
  if (std::filesystem::is_directory(file) || !(r.file = std::fopen(file.c_str(), "rb")))
    throw InputError("cannot read the file", where);
  png_byte signature[8] = {};
  if (std::fread(signature, 1, 8, r.file) != 8 || png_sig_cmp(signature, 0, 8) != 0)
    throw InputError("this is no PNG image", where);
  r.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &r.failure, on_error, on_warning);
  if (r.png) r.info = png_create_info_struct(r.png);
  if (!r.info) throw std::bad_alloc();
  png_set_sig_bytes(r.png, 8);
  std::rewind(r.file);
  std::fseek(r.file, 8, SEEK_SET);
  if (!read_header(r)) throw InputError(fmt::format("a damaged PNG image: {}", r.failure.message), where);
  Image image;
  image.bits = png_get_bit_depth(r.png, r.info);
  image.grid.rows = png_get_image_height(r.png, r.info);
  image.grid.columns = png_get_image_width(r.png, r.info);
  image.grid.channels = png_get_channels(r.png, r.info);
  const Grid& g = image.grid;
  if (double(g.rows) * double(g.columns) * double(g.channels) > max_samples)
    throw LimitError(fmt::format("an image of {} x {} pixels: 2^28 samples are the limit", g.columns, g.rows), where);
  const std::size_t row_bytes = png_get_rowbytes(r.png, r.info);
  std::vector<png_byte> bytes(row_bytes * g.rows);
  std::vector<png_bytep> rows(g.rows);
  for (std::size_t i = 0; i < g.rows; ++i) rows[i] = bytes.data() + i * row_bytes;
  if (!read_rows(r, rows.data())) throw InputError(fmt::format("a damaged PNG image: {}", r.failure.message), where);
  image.grid.values.resize(g.rows * g.columns * g.channels);
  for (std::size_t i = 0; i < g.rows; ++i) {
    const png_byte* at = rows[i];
    for (std::size_t k = 0; k < g.columns; ++k) {
      for (std::size_t channel = 0; channel < g.channels; ++channel) {
        image.grid.at(channel, i, k) = image.bits == 16 ? at[0] * 256 + at[1] : at[0];
        at += image.bits / 8;
      }
    }
  }
  return image;
}

std::string to_png(const Image& image) {
  const Grid& g = image.grid;
  if (g.channels < 1 || g.channels > 4 || (image.bits != 8 && image.bits != 16) || g.rows == 0 || g.columns == 0)
    throw DomainError(
        fmt::format("a PNG image of {} x {} with {} channels of {} bits", g.columns, g.rows, g.channels, image.bits));
  const std::size_t row_bytes = g.columns * g.channels * static_cast<std::size_t>(image.bits / 8);
  std::vector<png_byte> bytes;
  bytes.reserve(row_bytes * g.rows);
  const double most = image.bits == 16 ? 65535 : 255;
  for (std::size_t i = 0; i < g.rows; ++i) {
    for (std::size_t k = 0; k < g.columns; ++k) {
      for (std::size_t channel = 0; channel < g.channels; ++channel) {
        const auto sample = static_cast<unsigned>(std::clamp(std::round(g.at(channel, i, k)), 0.0, most));
        if (image.bits == 16) bytes.push_back(static_cast<png_byte>(sample >> 8));
        bytes.push_back(static_cast<png_byte>(sample & 255));
      }
    }
  }
  std::vector<png_bytep> rows(g.rows);
  for (std::size_t i = 0; i < g.rows; ++i) rows[i] = bytes.data() + i * row_bytes;
  Writing w;
  w.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &w.failure, on_error, on_warning);
  if (w.png) w.info = png_create_info_struct(w.png);
  if (!w.info) throw std::bad_alloc();
  std::string out;
  if (!write_rows(w, out, image, rows.data())) throw InternalError(fmt::format("libpng: {}", w.failure.message));
  return out;
}

Grid luminosity(const Grid& image) {
  Grid result{image.rows, image.columns, 1, std::vector<double>(image.rows * image.columns)};
  const std::size_t size = result.values.size();
  for (std::size_t i = 0; i < size; ++i) {
    const double* x = &image.values[i];
    result.values[i] = image.channels < 3 ? *x : 0.299 * x[0] + 0.587 * x[size] + 0.114 * x[2 * size];
  }
  return result;
}

}  // namespace limes
