#pragma once

#include "proofs/unity/biorthogonality.hpp"
#include "reports/document/document.hpp"
#include "reports/plot/plot.hpp"
#include "schemes/unity/multiresolution.hpp"

#include <optional>

namespace limes {

/// Multiresolution filters of a uniform binary scheme, without an extension, with theorem B1.
struct DecidedFilters {
  Multiresolution shortest;
  BiorthogonalityProof proof;
  /// Name of the certificate's file.
  std::string certificate;
  /// With extensions 0, 2, .., and the bounds of the longest filters.
  Multiresolution extended;
  BiorthogonalityProof extended_proof;
};

/// Nothing for a scheme with parameters or another arity, and for masks without such filters. \throws Interrupted
std::optional<DecidedFilters> decide_filters(const Scheme& scheme, int extension, const Stop& stop);

/// The filters, the proposition that they are biorthogonal with bounds of norms, and the figure of errors.
std::vector<Block> filter_section(const Scheme& scheme, const DecidedFilters& filters);

/// Theorem B1 as a report states it.
std::vector<Block> biorthogonality_theorem();

/// The orthogonality error of some schemes against the length of their filters [MoltajiRunionsSamavati2017, Fig. 7].
struct ErrorCurve {
  std::string name;
  Multiresolution result;
};
Plot error_plot(const std::vector<ErrorCurve>& curves);
/// "scheme,length,error" and a line for each point.
std::string error_csv(const std::vector<ErrorCurve>& curves);

}  // namespace limes
