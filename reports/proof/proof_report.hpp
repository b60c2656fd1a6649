#pragma once

#include "algebra/stop.hpp"
#include "proofs/verdict.hpp"
#include "reports/document/document.hpp"
#include "reports/unity/decided_filters.hpp"
#include "reports/unity/weight_study.hpp"
#include "schemes/scheme.hpp"

#include <filesystem>
#include <vector>

namespace limes {

/// A claim with what became of it.
struct DecidedClaim {
  Claim claim;
  Verdict verdict;
  /// Name of the certificate's file; empty without one.
  std::string certificate;
};

/// A scheme with its claims, as a report shows it.
struct ReportedScheme {
  Scheme scheme;
  std::vector<DecidedClaim> claims;
  /// Of a mask from a weight function, and of a binary scheme whose multiresolution filters are asked for.
  std::optional<WeightStudy> weight = {};
  std::optional<DecidedFilters> filters = {};
};

struct ProofReportOptions {
  std::string title = "Smoothness of subdivision schemes: certified proofs";
  /// Summary and theorems in front; without them the sections of the schemes follow one another (fragments).
  bool front_matter = true;
  bool figures = true;
  /// Polygons for curvature combs; no combs when empty.
  std::filesystem::path polygons;
};

/// A report's text with all formulas, tables and figures, in no format yet. Every number in it comes from a verdict, a certificate or a computed
/// value; the same input gives the same document. \throws Interrupted
Document proof_report(const std::vector<ReportedScheme>& schemes, const ProofReportOptions& options, const Stop& stop = {});

}  // namespace limes
