#pragma once

#include "analysis/nonuniform/dominance_comparison.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/verdict.hpp"
#include "schemes/scheme.hpp"

#include <string>
#include <vector>

namespace limes::app {

/// The JSON results of the verbs (docs/command-line.md names the keys). Rationals are strings "p/q", decimals are rounded
/// outward. Every text ends with a newline.

struct VerifiedClaim {
  const Scheme* scheme = nullptr;
  Claim claim;
  Verdict verdict;
  double seconds = 0;
  /// Path of the certificate, empty without one.
  std::string certificate;
};

struct CheckedFile {
  std::string file;
  checker::Result result;
};

struct MatrixReport {
  const Scheme& scheme;
  const SubdivisionMatrix& matrix;
  /// Parameters, then gamma.
  VariableNames names;
  SplitCharacteristicPolynomial split;
};

struct DominanceReport {
  std::string scheme;
  Claim claim;
  std::string region;
  /// Parameters, then gamma.
  VariableNames names;
  /// Why there is nothing to compare; empty otherwise.
  std::string reason;
  std::vector<FactorComparison> factors;
};

struct OutputFile {
  std::string file;
  std::string kind;
};

std::string list_json(const std::vector<Scheme>& schemes);
std::string show_json(const Scheme& scheme);
std::string verify_json(const std::vector<VerifiedClaim>& results);
std::string check_json(const std::vector<CheckedFile>& results);
std::string matrix_json(const MatrixReport& report);
std::string dominance_json(const std::vector<DominanceReport>& reports);
std::string norm_json(const Rational& norm, int order, int level);
/// What the verbs print that write files.
std::string outputs_json(const std::vector<OutputFile>& outputs);

}  // namespace limes::app
