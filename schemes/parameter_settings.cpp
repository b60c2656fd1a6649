#include "schemes/parameter_settings.hpp"

#include "algebra/error.hpp"
#include "algebra/number/rational.hpp"
#include "schemes/nonstationary/angle.hpp"

#include <fmt/format.h>

namespace limes {

AngleType type_from_settings(const Scheme& scheme, const std::vector<std::string>& settings) {
  const MaskSequence* sequence = scheme.level_sequence();
  if (!sequence) throw InternalError("a scheme without types");
  AngleType type = sequence->types.front().type;
  bool given = false;
  for (const std::string& setting : settings) {
    if (!setting.starts_with("type=")) continue;
    if (given) throw InputError(fmt::format("--param {}: 'type' is given twice", setting));
    given = true;
    const std::string name = setting.substr(5);
    if (name == "polynomial") continue;  // theta = 0 of any type
    const auto& types = sequence->types;
    const auto found = std::find_if(types.begin(), types.end(), [&](const auto& range) { return to_string(range.type) == name; });
    if (found == types.end()) throw InputError(fmt::format("--param {}: {} has no such type", setting, scheme.name));
    type = found->type;
  }
  return type;
}

void require_one_mask(const Scheme& scheme, const std::string& verb) {
  if (scheme.sequence || scheme.surface)
    throw InputError(fmt::format("{} is a {} scheme: '{}' needs a scheme with one mask", scheme.name, to_string(scheme.kind), verb));
}

Box region_from_settings(const Scheme& scheme, const std::vector<std::string>& settings) {
  Box region = scheme.parameter_box();
  const MaskSequence* sequence = scheme.level_sequence();
  if (sequence) region = {sequence->find(type_from_settings(scheme, settings))->angles};
  const Box widest = region;
  std::vector<bool> given(region.size(), false);
  const bool polynomial = sequence && std::count(settings.begin(), settings.end(), "type=polynomial") > 0;
  if (polynomial) {
    if (!widest.front().contains(Rational(0))) throw InputError("--param type=polynomial: theta = 0 is outside of the parameter's range");
    region.front() = Interval::point(0);
    given.front() = true;
  }
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw InputError(fmt::format("--param {}: expected NAME=VALUE", setting));
    const std::string name = setting.substr(0, equals);
    if (sequence && name == "type") continue;
    std::size_t k = 0;
    while (k < region.size() && scheme.parameters[k].name != name) ++k;
    if (k == region.size()) throw InputError(fmt::format("--param {}: {} has no parameter '{}'", setting, scheme.name, name));
    if (given[k]) throw InputError(fmt::format("--param {}: '{}' is given twice{}", setting, name, polynomial ? " (type=polynomial says that it is 0)" : ""));
    given[k] = true;
    try {
      const std::string value = setting.substr(equals + 1);
      region[k] = sequence ? read_angles(value) : read_interval(value);
    } catch (const InputError& error) {
      throw InputError(fmt::format("--param {}: {}", setting, error.reason()));
    }
    if (!widest[k].contains(region[k])) {
      throw InputError(fmt::format("--param {}: outside of the parameter's range {} = {}", setting, name, to_string(widest[k])));
    }
  }
  return region;
}

std::vector<Rational> point_from_settings(const Scheme& scheme, const std::vector<std::string>& settings, const std::string& what) {
  const Box region = region_from_settings(scheme, settings);
  std::vector<Rational> point;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const std::optional<Rational> angle = scheme.sequence ? single_angle(region[k]) : std::nullopt;
    if (!angle && !region[k].is_point())
      throw InputError(fmt::format("{} one value of every parameter: --param {}=VALUE", what, scheme.parameters[k].name));
    point.push_back(angle ? *angle : region[k].lower);
  }
  return point;
}

std::string region_text(const Scheme& scheme, const Box& region) {
  constexpr std::size_t most_digits = 24;
  std::string text;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const Interval& interval = region[k];
    std::string values = to_string(interval);
    const char* relation = interval.is_point() ? "=" : "in";
    if (values.size() > most_digits) {
      const std::string lower = to_decimal(interval.lower, 16, Rounding::down), upper = to_decimal(interval.upper, 16, Rounding::up);
      const bool exact = interval.is_point() && lower == upper;
      if (!exact) relation = "in";
      values = exact ? lower : fmt::format("{}{}, {}{}", interval.lower_open ? '(' : '[', lower, upper, interval.upper_open ? ')' : ']');
    }
    text += fmt::format("{}{} {} {}", k ? ", " : "", scheme.parameters[k].name, relation, values);
  }
  return text.empty() ? "-" : text;
}

std::string region_text(const Scheme& scheme, const Claim& claim) {
  std::string region = region_text(scheme, claim.region);
  const MaskSequence* sequence = scheme.level_sequence();
  if (sequence && sequence->types.size() > 1) region = fmt::format("{}, {}", region, to_string(claim.type));
  if (!claim.valences) return region;
  const bool one = claim.valences->last == claim.valences->first;
  const std::string valences = fmt::format("n {} {}", one ? "=" : "in", to_string(*claim.valences));
  return scheme.parameters.empty() ? valences : fmt::format("{}, {}", valences, region);
}

std::optional<Rational> take_setting(std::vector<std::string>& settings, const std::string& name) {
  std::optional<Rational> value;
  for (auto place = settings.begin(); place != settings.end();) {
    if (!place->starts_with(name + "=")) {
      ++place;
      continue;
    }
    if (value) throw InputError(fmt::format("--param {}: '{}' is given twice", *place, name));
    try {
      const Interval interval = read_interval(place->substr(name.size() + 1));
      if (!interval.is_point()) throw InputError("expected one value");
      value = interval.lower;
    } catch (const InputError& error) {
      throw InputError(fmt::format("--param {}: {}", *place, error.reason()));
    }
    place = settings.erase(place);
  }
  return value;
}

}  // namespace limes
