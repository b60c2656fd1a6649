// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/polynomial.hpp"

#include <utility>

namespace limes::checker {

/// A product of powers of polynomials, each with leading coefficient 1 and not constant.
using Divisors = std::map<Polynomial, int>;

/// The rule of a 2n-point scheme, read: a tree of segments and points (docs/certificate.md, "Non-uniform schemes"), each linear in
/// the points p_i, or the weights as functions of the ratios of neighbouring intervals.
struct Rule {
  struct Node {
    enum class Kind { interpolant, map, join, again };
    Kind kind = Kind::map;
    bool is_point = false;
    int degree = 0, pieces = 1;  ///< pieces (degree + 1) coefficients; a point has one
    int order = 0, offset = 0;   ///< f(order, offset), join(order, ..)
    std::vector<int> arguments;  ///< earlier nodes
    /// map: coefficient i is sum of weight * coefficient over rows[i], divided by `divisors`; the coefficients of the
    /// arguments are numbered one argument after the other.
    std::vector<std::vector<std::pair<int, Polynomial>>> rows;
    Divisors divisors;
    int height = 1, again_depth = 0;
    int size() const { return pieces * (degree + 1); }
  };

  int points = 0;         ///< 2n
  std::size_t gamma = 0;  ///< the index of the variable after the parameters
  std::vector<Node> nodes;
  int root = -1;
  std::vector<Fraction> coefficients;  ///< instead: e_1 .. e_2n, variables: the parameters, then the 2n-2 ratios
  Divisors divisors;                   ///< everything in the parameters by which the rule divides
};

/// e_j = numerators[j-1] / denominator; variables: the parameters, then gamma.
struct Stencil {
  Polynomial denominator;
  std::vector<Polynomial> numerators;
};

using Definitions = std::vector<std::pair<std::string, std::string>>;

/// \throws Rejected at "scheme" (or "limits"): anything that is not of the form described in docs/certificate.md
Rule read_rule(const Definitions& definitions, std::string_view rule, const std::vector<std::string>& parameters,
               int points, Budget& budget);
Rule read_coefficients(const std::vector<std::string>& texts, const std::vector<std::string>& parameters,
                       Budget& budget);

/// The stencil E_k, k = 0..2n-1, of the new point between t_{k-n} and t_{k-n+1} for the knots t_j = j, j <= 0, and
/// gamma j, j >= 0. The denominator of E_0 contains all divisors in the parameters.
Stencil isolated_stencil(const Rule& rule, int k, Budget& budget);

}  // namespace limes::checker
