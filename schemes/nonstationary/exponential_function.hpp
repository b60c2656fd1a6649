#pragma once

#include <string>
#include <vector>

namespace limes {

/// What the angle theta of a nonstationary scheme means: cos(theta ..) or cosh(theta ..).
enum class AngleType { trigonometric, hyperbolic };

std::string to_string(AngleType type);

/// y^degree w(frequency theta y), where w is 1 (then frequency = 0), cos, sin, cosh or sinh.
struct ExponentialFunction {
  enum class Wave { none, cos, sin, cosh, sinh };
  int degree = 0;
  int frequency = 0;
  Wave wave = Wave::none;
  friend bool operator==(const ExponentialFunction&, const ExponentialFunction&) = default;
};

/// Whether the function belongs to schemes of this type: powers belong to both.
bool fits(const ExponentialFunction& function, AngleType type);

/// "1", "y^2", "cos", "y sin(3y)"; theta is not written.
std::string to_string(const ExponentialFunction& function);
/// "{1, y, cos, sin}"
std::string to_string(const std::vector<ExponentialFunction>& functions);

/// Reads one function as to_string writes it; degree and frequency at most 16. \throws InputError
ExponentialFunction read_exponential_function(const std::string& text);
/// Reads "{1, y, cos, sin}", 1 to 16 different functions. \throws InputError
std::vector<ExponentialFunction> read_exponential_functions(const std::string& text);

}  // namespace limes
