// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace limes::checker {

using Json = nlohmann::json;

/// JSON without duplicate keys, byte order mark or NUL, of bounded size and depth. \throws Rejected at "json" or "limits"
Json parse_json(std::string_view text);

/// One object with exactly the keys given; every failure names the step and the place.
class Reader {
 public:
  Reader(const Json& json, std::string step, std::string where, std::vector<std::string> keys)
      : json_(json), step_(std::move(step)), where_(std::move(where)) {
    if (!json_.is_object()) fail("is no object");
    for (const auto& key : keys)
      if (!json_.contains(key)) fail("lacks the key " + key);
    for (const auto& [key, value] : json_.items())
      if (std::count(keys.begin(), keys.end(), key) == 0) fail("has the unknown key " + checker::quoted(key));
  }

  [[noreturn]] void fail(const std::string& why) const { throw Rejected{step_, where_ + " " + why}; }
  const Json& at(const char* key) const { return json_.at(key); }

  const std::string& text(const Json& value, const std::string& what) const {
    if (!value.is_string()) fail("needs a string as " + what);
    return value.get_ref<const std::string&>();
  }
  int integer(const Json& value, const std::string& what, int low, int high) const {
    const bool huge = value.is_number_unsigned() && value.get<std::uint64_t>() >= 1u << 31;
    if (!value.is_number_integer() || huge || value.get<std::int64_t>() < low || value.get<std::int64_t>() > high)
      fail("needs an integer from " + std::to_string(low) + " to " + std::to_string(high) + " as " + what);
    return value.get<int>();
  }
  const Json& list(const char* key, std::size_t least, std::size_t most) const {
    if (!at(key).is_array() || at(key).size() < least || at(key).size() > most)
      fail("needs a list of " + std::to_string(least) + " to " + std::to_string(most) + " elements as " + key);
    return at(key);
  }
  /// Whether a text is the first of two choices; it must be one of them.
  bool is_first(const char* key, std::string_view first, std::string_view second) const {
    const std::string& value = text(at(key), key);
    if (value != first && value != second) fail("has an unknown " + std::string(key));
    return value == first;
  }
  Region region(const std::vector<std::string>& parameters, Budget& budget) const {
    Region result;
    const Reader intervals(at("region"), step_, where_ + ": the region", parameters);
    for (const auto& parameter : parameters) {
      const std::string& interval = text(intervals.json_.at(parameter), "the interval of " + parameter);
      budget.work(2000 + 2. * static_cast<double>(interval.size() * interval.size()));
      budget.hold(300 + 2. * static_cast<double>(interval.size()));
      result.push_back(read_interval(interval, step_));
    }
    return result;
  }

 private:
  const Json& json_;
  std::string step_, where_;
};

}  // namespace limes::checker
