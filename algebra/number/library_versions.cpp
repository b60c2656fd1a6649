#include "algebra/number/library_versions.hpp"

#include <arb.h>
#include <cln/version.h>
#include <flint/flint.h>
#include <ginac/ginac.h>
#include <gmp.h>
#include <mpfr.h>

#include <fmt/format.h>

namespace limes {

std::vector<std::pair<std::string, std::string>> library_versions() {
  return {{"GMP", gmp_version},
          {"MPFR", mpfr_get_version()},
          {"FLINT", flint_version},
          {"Arb", arb_version},
          {"CLN", fmt::format("{}.{}.{}", cln::version_major, cln::version_minor, cln::version_patchlevel)},
          {"GiNaC", fmt::format("{}.{}.{}", GiNaC::version_major, GiNaC::version_minor, GiNaC::version_micro)}};
}

}  // namespace limes
