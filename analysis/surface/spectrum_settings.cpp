#include "analysis/surface/spectrum_settings.hpp"

#include "algebra/error.hpp"
#include "algebra/number/elementary.hpp"
#include "algebra/number/read_rational.hpp"
#include "analysis/surface/cosine_field.hpp"
#include "schemes/nonstationary/angle.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

/// cos(turns pi) when it is rational (Niven: then the denominator of turns is at most 3).
std::optional<Rational> rational_cosine(const Rational& turns) {
  if (denominator(turns) > 3) return std::nullopt;
  const Polynomial minimal = minimal_polynomial_of_cosine(2 * static_cast<int>(denominator(turns)), static_cast<int>(numerator(turns)));
  return -minimal.coefficient(0);
}

}  // namespace

LevelParameter SpectrumSettings::at_level(int k) const {
  if (mu) return {mu, {}};
  const Rational scale = power(Rational(2), -(k + 1));
  if (rational == 0 && type == AngleType::trigonometric) {
    if (const auto value = rational_cosine(turns * scale)) return {value, {}};
  }
  return {std::nullopt, [*this, scale](int bits) {
            Interval x = Interval::point(rational * scale);
            if (turns != 0) {
              const Interval pi = pi_enclosure(bits + 16);
              x = {x.lower + turns * scale * (turns > 0 ? pi.lower : pi.upper), x.upper + turns * scale * (turns > 0 ? pi.upper : pi.lower)};
            }
            // Both are monotone on [0, pi].
            if (type == AngleType::hyperbolic) return Interval{cosh_enclosure(x.lower, bits).lower, cosh_enclosure(x.upper, bits).upper};
            return Interval{cos_enclosure(x.upper, bits).lower, cos_enclosure(x.lower, bits).upper};
          }};
}

LevelParameter SpectrumSettings::from_level(int k) const {
  if (mu) return {mu, {}};
  return {std::nullopt, [first = at_level(k)](int bits) {
            const Interval x = first.exact ? Interval::point(*first.exact) : first.enclosure(bits);
            return Interval{std::min(x.lower, Rational(1)), std::max(x.upper, Rational(1))};
          }};
}

SpectrumSettings spectrum_settings(const Scheme& scheme, const std::vector<std::string>& given) {
  if (!scheme.surface) throw InputError(fmt::format("{} is no surface scheme", scheme.name));
  const MaskSequence& sequence = scheme.surface->sequence;
  SpectrumSettings result;
  std::vector<std::string> settings = given;
  result.mu = take_setting(settings, sequence.level_parameter);
  std::optional<std::string> angle, type;
  for (const std::string& setting : settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string name = setting.substr(0, equals), value = setting.substr(std::min(equals + 1, setting.size()));
    std::optional<std::string>* place = name == sequence.angle ? &angle : name == "type" ? &type : nullptr;
    if (!place || value.empty())
      throw InputError(fmt::format("--param {}: expected {}=ANGLE, type=TYPE or {}=NUMBER", setting, sequence.angle, sequence.level_parameter));
    if (*place) throw InputError(fmt::format("--param {}: given twice", setting));
    *place = value;
  }
  if (result.mu) {
    if (angle || type) throw InputError(fmt::format("--param {}: with an angle or a type there is nothing left to say", sequence.level_parameter));
    return result;
  }
  if (type && *type != "trigonometric" && *type != "hyperbolic" && *type != "polynomial")
    throw InputError(fmt::format("--param type={}: the type is trigonometric, polynomial or hyperbolic", *type));
  if (!type || type == "polynomial") result.type = sequence.types.front().type;
  else result.type = type == "hyperbolic" ? AngleType::hyperbolic : AngleType::trigonometric;
  if (type == "polynomial" && angle) throw InputError(fmt::format("--param type=polynomial: the {} is 0", sequence.angle));
  const MaskSequence::Range* range = sequence.find(result.type);
  if (!range) throw InputError(fmt::format("{} has no {} type", scheme.name, to_string(result.type)));
  if (!angle) {
    if (type && *type != "polynomial") throw InputError(fmt::format("--param type={} needs an angle, --param {}=ANGLE", *type, sequence.angle));
    result.mu = 1;
    return result;
  }
  try {
    std::tie(result.rational, result.turns) = read_angle(*angle);
    if (!range->angles.contains(read_angles(*angle))) throw InputError(fmt::format("outside of the parameter's range {}", to_string(range->angles)));
  } catch (const InputError& error) {
    throw InputError(fmt::format("--param {}={}: {}", sequence.angle, *angle, error.reason()));
  }
  if (result.rational == 0 && result.turns == 0) result.mu = 1;
  return result;
}

}  // namespace limes
