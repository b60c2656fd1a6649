#pragma once

#include "algebra/number/rational.hpp"
#include "algebra/stop.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limes {

struct DerivedMask;

/// What a mask is derived from, in the words of the command line, of a weight file, or of the table [weight] of a scheme file.
struct WeightProblem {
  /// An expression in u on an interval.
  struct Piece {
    std::string on, value;
  };
  /// A weight function as read_weight() takes it; empty when there are pieces.
  std::string function = {};
  std::vector<Piece> pieces = {};
  /// "[-4, 4]" and "-4..4" or "-5/2..5/2"; empty: the defaults of refinement_equation().
  std::string domain = {}, shifts = {};
  /// As read_constraint() takes them.
  std::vector<std::string> constraints = {};
  int samples = 100000;
  int precision = 53;
  /// Integrals instead of samples.
  bool integrals = false;
  std::optional<int> decimals = {};
};

constexpr int max_samples = 10000000;
constexpr int max_precision = 4096;

/// The problem of a weight file or of a uniform scheme file with [weight] (docs/scheme-files.md), if the text ends in .toml;
/// otherwise the text is a weight function. \throws InputError with file and line
WeightProblem read_weight_problem(const std::string& text);

/// An argument of the weight function, "sigma", gets another value. \throws InputError: the weight function is piecewise or unreadable
void set_argument(WeightProblem& problem, const std::string& name, const Rational& value);

/// The table [weight] as lines of a scheme file.
std::string weight_table(const WeightProblem& problem);

/// "cinpact(c=3, sigma=727/100)", or "1+u on [-1,0], 1-u on [0,1]".
std::string describe(const WeightProblem& problem);

/// \throws InputError, Interrupted
DerivedMask derive_mask(const WeightProblem& problem, const Stop& stop);

/// The coefficients rounded as 'float32' or a number of significant digits says. \throws InputError
std::vector<Rational> rounded_mask(const std::vector<Rational>& mask, const std::string& rounding);

}  // namespace limes
