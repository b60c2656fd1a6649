#include "schemes/nonstationary/exponential_function.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace limes {
namespace {

using Wave = ExponentialFunction::Wave;

constexpr const char* wave_names[] = {"", "cos", "sin", "cosh", "sinh"};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A number of at most two digits that is at most 16; `text` may be empty.
int small_number(const std::string& text, int otherwise, const std::string& whole) {
  const int value = text.empty() ? otherwise : std::stoi(text);
  if (value < 1 || value > 16) throw InputError(fmt::format("'{}': powers and frequencies go from 1 to 16", whole));
  return value;
}

}  // namespace

std::string to_string(AngleType type) { return type == AngleType::trigonometric ? "trigonometric" : "hyperbolic"; }

bool fits(const ExponentialFunction& function, AngleType type) {
  const bool hyperbolic = function.wave == Wave::cosh || function.wave == Wave::sinh;
  return function.wave == Wave::none || hyperbolic == (type == AngleType::hyperbolic);
}

std::string to_string(const ExponentialFunction& function) {
  const std::string power = function.degree == 0   ? ""
                            : function.degree == 1 ? "y"
                                                   : fmt::format("y^{}", function.degree);
  if (function.wave == Wave::none) return power.empty() ? "1" : power;
  const std::string wave = wave_names[static_cast<int>(function.wave)];
  return fmt::format("{}{}{}{}", power, power.empty() ? "" : " ", wave,
                     function.frequency == 1 ? "" : fmt::format("({}y)", function.frequency));
}

std::string to_string(const std::vector<ExponentialFunction>& functions) {
  std::string text;
  for (const ExponentialFunction& function : functions) text += (text.empty() ? "" : ", ") + to_string(function);
  return "{" + text + "}";
}

ExponentialFunction read_exponential_function(const std::string& text) {
  static const std::regex form(R"((1)|(y(?:\^(\d{1,2}))?)?\s*(?:(cosh|sinh|cos|sin)(?:\((\d{0,2})y\))?)?)");
  const std::string function = trimmed(text);
  std::smatch match;
  if (function.empty() || function.size() > 40 || !std::regex_match(function, match, form)) {
    throw InputError(
        fmt::format("'{}' is no function: expected such as 1, y, y^2, cos, sin(2y), y cosh", function.substr(0, 40)));
  }
  ExponentialFunction result;
  if (match[2].matched) result.degree = small_number(match[3], 1, function);
  if (!match[4].matched) return result;
  const auto* wave = std::find(std::begin(wave_names), std::end(wave_names), match[4].str());
  result.wave = static_cast<Wave>(wave - std::begin(wave_names));
  result.frequency = small_number(match[5], 1, function);
  return result;
}

std::vector<ExponentialFunction> read_exponential_functions(const std::string& text) {
  const std::string set = trimmed(text);
  if (set.size() < 3 || set.front() != '{' || set.back() != '}') {
    throw InputError(
        fmt::format("expected a set of functions such as {{1, y, cos, sin}} but found '{}'", set.substr(0, 40)));
  }
  std::vector<ExponentialFunction> functions;
  for (std::size_t begin = 1; begin < set.size();) {
    const std::size_t end = std::min(set.find(',', begin), set.size() - 1);
    const ExponentialFunction function = read_exponential_function(set.substr(begin, end - begin));
    if (std::find(functions.begin(), functions.end(), function) != functions.end()) {
      throw InputError(fmt::format("the function {} occurs twice", to_string(function)));
    }
    if (functions.size() == 16) throw LimitError("more than 16 functions");
    functions.push_back(function);
    begin = end + 1;
  }
  return functions;
}

}  // namespace limes
