#pragma once

#include "proofs/certificate.hpp"

#include <optional>
#include <string>

namespace limes {

/// What became of a claim. A certified or refuted verdict carries a certificate that the independent checker has accepted; an
/// undecided one says why, and how far the work got.
struct Verdict {
  Outcome outcome = Outcome::undecided;
  /// One sentence for people.
  std::string reason;
  std::optional<Certificate> certificate;
  /// The certificate's text.
  std::string certificate_json;
  /// Stopped by the user or by the budget.
  bool interrupted = false;

  int level() const { return certificate ? certificate->level() : 0; }
  int leaf_count() const { return certificate ? certificate->leaf_count() : 0; }
};

}  // namespace limes
