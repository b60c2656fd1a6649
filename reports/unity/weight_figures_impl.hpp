// Figures of weight functions and multiresolution filters. Included by sources of this folder only.
#pragma once

#include "reports/unity/weight_study.hpp"

namespace limes::unity_impl {

/// w with its refinement, w / sum w(. - i) with the limit of the projective scheme, and the residual. [MoltajiRunionsSamavati2016, Fig. 7]
Figure weight_figure(const Scheme& scheme, const WeightStudy& study);
/// E against the order of the sum rules, and against the bounds of the Hoelder exponent.
Figure cost_figure(const Scheme& scheme, const WeightStudy& study);

}  // namespace limes::unity_impl
