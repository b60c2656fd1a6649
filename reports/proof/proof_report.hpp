#pragma once

#include "algebra/stop.hpp"
#include "analysis/uniform/hoelder_exponent.hpp"
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

/// Bounds of the Hoelder exponent of a uniform scheme at a parameter value, with the certificate (theorem U3).
struct DecidedExponent {
  std::vector<Rational> point;
  HoelderExponent exponent;
  /// Name of the certificate's file, and its text.
  std::string certificate;
  std::string certificate_json;
};

/// A scheme with its claims, as a report shows it.
struct ReportedScheme {
  Scheme scheme;
  std::vector<DecidedClaim> claims;
  std::vector<DecidedExponent> exponents = {};
  /// Of a mask from a weight function, and of a binary scheme whose multiresolution filters are asked for.
  std::optional<WeightStudy> weight = {};
  std::optional<DecidedFilters> filters = {};
};

/// The parameter values at which a report bounds the Hoelder exponent: the one of a uniform scheme without parameters, and those of claims about a
/// single value, in the order of the claims; none of other schemes.
std::vector<std::vector<Rational>> exponent_points(const Scheme& scheme, const std::vector<Claim>& claims);
/// Bounds of it to five digits with their certificate; nothing when there is no lower bound or the proof would be too long. \throws Interrupted
std::optional<DecidedExponent> decide_exponent(const Scheme& scheme, const std::vector<Rational>& point, const Stop& stop = {});

struct ProofReportOptions {
  std::string title = "Smoothness of subdivision schemes: certified proofs";
  /// The summary in front; without it the sections of the schemes follow one another (fragments).
  bool front_matter = true;
  bool figures = true;
  /// Of Limes, under the title.
  std::string version = {};
  /// Polygons for curvature combs; no combs when empty.
  std::filesystem::path polygons;
  /// Control nets for pictures of surfaces, with their surfaces.json; none when empty.
  std::filesystem::path nets;
};

/// A report's text with all formulas, tables and figures, in no format yet. Many schemes of several kinds are in parts, kind by kind. Every number in it comes from a verdict, a certificate or a computed
/// value; the same input gives the same document. \throws Interrupted
Document proof_report(const std::vector<ReportedScheme>& schemes, const ProofReportOptions& options, const Stop& stop = {});

}  // namespace limes
