#pragma once

#include "proofs/certificate.hpp"
#include "reports/document/document.hpp"
#include "schemes/scheme.hpp"

#include <set>
#include <string>

namespace limes {

/// The proof of a verdict by theorem P0, P1 or P2 in words, with the numbers that it needs. `shown` has what was said before and is not repeated.
std::vector<Block> projective_proof_text(const Scheme& scheme, const Certificate& certificate, std::set<std::string>& shown);

}  // namespace limes
