// The reader of scheme files on arbitrary bytes: a scheme, or an InputError of one line. Everything else is a finding.
#include "algebra/error.hpp"
#include "schemes/scheme.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const limes::Scheme scheme = limes::read_scheme({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
    if (scheme.name.empty() || scheme.mask.symbol.is_zero() != scheme.surface.has_value()) std::abort();
    for (const limes::Claim& claim : scheme.claims) {
      if (claim.region.size() != scheme.parameters.size()) std::abort();
    }
  } catch (const limes::InputError& error) {
    if (error.reason().empty()) std::abort();
  }
  return 0;
}
