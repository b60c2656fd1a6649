#include "geometry/io/csv.hpp"

#include "algebra/error.hpp"
#include "tests/geometry/data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace limes {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::string& text) {
  try {
    read_csv(text, "data.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Csv, ReadsRowsOfNumbers) {
  const NumberTable table = read_csv("\xEF\xBB\xBF# x, y\n0, -1.5\r\n\n 1/3 ,2e-3\n", "data.csv");
  EXPECT_EQ(table.columns, 2);
  EXPECT_EQ(table.values, (std::vector<double>{0, -1.5, 1.0 / 3, 0.002}));
  EXPECT_EQ(table.lines, (std::vector<int>{2, 4}));
}

TEST(Csv, PointsAreReadBackBitByBit) {
  std::vector<double> coordinates = test::random_polygon(3, 200, false, 11).coordinates();
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    coordinates[k] = std::ldexp(coordinates[k], static_cast<int>(k % 600) - 300);
  coordinates.insert(coordinates.end(), {1.7976931348623157e308, 2.2250738585072014e-308, -0.0});
  EXPECT_EQ(read_csv(to_csv(Polygon(3, coordinates)), "data.csv").values, coordinates);
  EXPECT_EQ(to_csv(Polygon(2, {-0.0, 0.1, 1, 2})), "0,0.1\n1,2\n");
}

TEST(Csv, ErrorsNameFileLineAndReason) {
  EXPECT_EQ(error_of("0,0\n1,a\n"), "data.csv:2:3: 'a' is not a number (comments start with #)");
  EXPECT_EQ(error_of("x,y\n0,0\n"), "data.csv:1:1: 'x' is not a number (comments start with #)");
  EXPECT_EQ(error_of("0,0\n\n1,nan\n"), "data.csv:3:3: 'nan' is not a finite number");
  EXPECT_EQ(error_of("-inf,0\n"), "data.csv:1:1: '-inf' is not a finite number");
  EXPECT_EQ(error_of("1,2\n1,2,3\n"), "data.csv:2: 3 columns, but line 1 has 2");
  EXPECT_EQ(error_of("1,\n"), "data.csv:1:3: a number is missing");
  EXPECT_EQ(error_of("1 2\n"), "data.csv:1:1: '1 2' is not a number (comments start with #)");
  EXPECT_EQ(error_of(""), "data.csv: the file has no numbers");
  EXPECT_EQ(error_of("# nothing\n\n"), "data.csv: the file has no numbers");
  EXPECT_THAT(error_of("1e400,0\n"), HasSubstr("data.csv:1:1: '1e400' exceeds the range of double precision"));
  EXPECT_THAT(error_of("1/0\n"), HasSubstr("data.csv:1:1: "));
  EXPECT_THAT(error_of("1e999999999\n"), HasSubstr("data.csv:1:1: "));
  EXPECT_THAT(error_of(std::string(5000, '7')), HasSubstr("more than 1000 characters"));
  EXPECT_THAT(error_of(std::string(100, ',')), HasSubstr("data.csv:1"));
  EXPECT_THAT(error_of(std::string("1,2\n3,\0\n", 8)), HasSubstr("data.csv:2:3: "));
}

TEST(Csv, FilesThatCannotBeReadAreErrors) {
  EXPECT_THROW(read_csv_file("/nonexistent/points.csv"), InputError);
  EXPECT_THROW(read_csv_file("/"), InputError);
}

TEST(Csv, KnotsMustFitThePolygon) {
  const Polygon open(1, {5, 6, 7}), closed(1, {5, 6, 7}, true);
  EXPECT_EQ(knots_from(read_csv("0\n1/2\n2\n", "knots.csv"), open), (std::vector<double>{0, 0.5, 2}));
  EXPECT_EQ(knots_from(read_csv("0\n1\n2\n9\n", "knots.csv"), closed).back(), 9);
  const auto error = [&](const std::string& text, const Polygon& polygon) -> std::string {
    try {
      knots_from(read_csv(text, "knots.csv"), polygon);
    } catch (const InputError& found) {
      return found.what();
    }
    return "accepted";
  };
  EXPECT_EQ(error("0\n# again\n0\n1\n", open), "knots.csv:3: knots must increase strictly, but 0 follows 0");
  EXPECT_EQ(error("0\n2\n1\n", open), "knots.csv:3: knots must increase strictly, but 1 follows 2");
  EXPECT_EQ(error("0,1\n1,2\n2,3\n", open), "knots.csv:1: 2 columns, but knots are one number a line");
  EXPECT_EQ(error("0\n1\n", open), "knots.csv: 2 knots, but the open polygon of 3 points needs 3");
  EXPECT_EQ(error("0\n1\n2\n", closed),
            "knots.csv: 3 knots, but the closed polygon of 3 points needs 4 (the last one ends the period)");
}

}  // namespace
}  // namespace limes
