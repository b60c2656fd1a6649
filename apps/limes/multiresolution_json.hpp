#pragma once

#include "geometry/pyramid.hpp"
#include "proofs/unity/biorthogonality.hpp"
#include "schemes/unity/multiresolution.hpp"

#include <optional>
#include <string>

namespace limes::app {

struct MultiresolutionReport {
  std::string scheme;
  const Multiresolution& result;
  const BiorthogonalityProof& proof;
  /// Empty without one.
  std::string certificate;
  /// Empty without one.
  std::string output;
};

struct PyramidReport {
  /// {file, kind}
  std::vector<std::pair<std::string, std::string>> outputs;
  const Pyramid& pyramid;
  std::optional<DetailCount> details;
  std::optional<Difference> difference;
  /// Of colour images.
  std::optional<double> luminosity_psnr;
};

/// The JSON results of multiresolution, decompose and reconstruct (docs/command-line.md).
std::string multiresolution_json(const MultiresolutionReport& report);
std::string pyramid_json(const PyramidReport& report);

}  // namespace limes::app
