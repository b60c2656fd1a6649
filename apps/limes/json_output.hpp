#pragma once

#include "analysis/nonuniform/dominance_comparison.hpp"
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "analysis/surface/vertex_spectrum.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/map/map_unions.hpp"
#include "analysis/uniform/hoelder_exponent.hpp"
#include "proofs/verdict.hpp"
#include "reports/tables/compare_table.hpp"
#include "reports/unity/smoothness_cost.hpp"
#include "schemes/scheme.hpp"
#include "schemes/unity/optimise_weight.hpp"

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
  /// At one knot ratio, if asked for.
  std::vector<ComplexRoot> eigenvalues;
};

struct VertexSpectrumReport {
  std::string scheme;
  int valence = 3;
  /// Nothing when every level is the same.
  std::optional<int> level;
  bool and_later = false;
  Interval mu;
  int rings = 1;
  int size = 0;
  std::vector<VertexEigenvalue> eigenvalues;
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

struct MapReport {
  const Scheme& scheme;
  const Claim& claim;
  const ParameterMap& map;
  const std::vector<MapUnion>& unions;
  /// files[i][k]: the certificate of part k of union i.
  std::vector<std::vector<std::string>> files;
};

struct DeriveReport {
  /// The weight function, with the optimal argument.
  std::string weight = {};
  DerivedMask derived = {};
  Rational even_sum = {}, odd_sum = {};
  int sum_rule_order = 0;
  /// Of --optimise.
  std::string parameter = {};
  std::optional<OptimalParameter> optimum = {};
  /// Of --round.
  std::string rounding = {};
  std::optional<std::vector<Rational>> rounded = {};
  double rounded_error = 0;
  /// Of --cost.
  std::vector<SmoothnessCost> costs = {};
};

struct RadiusReport {
  SpectralRadiusBounds bounds;
  std::string certificate;
};

struct HolderReport {
  HoelderExponent exponent;
  int arity = 2;
  /// Path of the certificate, empty without one.
  std::string certificate;
};

struct OutputFile {
  std::string file;
  std::string kind;
};

std::string list_json(const std::vector<Scheme>& schemes);
std::string show_json(const Scheme& scheme);
std::string verify_json(const std::vector<VerifiedClaim>& results);
std::string check_json(const std::vector<CheckedFile>& results);
std::string map_json(const MapReport& report);
std::string matrix_json(const MatrixReport& report);
std::string spectrum_json(const std::vector<VertexSpectrumReport>& reports, bool interrupted);
std::string dominance_json(const std::vector<DominanceReport>& reports);
std::string derive_json(const DeriveReport& report);
std::string norm_json(const Rational& norm, int order, int level);
std::string tables_json(const std::vector<ComparedTable>& tables);
/// "3/2", or "the root 1.61803.. of x^2 - x - 1".
std::string describe(const AlgebraicNumber& x);
/// \param digits significant digits of the decimals
std::string jsr_json(const RadiusReport& report, int digits);
std::string holder_json(const HolderReport& report, int digits);
/// What the verbs print that write files.
std::string outputs_json(const std::vector<OutputFile>& outputs);

}  // namespace limes::app
