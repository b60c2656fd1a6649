#pragma once

#include "analysis/unity/filter_norms.hpp"
#include "schemes/scheme.hpp"
#include "schemes/unity/filter_bank.hpp"

#include <string>

namespace limes {

/// Theorem B1 for filters over Q: AP = I, AQ = 0, BP = 0, BQ = I, and so PA + QB = I, on the integers and for circulant
/// matrices of every size; and bounds of norms in l^2.
struct BiorthogonalityProof {
  RationalBounds orthogonality_error, sigma_min_p, norm_a, norm_b;
  /// Accepted by the independent checker.
  std::string certificate_json;
};

/// What is measured, also for filters that are biorthogonal up to rounding only: those have no certificate.
/// \param mask of the scheme, without parameters: the first entries of p
/// \throws InternalError when the checker rejects the certificate of filters that are biorthogonal
BiorthogonalityProof prove_biorthogonality(const std::string& scheme, const Mask& mask, const FilterBank& bank);

}  // namespace limes
