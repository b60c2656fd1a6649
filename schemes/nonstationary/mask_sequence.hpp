#pragma once

#include "algebra/polynomial/box.hpp"
#include "schemes/nonstationary/exponential_function.hpp"
#include "schemes/uniform/mask.hpp"

namespace limes {

/// The masks of a nonstationary scheme of arity p: step k = 0, 1, .. makes f^{k+1} = S_{a^(k)} f^k. The coefficients of a^(k)
/// are rational functions over Q of one number, the level parameter
///
///     mu_k = cos x_k  or  cosh x_k,  x_k = theta p^{-(k+1)},
///
/// where the angle theta >= 0 belongs to an edge of the first polygon. (So mu_{k+1} = sqrt((1 + mu_k)/2) when p = 2.) theta = 0
/// is the stationary, polynomial case mu = 1, and the limit of the masks for every theta. [Dyn & Levin 1995]
struct MaskSequence {
  struct Range {
    AngleType type;
    /// Where theta makes sense: within [0, 3 p] (trigonometric: then 0 <= x_k <= 3 < pi), within [0, 100 p] (hyperbolic).
    Interval angles;
  };

  std::string angle = "theta";
  std::string level_parameter = "mu";
  std::vector<Range> types;
  /// In one variable, mu.
  Mask mask;
  /// The masks of the steps 0, 1, .. that are not `mask`.
  std::vector<Mask> first_levels;
  /// The space that the mask was derived from (interpolation_mask); empty when the file gives the mask.
  std::vector<ExponentialFunction> interpolated;

  const Mask& at_level(int k) const;
  /// Nothing when the scheme has not this type.
  const Range* find(AngleType type) const;
};

/// The mask at mu = 1 among `variables` variables. \throws DomainError when it has a pole there
Mask limit_mask(const MaskSequence& sequence, int variables);

/// The mask of the binary interpolatory scheme whose new point in the middle of 2n points is the value there of their
/// interpolant from a 2n-dimensional space, in the variable mu; exactly, by solving for the weights over Q(mu). Nodes are at the
/// odd multiples of half an edge, and T_j(mu), U_j(mu) express cosines and sines. The space is given by a basis, as many even as
/// odd functions, each cos with its sin.
/// \throws InputError when the basis is not of this form, or does not determine the weights.
Mask interpolation_mask(const std::vector<ExponentialFunction>& basis);

/// T_n(x_0), n >= 0, in one variable: T_n(cos x) = cos(n x), T_n(cosh x) = cosh(n x).
MultivariatePolynomial chebyshev_t(int n);
/// U_n(x_0), n >= -1: U_n(cos x) sin x = sin((n+1) x), and with sinh.
MultivariatePolynomial chebyshev_u(int n);

}  // namespace limes
