#pragma once

#include "algebra/matrix/rational_matrix.hpp"
#include "algebra/stop.hpp"

#include <optional>
#include <vector>

namespace limes {

/// (A_e)_{ij} = a_{e+2j-i}, i, j = 0 .. N-1, for the binary mask a_0 .. a_N, its first and last coefficient not 0: what one step does to N
/// consecutive values, numbered downwards. \pre N >= 1, e = 0 or 1
RationalMatrix mask_section(const std::vector<Rational>& mask, int e);
/// A_{e_k} .. A_{e_1} for the word e_1 .. e_k.
RationalMatrix word_product(const std::vector<Rational>& mask, const std::vector<int>& word);

/// All t z with t >= 0 and lower <= z <= upper, 0 < lower < upper.
struct WeightCone {
  std::vector<Rational> lower, upper;
};

/// The points x_i / y_i of the projective scheme, x and y refined by the mask, when the weights y start as ones (docs/theory.md, theorem P1): the cone
/// contains the ones, every product of `level` sections maps it into its interior, and every `level` steps the oscillation of the
/// points in a window is multiplied by at most `factor` < 1; `norm` bounds the absolute row sums of what maps the points.
struct ProjectiveContraction {
  WeightCone cone;
  int level = 1;
  Rational factor;
  Rational norm;
};

/// Whether the cone and level prove contraction; all words of that length, in exact arithmetic.
std::optional<ProjectiveContraction> exact_contraction(const std::vector<Rational>& mask, const WeightCone& cone, int level, const Stop& stop);

/// Looks for a cone around the weights that the ones lead to and for a level from `first_level` to `max_level`, and proves what it found.
/// \pre mask.size() >= 3, first and last coefficient not 0
std::optional<ProjectiveContraction> find_projective_contraction(const std::vector<Rational>& mask, int first_level, int max_level,
                                                                 const Stop& stop);

}  // namespace limes
