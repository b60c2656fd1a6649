#pragma once

#include "schemes/scheme.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes {

/// The scheme's parameter box with the "name=value" settings put in. \throws InputError: no such parameter, given twice, no
/// interval, outside of the parameter's range.
Box region_from_settings(const Scheme& scheme, const std::vector<std::string>& settings);

/// "w in [0, 1/4], mu = 1/9", "-" without parameters.
std::string region_text(const Scheme& scheme, const Box& region);

/// Takes "name=value" for something that is no parameter of the scheme, such as the knot ratio gamma, out of the settings; nothing when it is not
/// there. \throws InputError: given twice, no single value
std::optional<Rational> take_setting(std::vector<std::string>& settings, const std::string& name);

}  // namespace limes
