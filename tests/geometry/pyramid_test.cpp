#include "geometry/pyramid.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/unity/filter_file.hpp"
#include "schemes/unity/multiresolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limes {
namespace {

FilterBank bank_for(std::initializer_list<const char*> mask, int extension) {
  std::vector<Rational> coefficients;
  for (const char* text : mask) coefficients.push_back(read_rational(text));
  MultiresolutionOptions options;
  options.extension = extension;
  return find_multiresolution(coefficients, options).bank;
}

struct NamedBank {
  std::string name;
  FilterBank bank;
};

std::vector<NamedBank> banks() {
  std::vector<NamedBank> result;
  for (const int extension : {0, 2, 16}) {
    const std::string suffix = std::to_string(extension);
    result.push_back({"chaikin" + suffix, bank_for({"1/4", "3/4", "3/4", "1/4"}, extension)});
    result.push_back({"four-point" + suffix, bank_for({"-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"}, extension)});
    result.push_back({"cinpact" + suffix, bank_for({"0.0240126", "0", "-0.129882", "0", "0.606154", "0.99909",
                                                    "0.606154", "0", "-0.129882", "0", "0.0240126"},
                                                   extension)});
  }
  result.push_back({"haar", bank_for({"1", "1"}, 0)});
  result.push_back({"asymmetric", bank_for({"1/3", "1", "3/4", "1/5"}, 4)});
  result.push_back({"cdf-9-7", read_filter_file(LIMES_SOURCE_DIR "/examples/multiresolution/cdf-9-7.json")});
  return result;
}

constexpr Boundary boundaries[] = {Boundary::periodic, Boundary::half_sample, Boundary::whole_sample};

Grid random_grid(std::size_t rows, std::size_t columns, std::size_t channels, unsigned seed) {
  std::mt19937 random(seed);
  Grid grid{rows, columns, channels, std::vector<double>(rows * columns * channels)};
  for (double& x : grid.values) x = static_cast<double>(random() % 20001) / 10000 - 1;
  return grid;
}

/// Entry i of A f or B f by the definition: row i begins at column 2i + shift, where P's column j begins at row 2j; with the
/// origin of the fine points that the class documents.
double by_definition(const std::vector<Rational>& filter, int start, long i, const std::vector<double>& f,
                     Boundary boundary) {
  double sum = 0;
  const long n = static_cast<long>(f.size());
  for (std::size_t m = 0; m < filter.size(); ++m) {
    long x = 2 * i + start + static_cast<long>(m);
    while (x < 0 || x >= n) {
      if (boundary == Boundary::periodic) x += x < 0 ? n : -n;
      if (boundary == Boundary::half_sample) x = x < 0 ? -1 - x : 2 * n - 1 - x;
      if (boundary == Boundary::whole_sample) x = x < 0 ? -x : 2 * n - 2 - x;
    }
    sum += approx_double(filter[m]) * f[static_cast<std::size_t>(x)];
  }
  return sum;
}

TEST(Pyramid, CoarsePointsAreThoseOfTheDefinition) {
  for (const auto& [name, bank] : banks()) {
    for (const Boundary boundary : boundaries) {
      const Grid data = random_grid(1, 16, 1, 5);
      const Pyramid pyramid = PyramidTransform(bank, boundary).decompose(data, 1);
      std::size_t length = bank.p.size();
      while (bank.p[length - 1] == 0) --length;
      const int origin = static_cast<int>(length - 1) / 2;
      double largest = 0;
      for (long i = 0; i < 8; ++i) {
        EXPECT_NEAR(pyramid.grid.values[std::size_t(i)],
                    by_definition(bank.a, bank.shift - origin, i, data.values, boundary), 1e-12)
            << name;
        largest = std::max(largest, std::abs(pyramid.grid.values[std::size_t(8 + i)]));
      }
      EXPECT_GT(largest, 0);
      if (boundary != Boundary::periodic) continue;
      // The details are those of B, numbered from another one on.
      bool found = false;
      for (int move = -16; move <= 16 && !found; ++move) {
        found = true;
        for (long i = 0; i < 8; ++i)
          found = found &&
                  std::abs(pyramid.grid.values[std::size_t(8 + i)] -
                           by_definition(bank.b, bank.shift - origin + 2 * move, i, data.values, boundary)) < 1e-12;
      }
      EXPECT_TRUE(found) << name;
    }
  }
}

TEST(Pyramid, RoundTripIsLosslessForAllSizesAndEnds) {
  for (const auto& [name, bank] : banks()) {
    for (const Boundary boundary : boundaries) {
      const PyramidTransform transform(bank, boundary);
      for (const auto& [rows, columns, levels] :
           {std::tuple{1, 2, 1}, {1, 8, 3}, {1, 64, 2}, {1, 1040, 4}, {32, 48, 3}, {128, 64, 1}, {64, 1, 2}}) {
        const Grid data = random_grid(std::size_t(rows), std::size_t(columns), 2, 11);
        const Pyramid pyramid = transform.decompose(data, levels);
        const Pyramid back = transform.reconstruct(pyramid, levels);
        EXPECT_EQ(back.levels, 0);
        EXPECT_LT(difference(back.grid, data, 1).maximum, 1e-11)
            << name << " " << int(boundary) << " " << rows << "x" << columns;
      }
    }
  }
}

TEST(Pyramid, RefinedDataHaveNoDetails) {
  for (const auto& [name, bank] : banks()) {
    const PyramidTransform transform(bank, Boundary::periodic);
    const Grid coarse = random_grid(8, 16, 1, 3);
    const Pyramid refined = transform.reconstruct(transform.without_details(coarse, 2), 2);
    Pyramid again = transform.decompose(refined.grid, 2);
    EXPECT_LT(difference(coarse_grid(again), coarse, 1).maximum, 1e-12) << name;
    EXPECT_EQ(threshold_details(again, 1e-12).kept, 0u) << name;
  }
}

TEST(Pyramid, LinearAndCommutesWithRotationOfClosedData) {
  const FilterBank bank = bank_for({"1/4", "3/4", "3/4", "1/4"}, 2);
  const PyramidTransform transform(bank, Boundary::periodic);
  Grid data = random_grid(1, 32, 1, 8), rotated = data;
  std::rotate(rotated.values.begin(), rotated.values.begin() + 8, rotated.values.end());
  const Grid x = coarse_grid(transform.decompose(data, 2)), y = coarse_grid(transform.decompose(rotated, 2));
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(y.values[i], x.values[(i + 2) % 8], 1e-13);
}

TEST(Pyramid, SumRulesKeepConstantsOutOfTheDetails) {
  for (const Boundary boundary : boundaries) {
    Grid data = random_grid(16, 16, 1, 1);
    data.values.assign(data.values.size(), 3);
    Pyramid pyramid =
        PyramidTransform(bank_for({"-1/16", "0", "9/16", "1", "9/16", "0", "-1/16"}, 4), boundary).decompose(data, 2);
    for (const double x : coarse_grid(pyramid).values) EXPECT_NEAR(x, 3, 1e-12);
    EXPECT_EQ(threshold_details(pyramid, 1e-12).kept, 0u);
  }
}

TEST(Pyramid, TheTransformOfAGridIsTheTensorProduct) {
  const FilterBank bank = bank_for({"1/8", "1/2", "3/4", "1/2", "1/8"}, 2);
  const PyramidTransform transform(bank, Boundary::half_sample);
  const Grid u = random_grid(1, 16, 1, 21), v = random_grid(1, 8, 1, 22);
  Grid data{8, 16, 1, {}};
  for (const double y : v.values) {
    for (const double x : u.values) data.values.push_back(x * y);
  }
  const Pyramid pu = transform.decompose(u, 1), pv = transform.decompose(v, 1), p = transform.decompose(data, 1);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < 16; ++k) EXPECT_NEAR(p.grid.at(0, i, k), pv.grid.values[i] * pu.grid.values[k], 1e-13);
  }
}

