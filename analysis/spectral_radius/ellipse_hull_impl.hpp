// The gauge of a hull of ellipses by an interior-point method. Included by sources only.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace limes {

/// min sum |c_j| subject to sum A_j c_j = x, c_j in R^2, A_j = columns 2j, 2j+1 of `atoms`: the gauge of x for the hull of the ellipses A_j S^1.
struct EllipseCombination {
  double lower = 0, upper = 0;         // bounds of the least sum
  std::vector<Eigen::Vector2d> terms;  // c_j, of sum `upper`
};

/// Newton steps on the dual barrier x.y + mu sum log(1 - |A_j^T y|^2): each gives a point of both programs. It ends when the upper bound is
/// within `tolerance` of the lower one, relatively, or the lower bound is above `enough`. Infinity when x is not in the span. Floating: a hint.
EllipseCombination approx_ellipse_combination(const Eigen::MatrixXd& atoms, const Eigen::VectorXd& x, double enough, double tolerance);

}  // namespace limes
