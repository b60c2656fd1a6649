// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

#include <nlohmann/json_fwd.hpp>

namespace limes::checker {

/// Reads and checks a certificate of one theorem, after "format" and "version" have been checked, and returns what it
/// proves in one sentence. \throws Rejected at the step that fails
using TheoremChecker = std::string (*)(const nlohmann::json& certificate, Budget& budget);

/// U1, U2, N1 and N3, whose certificates have one form: scheme, claim, verdict, theorem, proof.
std::string check_smoothness(const nlohmann::json& certificate, Budget& budget);
/// B1: multiresolution filters are biorthogonal, with bounds of their norms.
std::string check_biorthogonality(const nlohmann::json& certificate, Budget& budget);

}  // namespace limes::checker
