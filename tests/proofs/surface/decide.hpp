// Deciding claims of surface schemes in tests.
#pragma once

#include "proofs/prove.hpp"

#include <filesystem>
#include <fstream>

namespace limes::test {

/// Proves it, and leaves the certificate for limes-check.
inline Verdict decide(const Scheme& scheme, const Claim& claim, const std::string& file) {
  Verdict verdict = prove(scheme, claim);
  if (verdict.outcome == Outcome::certified) {
    const std::filesystem::path directory = std::filesystem::path(LIMES_BINARY_DIR) / "certificates";
    std::filesystem::create_directories(directory);
    std::ofstream(directory / file) << verdict.certificate_json;
  }
  return verdict;
}

}  // namespace limes::test
