#pragma once

#include "reports/document/document.hpp"
#include "reports/unity/smoothness_cost.hpp"
#include "schemes/unity/derive_mask.hpp"

namespace limes {

/// What a report says of a scheme whose file names the weight function that its mask was derived from.
struct WeightStudy {
  WeightProblem problem;
  DerivedMask derived;
  /// E of the scheme's own mask, which may be rounded.
  double error = 0;
  Rational even_sum = 0, odd_sum = 0;
  std::vector<SmoothnessCost> costs;
};

/// \pre scheme.weight \throws InputError, Interrupted
WeightStudy study_weight(const Scheme& scheme, const Stop& stop);

/// File names and texts of the certificates of exponents, one for each mask of the table of costs.
std::vector<std::pair<std::string, std::string>> exponent_certificates(const Scheme& scheme, const WeightStudy& study);

/// Weight function, error, defects of the sum rules, a table of what smoothness costs, and figures: the weight function with its refinement and the limit
/// of the projective scheme [MoltajiRunionsSamavati2016, Fig. 7], and E against the order of the sum rules.
std::vector<Block> weight_section(const Scheme& scheme, const WeightStudy& study);

}  // namespace limes
