// The JSON form of masks in certificates. Included by sources only.
#pragma once

#include "schemes/uniform/mask.hpp"

#include <nlohmann/json.hpp>

namespace limes {

/// The entries as expressions in the parameters, all over the one denominator that proofs use, so that the checker forms the same one.
nlohmann::ordered_json mask_to_json(const Mask& mask, const VariableNames& names);

}  // namespace limes
