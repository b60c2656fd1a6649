#pragma once

#include "schemes/unity/derive_mask.hpp"

#include <string>
#include <utility>
#include <vector>

namespace limes {

/// What a mask is derived from: as the command line gives it, completed by a weight file.
struct WeightProblem {
  /// A weight function as read_weight() takes it, or the path of a weight file (docs/scheme-files.md), which ends in .toml.
  std::string weight;
  /// "[-4, 4]" and "-4..4" or "-5/2..5/2"; empty: the file's, or the defaults of refinement_equation().
  std::string domain, shifts;
  /// Added to those of the file. [read_constraint]
  std::vector<std::string> constraints;
  /// Arguments of the weight function that replace those of its text, by name.
  std::vector<std::pair<std::string, Rational>> settings;
  int samples = 100000;
  int precision = 53;
  /// Integrals instead of samples.
  bool integrals = false;
  std::optional<int> decimals;
};

/// \throws InputError with file and line, Interrupted
DerivedMask derive_mask(const WeightProblem& problem, const Stop& stop);

/// The coefficients rounded as 'float32' or a number of significant digits says. \throws InputError
std::vector<Rational> rounded_mask(const std::vector<Rational>& mask, const std::string& rounding);

}  // namespace limes
