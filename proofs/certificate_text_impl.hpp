// The layout of certificates. Included by sources only.
#pragma once

#include <nlohmann/json.hpp>

namespace limes {

/// Objects with one key a line, and arrays without objects on one line, except that a long array of arrays has one of them a line.
std::string certificate_text(const nlohmann::ordered_json& json);

}  // namespace limes
