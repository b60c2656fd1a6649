#pragma once

#include "schemes/nonstationary/mask_sequence.hpp"
#include "schemes/surface/ring_rule.hpp"

namespace limes {

/// A scheme for quadrilateral meshes that is the tensor product of a curve scheme where the mesh is regular, with rules of its own for some
/// points around extraordinary vertices or faces: either from virtual points, which continue the lines of the mesh through extraordinary
/// vertices [Kobbelt 1996; Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, section 2.3], or given.
struct SurfaceRule {
  /// Name of the curve scheme in the catalogue, or its file.
  std::string curve;
  /// Its masks; of a stationary one they do not depend on mu, and the only angle is 0.
  MaskSequence sequence;
  bool virtual_points = true;
  /// The rules of a scheme without virtual points, and the limit's of one with them; in the level parameter.
  RingRule rings;

  /// The rules of level k (the one that makes level k + 1). \pre k >= 0
  RingRule rings_at_level(int k) const;
};

/// A curve scheme's mask as the sequence of a surface rule. \throws InputError when it has parameters
MaskSequence constant_sequence(const Mask& mask);

/// With virtual points.
/// \throws InputError when the masks are not those of a symmetric interpolatory four-point scheme
SurfaceRule surface_rule(std::string curve, MaskSequence sequence);

/// With given rules for some points.
/// \throws InputError when the masks are not symmetric and binary, or a point that has no rule needs one
SurfaceRule surface_rule(std::string curve, MaskSequence sequence, std::map<RingPoint, std::vector<RingTerm>> given);

}  // namespace limes
