#pragma once

#include "schemes/nonstationary/mask_sequence.hpp"

namespace limes {

/// A scheme for quadrilateral meshes that is the tensor product of a curve scheme where the mesh is regular, and continues the lines of
/// the mesh through extraordinary vertices by virtual points [Kobbelt 1996; Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, section 2.3].
struct SurfaceRule {
  /// Name of the curve scheme in the catalogue, or its file.
  std::string curve;
  /// Its masks: binary, (a, 0, b, 1, b, 0, a) at every level.
  MaskSequence sequence;
};

/// \throws InputError when the masks are not those of a symmetric interpolatory four-point scheme
SurfaceRule surface_rule(std::string curve, MaskSequence sequence);

}  // namespace limes
