// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/polynomial.hpp"

#include <nlohmann/json_fwd.hpp>

namespace limes::checker {

/// A polynomial in one variable, from the constant coefficient on; the last coefficient is not 0.
using Dense = std::vector<mpq_class>;

Dense dense(const Polynomial& p);
/// The size of the largest coefficient in machine words.
double size_of(const Dense& p);
Polynomial sparse(const Dense& p);
mpq_class value(const Dense& p, const mpq_class& x, Budget& budget);

/// a_{first_index + k} = numerators[k] / denominator, in mu.
struct LevelMask {
  int first_index = 0;
  std::vector<Dense> numerators;
  Dense denominator;
};

/// Step k = 0, 1, .. takes first_levels[k], from their number on `mask`, at mu_k = cos x_k (hyperbolic: cosh x_k),
/// x_k = theta p^{-(k+1)}.
struct Sequence {
  std::string name, angle;
  bool hyperbolic = false;
  int arity = 2;
  LevelMask mask;
  std::vector<LevelMask> first_levels;
  const LevelMask& at_level(int k) const {
    const auto level = static_cast<std::size_t>(k);
    return level < first_levels.size() ? first_levels[level] : mask;
  }
};

/// What certificates of theorems S1 and S2 have in common.
struct SequenceCertificate {
  Sequence sequence;
  std::string statement;
  Interval angles;  ///< of the claim
  bool certified = false;
};

/// \throws Rejected at "format", "scheme", "claim" or "limits"
SequenceCertificate read_sequence_certificate(const nlohmann::json& json, Budget& budget);
/// An interval of angles in the range where the type makes sense: 0 <= x_k <= 3, hyperbolic 0 <= x_k <= 100.
Interval read_angles(const std::string& text, const Sequence& sequence, const std::string& step, Budget& budget);

/// What contains cos or cosh of theta p^{-(k+1)} / divisor for the angles; mu_k when the divisor is 1. An end is 1 where theta =
/// 0, open where that is excluded.
Interval level_range(const Sequence& sequence, const Interval& angles, int k, int divisor, Budget& budget);
/// What contains mu_j for j >= k and the limit 1; not a point.
Interval tail_range(const Sequence& sequence, const Interval& angles, int k, Budget& budget);

/// Bernstein coefficients, up to factors that they have in common at each place, of polynomials in one multidegree on an
/// interval that is not a point. \returns one row per polynomial
std::vector<std::vector<mpz_class>> bernstein_rows(const std::vector<Dense>& polynomials, const Interval& range,
                                                   Budget& budget);
/// Whether a polynomial is proved to have no zero on an interval, by Bernstein coefficients and bisection.
bool has_strict_sign(const Dense& p, const Interval& range, Budget& budget);

/// Every mask is defined at every angle: the steps before `level` one by one, the others at once. \throws Rejected at
/// "denominator"; at "proof" when a first level is not below `level`
void require_defined(const Sequence& sequence, const Interval& angles, int level, Budget& budget);

/// "unified-curve (trigonometric) ... for theta in [0, 3]"
std::string shown(const Sequence& sequence);
std::string shown_angles(const Sequence& sequence, const Interval& angles);

}  // namespace limes::checker
