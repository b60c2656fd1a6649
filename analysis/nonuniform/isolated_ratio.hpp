#pragma once

#include "algebra/polynomial/box.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"

#include <vector>

namespace limes {

/// The stencils E_0 .. E_{2n-2} of a rule about an isolated knot ratio gamma, in the variables (parameters, gamma), with the
/// parameters of point intervals substituted: E_0 for equal intervals, E_k for ratios 1 but number 2n-1-k (from 1), which is
/// gamma. [Karciauskas & Peters 2013, eq. (14)] \pre one interval per parameter, or none at all:
/// then nothing is substituted
std::vector<std::vector<RationalFunction>> isolated_ratio_stencils(const InsertionRule& rule, const Box& region);

/// e_{k,j}(1/gamma) = e_{2n-1-k, 2n+1-j}(gamma), and E_0 is symmetric: then the mirror image of the subdivision matrix L(gamma) is
/// L(1/gamma), and gamma in (0, 1] stands for all gamma > 0.
bool is_mirror_symmetric(const std::vector<std::vector<RationalFunction>>& stencils);

}  // namespace limes
