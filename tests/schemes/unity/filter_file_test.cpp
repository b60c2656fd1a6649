#include "schemes/unity/filter_file.hpp"

#include "algebra/error.hpp"
#include "schemes/unity/multiresolution.hpp"

#include <gtest/gtest.h>

namespace limes {
namespace {

FilterBank chaikin() {
  const Rational quarter = Rational(1) / 4;
  return find_multiresolution({quarter, 3 * quarter, 3 * quarter, quarter}, {}).bank;
}

TEST(FilterFile, ComesBack) {
  const FilterBank bank = chaikin(), back = read_filters(filters_to_json(bank, "chaikin"), "x.json");
  EXPECT_EQ(back.p, bank.p);
  EXPECT_EQ(back.a, bank.a);
  EXPECT_EQ(back.b, bank.b);
  EXPECT_EQ(back.q, bank.q);
  EXPECT_EQ(back.shift, bank.shift);
}

TEST(FilterFile, CdfFiltersInvertEachOtherToTheirDigits) {
  const FilterBank bank = read_filter_file(LIMES_SOURCE_DIR "/examples/multiresolution/cdf-9-7.json");
  EXPECT_LT(exact_biorthogonality_defect(bank), power(Rational(10), -13));
}

TEST(FilterFile, ErrorsAreOneLineWithTheFile) {
  const std::string text = filters_to_json(chaikin(), "chaikin");
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string result = text;
    const std::size_t at = result.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return result.replace(at, from.size(), to);
  };
  for (const std::string& bad :
       {std::string(), std::string("[]"), std::string("{"), replaced("limes-filters", "other"),
        replaced("\"version\": 1", "\"version\": 2"), replaced("\"name\"", "\"nome\""),
        replaced("\"shift\": 0", "\"shift\": 1"), replaced("\"shift\": 0", "\"shift\": 2"),
        replaced("\"shift\": 0", "\"shift\": 0.5"), replaced("\"1/4\"", "\"1/0\""), replaced("\"1/4\"", "0.25"),
        replaced("\"1/4\"", "\"1/4\", \"0\""), replaced("\"1/4\"", "\"1/5\""), replaced("\"1/4\"", "\"nan\"")}) {
    try {
      read_filters(bad, "x.json");
      FAIL() << bad;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("x.json")) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace limes
