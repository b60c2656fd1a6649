#include "algebra/number/ginac_conversion.hpp"

#include <cln/rational_io.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace limes {
namespace {

std::string decimal(const cln::cl_RA& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

TEST(GinacConversion, ThereAndBack) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 500; ++trial) {
    Integer p = int(random() % 100) - 50;
    Integer q = 1 + int(random() % 100);
    for (unsigned i = 0; i < random() % 12; ++i) p = p * 4294967296 + random();
    for (unsigned i = 0; i < random() % 12; ++i) q = q * 4294967296 + random();
    const Rational x(p, q);
    EXPECT_EQ(decimal(to_cln(x)), to_string(x));
    EXPECT_EQ(from_cln(to_cln(x)), x);
    EXPECT_EQ(to_ginac(x), GiNaC::numeric(to_cln(x)));
  }
}

TEST(GinacConversion, EdgesOfMachineIntegers) {
  for (const int bits : {0, 28, 29, 31, 32, 60, 61, 62, 63, 64, 65}) {
    for (const int offset : {-1, 0, 1}) {
      for (const int sign : {-1, 1}) {
        const Rational x(sign * ((Integer(1) << bits) + offset));
        EXPECT_EQ(decimal(to_cln(x)), to_string(x));
        EXPECT_EQ(from_cln(to_cln(x)), x);
      }
    }
  }
}

}  // namespace
}  // namespace limes
