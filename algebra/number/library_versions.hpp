#pragma once

#include <string>
#include <utility>
#include <vector>

namespace limes {

/// Names and versions of the libraries that compute, as they are linked: GMP, MPFR, FLINT, Arb, CLN, GiNaC.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace limes
