#include "analysis/spectral_radius/ellipse_hull_impl.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace limes {

EllipseCombination approx_ellipse_combination(const Eigen::MatrixXd& atoms, const Eigen::VectorXd& x, double enough, double tolerance) {
  constexpr int max_steps = 100;
  const Eigen::Index d = atoms.rows(), count = atoms.cols() / 2;
  EllipseCombination best{0, std::numeric_limits<double>::infinity(), {}};
  const Eigen::LLT<Eigen::MatrixXd> gram(atoms * atoms.transpose());
  if (gram.info() != Eigen::Success) return best;
  Eigen::VectorXd y = gram.solve(x);
  const auto products = [&](const Eigen::VectorXd& z) { return Eigen::VectorXd(atoms.transpose() * z); };
  const auto squares = [&](const Eigen::VectorXd& g) {
    return Eigen::ArrayXd(g.reshaped(2, count).colwise().squaredNorm().transpose());
  };
  Eigen::VectorXd g = products(y);
  const double greatest = std::sqrt(squares(g).maxCoeff());
  if (!(greatest > 0)) return best;
  y *= 0.7 / greatest;
  g *= 0.7 / greatest;
  best.lower = x.dot(y);
  double mu = std::max(best.lower, 1e-300) / double(count);
  Eigen::MatrixXd scaled(d, 2 * count), rank_one(d, count);
  for (int step = 0; step < max_steps; ++step) {
    const Eigen::ArrayXd slack = 1 - squares(g);
    const Eigen::ArrayXd weight = 2 / slack;  // times mu
    for (Eigen::Index j = 0; j < count; ++j) {
      scaled.middleCols(2 * j, 2) = atoms.middleCols(2 * j, 2) * std::sqrt(weight(j));
      rank_one.col(j) = atoms.middleCols(2 * j, 2) * g.segment(2 * j, 2) * weight(j);
    }
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(d, d);
    hessian.selfadjointView<Eigen::Lower>().rankUpdate(scaled).rankUpdate(rank_one);
    const Eigen::VectorXd gradient = x / mu - rank_one.rowwise().sum();
    const Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> root(hessian.selfadjointView<Eigen::Lower>());
    if (root.info() != Eigen::Success) return best;
    const Eigen::VectorXd direction = root.solve(gradient);
    const double decrement = std::sqrt(std::max(0.0, direction.dot(gradient)));
    const Eigen::VectorXd along = products(direction);
    // The Newton step's primal point: feasible whatever y is.
    double sum = 0;
    std::vector<Eigen::Vector2d> terms(static_cast<std::size_t>(count));
    for (Eigen::Index j = 0; j < count; ++j) {
      const Eigen::Vector2d own = g.segment<2>(2 * j), change = along.segment<2>(2 * j);
      terms[static_cast<std::size_t>(j)] = mu * weight(j) * (own + change + weight(j) * own.dot(change) * own);
      sum += terms[static_cast<std::size_t>(j)].norm();
    }
    if (sum < best.upper) {
      best.upper = sum;
      best.terms = std::move(terms);
    }
    // The longest step that stays inside.
    double length = 1;
    for (Eigen::Index j = 0; j < count; ++j) {
      const double a = along.segment<2>(2 * j).squaredNorm(), b = g.segment<2>(2 * j).dot(along.segment<2>(2 * j)), c = -slack(j);
      if (a == 0) continue;
      const double to_boundary = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
      length = std::min(length, 0.9 * to_boundary);
    }
    y += length * direction;
    g += length * along;
    best.lower = std::max(best.lower, x.dot(y));
    if (best.lower > enough || best.upper - best.lower <= tolerance * best.upper) return best;
    if (decrement < 1) mu *= 0.1;
    else if (length > 0.5) mu *= 0.5;
  }
  return best;
}

}  // namespace limes
