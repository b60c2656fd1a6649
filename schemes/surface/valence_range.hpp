#pragma once

#include <optional>
#include <string>

namespace limes {

/// The valences first, first + 1, .., last of extraordinary vertices (faces); without a last one all from the first on.
struct ValenceRange {
  int first = 3;
  std::optional<int> last;
};

/// No claim names a larger valence.
inline constexpr int max_claimed_valence = 1000;

/// "5", "[3, 50]", "[3, inf)".
std::string to_string(const ValenceRange& valences);
/// Reads what to_string() writes, and "3..50", "3.." too. \throws InputError
ValenceRange read_valences(const std::string& text);

}  // namespace limes
