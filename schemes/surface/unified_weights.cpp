#include "schemes/surface/unified_weights.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {

FourPointWeights unified_weights(AngleType type, double theta, int level) {
  const double angle = std::ldexp(theta, -(level + 1));
  const double mu = type == AngleType::trigonometric ? std::cos(angle) : type == AngleType::hyperbolic ? std::cosh(angle) : 1;
  const double d = 8 * mu * (mu + 1);
  const double edge_cosine = 2 * mu * mu - 1;
  if (!std::isfinite(edge_cosine) || std::abs(d) < 1e-12)
    throw DomainError(fmt::format("the unified scheme has no weights for the angle {} at level {}", theta, level + 1));
  return {-1 / d, (2 * mu + 1) * (2 * mu + 1) / d, edge_cosine};
}

}  // namespace limes
