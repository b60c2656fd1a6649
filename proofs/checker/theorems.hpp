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

/// JSR: bounds of, or the exact, joint spectral radius of a family of rational matrices.
std::string check_joint_spectral_radius(const nlohmann::json& certificate, Budget& budget);

/// U3: bounds of the Hoelder exponent of a uniform scheme at one parameter value.
std::string check_hoelder_exponent(const nlohmann::json& certificate, Budget& budget);

}  // namespace limes::checker
