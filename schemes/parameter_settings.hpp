#pragma once

#include "schemes/scheme.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes {

/// Of a nonstationary scheme: the "type=trigonometric", "type=hyperbolic" or "type=polynomial" (theta = 0) among the settings, by default
/// its first type. \throws InputError for a type that the scheme has not
AngleType type_from_settings(const Scheme& scheme, const std::vector<std::string>& settings);

/// Of a nonstationary scheme only the limit of its masks is a uniform scheme, a surface scheme has no mask: what is about one mask would
/// answer another question. \throws InputError when the scheme is nonstationary or of surfaces
void require_one_mask(const Scheme& scheme, const std::string& verb);

/// The scheme's parameter box with the "name=value" settings put in. \throws InputError: no such parameter, given twice, no
/// interval, outside of the parameter's range. Of a nonstationary scheme the range is that of the type, and angles may contain pi
/// (read_angles).
Box region_from_settings(const Scheme& scheme, const std::vector<std::string>& settings);

/// One point of it: the settings, or the definition, give every parameter one value; an angle with pi (read_angles) stands for the middle
/// of its enclosure, which is exact enough for work in floating point. \param what needs the values: "the norm needs"
/// \throws InputError "the norm needs one value of every parameter: --param w=VALUE"
std::vector<Rational> point_from_settings(const Scheme& scheme, const std::vector<std::string>& settings, const std::string& what);

/// "w in [0, 1/4], mu = 1/9", "-" without parameters; ends of many digits as decimals.
std::string region_text(const Scheme& scheme, const Box& region);

/// The region of a claim, with the type when the scheme has several, and with the valences that it is about: "n in [3, 50], theta in [0, 3]".
std::string region_text(const Scheme& scheme, const Claim& claim);

/// Takes "name=value" for something that is no parameter of the scheme, such as the knot ratio gamma, out of the settings; nothing when it is not
/// there. \throws InputError: given twice, no single value
std::optional<Rational> take_setting(std::vector<std::string>& settings, const std::string& name);

}  // namespace limes
