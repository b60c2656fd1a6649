#pragma once

namespace limes {

/// What a level of the unified scheme reproduces besides {1, y}: {cos, sin}, {y^2, y^3} or {cosh, sinh} of theta y.
enum class AngleType { trigonometric, polynomial, hyperbolic };

/// The weights (outer, inner, inner, outer) of the four-point rule of one level, and what else its rules need.
struct FourPointWeights {
  /// alpha = -1/D, D = 8 mu (mu + 1).
  double outer = -1. / 16;
  /// beta = (2 mu + 1)^2 / D, so that alpha + beta = 1/2.
  double inner = 9. / 16;
  /// c = 2 mu^2 - 1: the cosine, or hyperbolic cosine, of the angle of one edge before the level.
  double edge_cosine = 1;

  /// kappa = -alpha/beta = 1/(2 mu + 1)^2 of the virtual points at extraordinary vertices.
  double kappa() const { return -outer / inner; }
};

/// The weights that make level `level` + 1 of level `level` >= 0 with mu = cos or cosh of theta/2^{level+1}, or 1; theta is the
/// angle of one edge of the control net. [Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, eq. 1] \throws DomainError when theta is not finite, or mu is 0 or -1
FourPointWeights unified_weights(AngleType type, double theta, int level);

}  // namespace limes
