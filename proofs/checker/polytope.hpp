// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"

namespace limes::checker {

/// \throws Rejected at "proof" or "limits"
PolytopeWitness read_polytope(const Json& json, const std::string& where, Budget& budget);

}  // namespace limes::checker
