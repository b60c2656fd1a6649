#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes {

/// One certificate of the common statement on a region which the regions of the given certificates cover: their leaves together.
/// Nothing when they are about different schemes or statements, use different theorems, or cannot be joined leaf by leaf. The result has
/// not been checked. \throws DomainError when a text is no JSON
std::optional<std::string> merge_certificates(const std::vector<std::string>& certificates, const Box& region,
                                              const VariableNames& parameters);

}  // namespace limes
