#pragma once

#include "schemes/scheme.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes::app {

/// The schemes of these names and files, or the whole catalogue. \throws InputError, also when two have the same name
std::vector<Scheme> load_schemes(const std::vector<std::string>& given);

/// The claims to decide: the file's own; or --claim on the region that --param gives; or, with --param alone, the file's certified claims that
/// cover that region, restated on it. \param valence of a claim about a surface scheme, by default all \throws InputError
std::vector<Claim> claims_to_decide(const Scheme& scheme, const std::optional<std::string>& claim_text, const std::vector<std::string>& parameters,
                                    const std::optional<std::string>& valence = std::nullopt);

/// "four-point.2.C1.json" for the file's second claim, "four-point.asked.1.C1.json" for the first one of the command line.
std::string certificate_name(const Scheme& scheme, const Claim& claim, std::size_t index, bool asked);

}  // namespace limes::app
