#pragma once

#include "schemes/unity/filter_bank.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace limes {

/// Filters as a JSON file (docs/multiresolution.md): {"format": "limes-filters", "version": 1, "name", "p", "a", "b", "q",
/// "shift", "extension"}, the entries as strings "p/q" or decimals, which are exact.
std::string filters_to_json(const FilterBank& bank, const std::string& name);

/// \throws InputError "file:line: reason": no JSON, a missing, unknown or malformed key, an odd length, filters of different
/// lengths, an entry of the four products of eq. 34 that differs from that of the identity by more than 10^-6.
FilterBank read_filter_file(const std::filesystem::path& file);
/// The same from a text; `file` only names it in messages.
FilterBank read_filters(std::string_view text, const std::filesystem::path& file);

}  // namespace limes
