#include "analysis/nonuniform/nelder_mead.hpp"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

/// a + t (b - a)
std::vector<double> on_line(const std::vector<double>& a, const std::vector<double>& b, double t) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + t * (b[i] - a[i]);
  return result;
}

constexpr double least_diameter = 1e-8;

/// The greatest distance of a coordinate from that of the best point.
double diameter(const std::vector<ApproxMinimum>& simplex) {
  double result = 0;
  for (const ApproxMinimum& corner : simplex) {
    for (std::size_t i = 0; i < corner.x.size(); ++i) result = std::max(result, std::abs(corner.x[i] - simplex.front().x[i]));
  }
  return result;
}

}  // namespace

ApproxMinimum approx_minimum(const std::function<double(std::span<const double>)>& f, std::vector<double> x, double step, int iterations) {
  const auto valued = [&](std::vector<double> at) {
    const double value = f(at);
    return ApproxMinimum{std::move(at), value};
  };
  std::vector<ApproxMinimum> simplex{valued(x)};
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<double> neighbour = x;
    neighbour[i] += step;
    simplex.push_back(valued(std::move(neighbour)));
  }
  const auto by_value = [](const ApproxMinimum& a, const ApproxMinimum& b) { return a.value < b.value; };
  std::stable_sort(simplex.begin(), simplex.end(), by_value);
  for (int k = 0; k < iterations && diameter(simplex) > least_diameter; ++k) {
    ApproxMinimum& worst = simplex.back();
    std::vector<double> centre(x.size(), 0);
    for (std::size_t i = 0; i + 1 < simplex.size(); ++i) {
      for (std::size_t j = 0; j < x.size(); ++j) centre[j] += simplex[i].x[j] / double(x.size());
    }
    const ApproxMinimum reflected = valued(on_line(centre, worst.x, -1));
    if (reflected.value < simplex.front().value) {
      const ApproxMinimum expanded = valued(on_line(centre, worst.x, -2));
      worst = expanded.value < reflected.value ? expanded : reflected;
    } else if (reflected.value < simplex[simplex.size() - 2].value) {
      worst = reflected;
    } else {
      const ApproxMinimum contracted = valued(on_line(centre, reflected.value < worst.value ? reflected.x : worst.x, 0.5));
      if (contracted.value < std::min(reflected.value, worst.value)) {
        worst = contracted;
      } else {
        for (std::size_t i = 1; i < simplex.size(); ++i) simplex[i] = valued(on_line(simplex.front().x, simplex[i].x, 0.5));
      }
    }
    std::stable_sort(simplex.begin(), simplex.end(), by_value);
  }
  return simplex.front();
}

}  // namespace limes
