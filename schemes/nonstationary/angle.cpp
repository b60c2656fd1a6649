#include "schemes/nonstationary/angle.hpp"

#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"
#include "algebra/number/elementary.hpp"

#include <fmt/format.h>

namespace limes {

std::pair<Rational, Rational> read_angle(std::string_view text) {
  const RationalFunction value = read_rational_function(text, {"pi"});
  if (!value.is_polynomial() || value.numerator().degree(0) > 1) {
    throw InputError(fmt::format("'{}' is no angle: expected a + b*pi with rational a, b", text));
  }
  const Rational scale = value.denominator().constant_value();
  const Polynomial linear = value.numerator().univariate(0);
  return {linear.coefficient(0) / scale, linear.coefficient(1) / scale};
}

namespace {

/// a + b pi, enclosed; exact when b = 0.
Interval read_end(std::string_view text) {
  const auto [a, b] = read_angle(text);
  if (b == 0) return Interval::point(a);
  const Interval pi = pi_enclosure();
  return b > 0 ? Interval{a + b * pi.lower, a + b * pi.upper} : Interval{a + b * pi.upper, a + b * pi.lower};
}

}  // namespace

Interval read_angles(std::string_view text) {
  if (text.find("pi") == std::string_view::npos) return read_interval(text);
  const bool bracketed =
      !text.empty() && (text.front() == '[' || text.front() == '(') && text.find(',') != std::string_view::npos;
  if (!bracketed) return read_end(text);
  const std::size_t comma = text.find(',');
  if (text.back() != ']' && text.back() != ')')
    throw InputError(fmt::format("the interval '{}' ends without a bracket", text));
  const Interval lower = read_end(text.substr(1, comma - 1));
  const Interval upper = read_end(text.substr(comma + 1, text.size() - comma - 2));
  const Interval result{lower.lower, upper.upper, text.front() == '(' && lower.is_point(),
                        text.back() == ')' && upper.is_point()};
  if (lower.lower >= upper.lower) throw InputError(fmt::format("the interval '{}' is empty or a single angle", text));
  return result;
}

std::optional<Rational> single_angle(const Interval& angles) {
  if (angles.is_point() || angles.width() < power(Rational(2), -100)) return angles.midpoint();
  return std::nullopt;
}

}  // namespace limes
