// SPDX-License-Identifier: MIT
#include "proofs/checker/interval.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

mpz_class read_natural(std::string_view digits, std::string_view whole, const std::string& step) {
  const bool all_digits = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (digits.empty() || !all_digits) throw Rejected{step, quoted(whole) + " is not a rational or interval"};
  if (digits.size() > 10000) throw Rejected{step, quoted(whole) + " has more than 10000 digits"};
  return mpz_class(std::string(digits), 10);
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text.substr(0, 40)) result += c >= ' ' && c <= '~' && c != '"' && c != '\\' ? c : '?';
  return result + (text.size() > 40 ? "...\"" : "\"");
}

mpq_class read_rational(std::string_view text, const std::string& step) {
  const bool negative = text.starts_with('-');
  const std::string_view digits = text.substr(negative ? 1 : 0);
  const auto slash = digits.find('/');
  const std::string_view denominator = slash == std::string_view::npos ? "1" : digits.substr(slash + 1);
  mpq_class result(read_natural(digits.substr(0, slash), text, step), read_natural(denominator, text, step));
  if (result.get_den() == 0) throw Rejected{step, quoted(text) + " has denominator zero"};
  result.canonicalize();
  return negative ? mpq_class(-result) : result;
}

Interval read_interval(std::string_view text, const std::string& step) {
  if (!text.starts_with('[') && !text.starts_with('(')) {
    const mpq_class point = read_rational(text, step);
    return {{point, false}, {point, true}, std::string(text)};
  }
  const auto comma = text.find(',');
  if ((!text.ends_with(']') && !text.ends_with(')')) || comma == std::string_view::npos)
    throw Rejected{step, quoted(text) + " is not an interval"};
  std::string_view upper = text.substr(comma + 1, text.size() - comma - 2);
  if (upper.starts_with(' ')) upper.remove_prefix(1);
  const Cut low{read_rational(text.substr(1, comma - 1), step), text.starts_with('(')};
  const Cut high{read_rational(upper, step), text.ends_with(']')};
  if (low.value >= high.value) throw Rejected{step, "the ends of " + quoted(text) + " are not in order"};
  return {low, high, std::string(text)};
}

}  // namespace limes::checker
