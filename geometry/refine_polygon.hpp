#pragma once

#include "algebra/stop.hpp"
#include "geometry/polygon.hpp"
#include "schemes/nonstationary/mask_sequence.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"
#include "schemes/uniform/mask.hpp"

#include <functional>
#include <optional>

namespace limes {

/// What happens at the two ends of an open polygon; closed polygons have none.
///
/// - shrink: a new point is made where all the points of its stencil exist, so each level loses points at the ends and
///   what is left is a part of the limit of every longer polygon: for B-splines the usual curve, for a 2n-point scheme
///   the curve from p_{2n-2} to p_{M-2n+2}. Nothing is invented.
/// - extend: before the first level the polygon is continued beyond its ends by equally spaced points on the lines
///   through its first and last two (and by knots at the distance of the first and last two), as many as the limit on
///   all of it depends on; what lies beyond the ends is cut off at last. So the limit is a part of a limit of
///   bi-infinite data, and just as smooth up to its ends, which extrapolating once more at each level would not give.
///   Linear data stay linear.
/// - exact (nonstationary schemes): the same, but by the recurrence of the functions that the scheme reproduces instead of the
///   line, so that an arc of a circle stays one up to its ends. Other data may swing out beyond the ends.
///
/// By default interpolatory schemes extend, so that their curves go through all points, and all others shrink.
enum class EndRule { automatic, extend, shrink, exact };

struct Refinement {
  /// >= 0
  int levels = 1;
  EndRule ends = EndRule::automatic;
  /// More points than this in the result are a LimitError, before any work.
  std::size_t max_points = std::size_t{1} << 22;
};

/// A uniform scheme at one parameter value, q_i = sum_j a_{i - arity j} p_j, in double precision.
struct UniformRule {
  int arity = 2;
  /// Index of the first coefficient; the first and the last are not 0.
  int first_index = 0;
  std::vector<double> mask;
  /// The s with q_{s + arity j} = p_j, if the scheme is interpolatory.
  std::optional<int> interpolatory_index;

  int last_index() const { return first_index + static_cast<int>(mask.size()) - 1; }
  /// The greatest number of points that a new point depends on.
  int points() const;
};

/// \throws DomainError at a pole, or when the mask is zero or not finite there.
UniformRule approx_uniform_rule(const Mask& mask, std::span<const Rational> parameter_values);

/// A binary interpolatory 2n-point scheme over knots: the new point at (t_i + t_{i+1})/2 is sum_{j=1..2n} e_j
/// p_{i-n+j}.
struct NonuniformRule {
  /// 2n
  int points = 2;
  /// e_1 .. e_2n for the knots t_{i-n+1} .. t_{i+n}. It must not change under affine maps of the knots: it is called
  /// with knots that are shifted and scaled.
  std::function<std::vector<double>(std::span<const double> knots)> stencil;
};

NonuniformRule approx_nonuniform_rule(const InsertionRule& rule, std::span<const Rational> parameter_values);

/// A nonstationary scheme for one angle: the rules of its steps.
struct NonstationaryRule {
  std::vector<UniformRule> steps;
  /// Of EndRule::exact, see approx_continuation.
  std::vector<double> continuation;
};

/// The steps 0, .., levels - 1. mu is rounded to double precision, the mask is evaluated exactly there and then rounded.
/// \throws DomainError at a pole, or when a mask is zero or not finite.
NonstationaryRule approx_nonstationary_rule(const MaskSequence& sequence, AngleType type, const Rational& angle, int levels);

/// The weights w_1, .., w_n with u(-1) = sum_j w_j u(j-1) for all functions u of a space that is spanned by n functions y^j,
/// y^j cos(m theta y), y^j sin(..) or hyperbolic ones, and their shifts. For {1, y, cos, sin}: 2 + 2c, -2 - 4c, 2 + 2c, -1, c = cos
/// theta. Each plane of a cos with its sin is named by the cos alone or by both.
std::vector<double> approx_continuation(const std::vector<ExponentialFunction>& space, double angle);

/// The polygon after some levels, without knots. Old points of an interpolatory scheme are kept bit by bit; of a closed
/// polygon p_j becomes point j arity^levels. The polygon's own knots play no part.
/// \throws InputError when there are too few points: an open polygon needs as many as a stencil (and what shrinking
/// loses), a closed one 3. LimitError: too many points. Interrupted. DomainError when points leave the range of double
/// precision.
Polygon refine_polygon(const Polygon& polygon, const UniformRule& rule, const Refinement& refinement,
                       const Stop& stop = Stop());

/// The same with a rule for each step. \pre as many steps as levels
Polygon refine_polygon(const Polygon& polygon, const NonstationaryRule& rule, const Refinement& refinement,
                       const Stop& stop = Stop());

/// The same over the polygon's knots, which are refined by midpoints; the result has knots. Interval ratios are exact
/// at every level, since intervals are halved and never subtracted. \pre the polygon has knots
Polygon refine_polygon(const Polygon& polygon, const NonuniformRule& rule, const Refinement& refinement,
                       const Stop& stop = Stop());

}  // namespace limes
