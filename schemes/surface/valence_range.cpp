#include "schemes/surface/valence_range.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <charconv>

namespace limes {

std::string to_string(const ValenceRange& valences) {
  if (!valences.last) return fmt::format("[{}, inf)", valences.first);
  return *valences.last == valences.first ? fmt::format("{}", valences.first) : fmt::format("[{}, {}]", valences.first, *valences.last);
}

ValenceRange read_valences(const std::string& text) {
  const auto fail = [&]() -> InputError {
    return InputError(fmt::format("valence '{}': expected N, [N, M], [N, inf) or N..M with 3 <= N <= M <= {}", text, max_claimed_valence));
  };
  const auto number = [&](std::string_view digits) {
    int n = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    if (error != std::errc{} || end != digits.data() + digits.size() || n < 3 || n > max_claimed_valence) throw fail();
    return n;
  };
  std::string_view rest = text;
  const bool bracket = rest.starts_with('[');
  std::string_view separator = "..";
  if (bracket) {
    separator = ",";
    if (!rest.ends_with(']') && !rest.ends_with("inf)")) throw fail();
    rest = rest.substr(1, rest.size() - 2);
  }
  const std::size_t place = rest.find(separator);
  if (place == std::string_view::npos) {
    if (bracket) throw fail();
    return {number(rest), number(rest)};
  }
  std::string_view upper = rest.substr(place + separator.size());
  while (bracket && upper.starts_with(' ')) upper.remove_prefix(1);
  ValenceRange result{number(rest.substr(0, place)), std::nullopt};
  const bool infinite = bracket ? text.ends_with(')') : upper.empty();
  if (infinite && bracket && upper != "inf") throw fail();
  if (!infinite) result.last = number(upper);
  if (result.last && *result.last < result.first) throw fail();
  return result;
}

}  // namespace limes