TEST(Pyramid, LossyUse) {
  const PyramidTransform transform(bank_for({"1/4", "3/4", "3/4", "1/4"}, 0), Boundary::half_sample);
  const Grid data = random_grid(16, 16, 3, 2);
  const Pyramid pyramid = transform.decompose(data, 2);
  Pyramid x = pyramid;
  EXPECT_EQ(drop_details(x, 1).kept, 3u * (64 - 16));
  EXPECT_EQ(drop_details(x, 5).kept, 0u);
  x = pyramid;
  const DetailCount count = keep_details(x, 0.25, transform.detail_norms(x));
  EXPECT_EQ(count.total, 3u * (256 - 16));
  EXPECT_EQ(count.kept, 180u);
  double before = 0;
  for (const double fraction : {0.1, 0.3, 0.6, 0.9}) {
    x = pyramid;
    keep_details(x, fraction, transform.detail_norms(x));
    const double psnr = difference(transform.reconstruct(x, 2).grid, data, 2).psnr;
    EXPECT_GT(psnr, before);
    before = psnr;
  }
  EXPECT_TRUE(std::isinf(difference(data, data, 2).psnr));
}

TEST(Pyramid, DetailNormsAreTheNormsOfWhatADetailAdds) {
  for (const auto& [name, bank] : banks()) {
    const PyramidTransform transform(bank, Boundary::periodic);
    for (const std::size_t rows : {1u, 256u}) {
      const Pyramid empty =
          transform.without_details(Grid{rows == 1 ? 1u : 64u, 64, 1, std::vector<double>(rows == 1 ? 64 : 4096)}, 2);
      const std::vector<DetailNorms> norms = transform.detail_norms(empty);
      const auto norm_of = [&](std::size_t row, std::size_t column) {
        Pyramid pyramid = empty;
        pyramid.grid.at(0, row, column) = 1;
        double sum = 0;
        for (const double x : transform.reconstruct(pyramid, 2).grid.values) sum += x * x;
        return std::sqrt(sum);
      };
      EXPECT_NEAR(norm_of(0, 100), norms[1].along_row, 1e-12) << name;
      EXPECT_NEAR(norm_of(0, 200), norms[0].along_row, 1e-12) << name;
      if (rows == 1) continue;
      EXPECT_NEAR(norm_of(100, 10), norms[1].along_column, 1e-12) << name;
      EXPECT_NEAR(norm_of(200, 210), norms[0].both, 1e-12) << name;
    }
  }
}

TEST(Pyramid, Errors) {
  const PyramidTransform transform(bank_for({"1/4", "3/4", "3/4", "1/4"}, 0), Boundary::half_sample);
  EXPECT_THROW(transform.decompose(random_grid(1, 12, 1, 1), 3), InputError);
  EXPECT_THROW(transform.decompose(random_grid(3, 8, 1, 1), 1), InputError);
  EXPECT_THROW(transform.decompose(Grid{1, 0, 1, {}}, 1), InputError);
  Pyramid pyramid = transform.decompose(random_grid(8, 8, 1, 1), 1);
  EXPECT_THROW(transform.reconstruct(pyramid, 2), InputError);
  EXPECT_THROW(replace_coarse_grid(pyramid, random_grid(8, 8, 1, 1)), InputError);
  EXPECT_THROW(transform.without_details(random_grid(1024, 1024, 4, 1), 12), LimitError);
}

}  // namespace
}  // namespace limes
