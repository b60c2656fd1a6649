#include "geometry/io/image.hpp"

#include "algebra/error.hpp"
#include "geometry/io/pyramid_file.hpp"
#include "schemes/unity/filter_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace limes {
namespace {

class Files : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::path(LIMES_BINARY_DIR) / "image_test" /
                 testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(directory_);
  }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(directory_ / name, std::ios::binary) << bytes;
    return directory_ / name;
  }
  std::filesystem::path directory_;
};

using Image_ = Files;

Image random_image(std::size_t channels, int bits) {
  std::mt19937 random(static_cast<unsigned>(channels) + static_cast<unsigned>(bits));
  Image image{{5, 7, channels, std::vector<double>(35 * channels)}, bits};
  for (double& x : image.grid.values) x = random() % (1u << bits);
  return image;
}

TEST_F(Image_, EveryKindComesBackBitByBit) {
  for (const std::size_t channels : {1u, 2u, 3u, 4u}) {
    for (const int bits : {8, 16}) {
      const Image image = random_image(channels, bits), back = read_png_file(write("x.png", to_png(image)));
      EXPECT_EQ(back.bits, bits);
      EXPECT_EQ(back.grid.channels, channels);
      EXPECT_EQ(back.grid.rows, 5u);
      EXPECT_EQ(back.grid.columns, 7u);
      EXPECT_EQ(back.grid.values, image.grid.values);
    }
  }
}

TEST_F(Image_, SamplesAreRoundedAndClamped) {
  const Image back = read_png_file(write("x.png", to_png(Image{{1, 4, 1, {-3, 0.6, 254.4, 300}}, 8})));
  EXPECT_EQ(back.grid.values, (std::vector<double>{0, 1, 254, 255}));
  EXPECT_NEAR(luminosity(Grid{1, 1, 3, {100, 200, 50}}).values[0], 153, 1e-12);
}

TEST_F(Image_, WhatIsNoImageIsAnError) {
  const std::string bytes = to_png(random_image(3, 8));
  EXPECT_THROW(read_png_file(directory_ / "absent.png"), InputError);
  EXPECT_THROW(read_png_file(directory_), InputError);
  EXPECT_THROW(read_png_file(write("empty.png", "")), InputError);
  EXPECT_THROW(read_png_file(write("text.png", "this is text, no image at all")), InputError);
  for (std::size_t length = 8; length + 16 < bytes.size(); length += 5)
    EXPECT_THROW(read_png_file(write("short.png", bytes.substr(0, length))), InputError) << length;
  std::string damaged = bytes;
  damaged[bytes.size() / 2] = static_cast<char>(damaged[bytes.size() / 2] ^ 1);
  EXPECT_THROW(read_png_file(write("damaged.png", damaged)), InputError);
}

TEST_F(Image_, PyramidFilesComeBackAndDamagedOnesDoNot) {
  const FilterBank bank = read_filter_file(LIMES_SOURCE_DIR "/examples/multiresolution/cdf-9-7.json");
  PyramidFile file{
      {{4, 8, 3, std::vector<double>(96, 0.1)}, 2, Boundary::whole_sample}, DataKind::image, 16, false, bank};
  const std::string bytes = to_bytes(file);
  const PyramidFile back = read_pyramid_file(write("x.pyramid", bytes));
  EXPECT_EQ(back.pyramid.grid.values, file.pyramid.grid.values);
  EXPECT_EQ(back.pyramid.levels, 2);
  EXPECT_EQ(back.pyramid.boundary, Boundary::whole_sample);
  EXPECT_EQ(back.kind, DataKind::image);
  EXPECT_EQ(back.bits, 16);
  EXPECT_EQ(back.filters.q, bank.q);
  EXPECT_TRUE(is_pyramid_file(directory_ / "x.pyramid"));
  EXPECT_FALSE(is_pyramid_file(write("other", "{}")));
  EXPECT_THROW(read_pyramid_file(directory_ / "other"), InputError);
  for (const std::size_t length :
       {bytes.size() - 1, bytes.size() - 8, bytes.find('\n'), bytes.size() / 2, std::size_t{40}})
    EXPECT_THROW(read_pyramid_file(write("short", bytes.substr(0, length))), InputError) << length;
  EXPECT_THROW(read_pyramid_file(write("long", bytes + "x")), InputError);
  std::string damaged = bytes;
  for (std::size_t i = bytes.size() - 8; i < bytes.size(); ++i) damaged[i] = '\xff';  // not a number
  EXPECT_THROW(read_pyramid_file(write("nan", damaged)), InputError);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = bytes;
    text.replace(text.find(from), from.size(), to);
    return write("replaced", text);
  };
  EXPECT_THROW(read_pyramid_file(replaced("\"rows\":4", "\"rows\":5")), InputError);
  EXPECT_THROW(read_pyramid_file(replaced("\"levels\":2", "\"levels\":3")), InputError);
  EXPECT_THROW(read_pyramid_file(replaced("whole-sample", "other-sample")), InputError);
  EXPECT_THROW(read_pyramid_file(replaced("\"image\"", "\"curve\"")), InputError);
}

}  // namespace
}  // namespace limes
