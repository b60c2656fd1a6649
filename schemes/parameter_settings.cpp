#include "schemes/parameter_settings.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

namespace limes {

Box region_from_settings(const Scheme& scheme, const std::vector<std::string>& settings) {
  Box region = scheme.parameter_box();
  std::vector<bool> given(region.size(), false);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw InputError(fmt::format("--param {}: expected NAME=VALUE", setting));
    const std::string name = setting.substr(0, equals);
    std::size_t k = 0;
    while (k < region.size() && scheme.parameters[k].name != name) ++k;
    if (k == region.size()) throw InputError(fmt::format("--param {}: {} has no parameter '{}'", setting, scheme.name, name));
    if (given[k]) throw InputError(fmt::format("--param {}: '{}' is given twice", setting, name));
    given[k] = true;
    try {
      region[k] = read_interval(setting.substr(equals + 1));
    } catch (const InputError& error) {
      throw InputError(fmt::format("--param {}: {}", setting, error.reason()));
    }
    if (!scheme.parameters[k].range.contains(region[k])) {
      throw InputError(fmt::format("--param {}: outside of the parameter's range {} = {}", setting, name,
                                   to_string(scheme.parameters[k].range)));
    }
  }
  return region;
}

std::string region_text(const Scheme& scheme, const Box& region) {
  std::string text;
  for (std::size_t k = 0; k < region.size(); ++k) {
    text += fmt::format("{}{} {} {}", k ? ", " : "", scheme.parameters[k].name, region[k].is_point() ? "=" : "in", to_string(region[k]));
  }
  return text.empty() ? "-" : text;
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
