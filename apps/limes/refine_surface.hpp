#pragma once

#include "algebra/stop.hpp"
#include "apps/limes/options.hpp"
#include "schemes/scheme.hpp"

namespace limes::app {

/// limes refine with a surface scheme. \pre scheme.surface
int refine_surface(const Scheme& scheme, const RefineOptions& options, const Stop& stop);

}  // namespace limes::app
