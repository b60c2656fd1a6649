#pragma once

#include "schemes/nonuniform/insertion_rule.hpp"

#include <memory>
#include <span>
#include <vector>

namespace limes {

/// A floating look at what Theorem N1 needs for C^m, for a rule whose stencils are affine in its parameters: made once, then
/// quick for many parameter values. It finds candidates and proves nothing.
///
/// For each knot ratio gamma the subdivision matrix L acts on divided differences of order m+1 by a matrix M/2,
/// 2^{m+1} D L = M D with D the differences on the knots about the isolated ratio. The eigenvalues of M/2 are 2^m times those of L
/// besides 1, .., 2^{-m}. M is exact at the corners of the parameter space and rounded once, so that small ratios, at which L
/// is far too ill-conditioned, do no harm.
class SpectrumScreen {
 public:
  /// \param ratios the gamma > 0 to look at \param word_length of products of difference sections for equal intervals
  /// \throws DomainError when the stencil is not affine in the parameters, does not reproduce polynomials of degree m at all
  /// parameter values, or the mask lacks the factor (1+z)^{m+1}.
  SpectrumScreen(const InsertionRule& rule, int m, const std::vector<Rational>& ratios = default_ratios(), int word_length = 6);
  ~SpectrumScreen();

  /// 1, 3/4, 1/2, .., 2^-30.
  static std::vector<Rational> default_ratios();

  int parameters() const { return parameters_; }
  /// The ratios' spectral radii of M/2, then rho(product)^{1/length} for words of sections up to rotation and powers. A C^m
  /// scheme has all of them below 1. \pre x.size() == parameters()
  std::vector<double> approx_radii(std::span<const double> x) const;

 private:
  struct Matrices;
  int parameters_;
  std::unique_ptr<const Matrices> matrices_;
};

}  // namespace limes
